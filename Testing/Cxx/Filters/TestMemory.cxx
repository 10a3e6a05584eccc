// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationLimit.h"
#include "FilterTesting.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace
{

/** During its lifetime, the machine seems to have so many KiB of memory. */
class MemoryOfMachine
{
public:
  explicit MemoryOfMachine(const char* kibibytes)
  {
    setenv("PV_HOST_MEMORY_LIMIT", kibibytes, 1);
  }
  ~MemoryOfMachine()
  {
    unsetenv("PV_HOST_MEMORY_LIMIT");
  }
};

} // namespace

// A mesh that needs more memory than the machine has is refused, with the need and what to do.
TEST(Memory, IsCheckedBeforehand)
{
  const MemoryOfMachine machine("50");
  vtkNew<vtkTopologyCarver> carver;
  const std::string error = CarveWithError(carver, TwoBoxes());
  EXPECT_TRUE(Has(error,
    "The mesh has 16 vertices and 24 triangles: the helper program would need "
    "about 0 MiB"));
  EXPECT_TRUE(Has(error, "Decimate the mesh first"));
}

// A user who sets a limit may try any mesh.
TEST(Memory, IsNotCheckedWithALimit)
{
  const MemoryOfMachine machine("50");
  vtkNew<vtkTopologyCarver> carver;
  carver->SetMemoryLimit(1e8); // sanitizers reserve terabytes of addresses
  Carve(carver, TwoBoxes());
  EXPECT_GT(CountLevels(carver), 0);
}

// Points that are given once per triangle count once.
TEST(Memory, IsNeededForDistinctPoints)
{
  const MemoryOfMachine machine("100"); // enough for 16 vertices, not for 72
  auto soup =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }));
  carving::TriangleMesh repeated;
  for (const carving::Triangle& triangle : soup.Triangles)
  {
    const int first = static_cast<int>(repeated.Points.size());
    for (const int corner : triangle)
    {
      repeated.Points.push_back(soup.Points[corner]);
    }
    repeated.Triangles.push_back({ first, first + 1, first + 2 });
  }
  soup.Points.resize(72, { NAN, 0.0, 0.0 }); // unused ones
  for (const carving::TriangleMesh& mesh : { repeated, soup })
  {
    vtkNew<vtkTopologyCarver> carver;
    Carve(carver, ToPolyData(mesh));
    EXPECT_GT(CountLevels(carver), 0);
  }
}

// Where there is no memory for the reply, that is an error, and the program lives.
TEST(Memory, MayBeTooShortForTheReply)
{
  vtkNew<vtkTopologyCarver> carver;
  const vtkSmartPointer<vtkPolyData> sphere = ToPolyData(models::Sphere(4));
  {
    const AllocationLimit limit(100000); // bytes: enough for the mesh, not for its tetrahedra
    EXPECT_TRUE(Has(CarveWithError(carver, sphere), "There is not enough memory for the reply"));
  }
  carver->Modified();
  Carve(carver, sphere);
  EXPECT_GT(CountLevels(carver), 0);
}

// Memory that runs out later, while the mesh is carved, is an error, too.
TEST(Memory, MayBeTooShortForTheLevels)
{
  struct Shortage
  {
    void Begin()
    {
      const char* stage = this->Carver->GetProgressText();
      if (stage && std::string(stage) == "carve" && !this->Limit)
      {
        this->Limit.emplace(5000); // bytes: enough for messages, not for the arrays of a level
      }
    }
    vtkNew<vtkTopologyCarver> Carver;
    std::optional<AllocationLimit> Limit;
  } shortage;
  vtkTopologyCarver* carver = shortage.Carver;
  const vtkSmartPointer<vtkPolyData> torus = ToPolyData(models::Torus(1.0, 0.4, 20, 10));
  Messages messages(carver);
  const auto observer = carver->AddObserver(vtkCommand::ProgressEvent, &shortage, &Shortage::Begin);
  Carve(carver, torus);
  ASSERT_TRUE(shortage.Limit);
  shortage.Limit.reset();
  carver->RemoveObserver(observer);
  ASSERT_EQ(messages.Errors.size(), 1u);
  EXPECT_TRUE(Has(messages.Errors[0], "There is not enough memory for the result"));
  EXPECT_EQ(CountLevels(carver), 0);
  carver->Modified();
  Carve(carver, torus);
  EXPECT_GT(CountLevels(carver), 0);
}
