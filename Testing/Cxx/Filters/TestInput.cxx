// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Vector.h"
#include "InputTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourCarver.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using carving::operator+;
using carving::operator*;
using carving::Point;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::string ErrorOf(vtkDataObject* input)
{
  vtkNew<vtkTopologyCarver> carver;
  return CarveWithError(carver, input);
}

/** Two boxes; the time is the width of their gap. */
class MovingBoxes : public vtkPolyDataAlgorithm
{
public:
  static MovingBoxes* New();
  vtkTypeMacro(MovingBoxes, vtkPolyDataAlgorithm);

protected:
  MovingBoxes()
  {
    this->SetNumberOfInputPorts(0);
  }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    const double times[] = { 1.0, 2.5 };
    vtkInformation* info = out->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 2);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    const double time =
      out->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    vtkPolyData* output = vtkPolyData::GetData(out);
    output->ShallowCopy(ToPolyData(models::Joined(
      models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 1 + time, 0, 0 }, { 2 + time, 1, 1 }))));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};
vtkStandardNewMacro(MovingBoxes);

} // namespace

// Hidden cells and ghost cells are ignored, whatever their points.
TEST(Input, SkipsHiddenCells)
{
  auto input = TwoBoxes();
  const int types[] = { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL };
  SetGhosts(input, [&](vtkIdType i) { return i < 12 ? 0 : types[i % 2]; });
  input->GetPoints()->SetPoint(12, NaN, 0, 0);
  const auto carver = Carve(input);
  EXPECT_EQ(LastLevel(carver)->GetNumberOfPolys(), 12);
  EXPECT_EQ(LastLevel(carver)->GetBounds()[1], 1.0);
}

// Data that are not polygonal are an error that names Extract Surface.
TEST(Input, NamesExtractSurfaceForGrids)
{
  vtkNew<vtkImageData> image;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkTable> table;
  vtkNew<vtkTopologyCarver> carver;
  vtkNew<vtkContourCarver> contourCarver;
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ image, grid, table })
  {
    for (vtkCarverAlgorithm* filter :
      std::initializer_list<vtkCarverAlgorithm*>{ carver, contourCarver })
    {
      const std::string error = CarveWithError(filter, input);
      EXPECT_TRUE(Has(error, input->GetClassName()));
      EXPECT_TRUE(Has(error, "Extract Surface"));
    }
  }
  // The same filter then takes polygons.
  Carve(carver, TwoBoxes());
  EXPECT_GT(CountLevels(carver), 1);
}

// An input that changes with time is carved for the requested time, and its times pass through.
TEST(Input, IsCarvedForTheTimeAskedFor)
{
  vtkNew<MovingBoxes> source;
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputConnection(source->GetOutputPort());
  carver->UpdateInformation();
  for (int port = 0; port < 3; ++port)
  {
    vtkInformation* info = carver->GetOutputInformation(port);
    ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 2);
    EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[1], 2.5);
  }
  for (const double time : { 1.0, 2.5, 1.0 })
  {
    carver->UpdateTimeStep(time);
    EXPECT_DOUBLE_EQ(GetVolume(GetLevel(carver, 0)), 2.0 + time);
    EXPECT_DOUBLE_EQ(GetVolume(LastLevel(carver)), 2.0);
  }
}

// Arrays of every type are passed on to every level, also to new points.
TEST(Input, CarriesArraysOfEveryType)
{
  auto input = TwoBoxes();
  std::vector<int> types;
  for (const int type : { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE, VTK_STRING, VTK_VARIANT })
  {
    types.push_back(type);
    for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      vtkSmartPointer<vtkAbstractArray> own;
      own.TakeReference(vtkAbstractArray::CreateArray(type));
      own->SetName(("type " + std::to_string(type)).c_str());
      const vtkIdType count = input->GetNumberOfElements(kind);
      own->SetNumberOfTuples(count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        own->SetVariantValue(i, vtkVariant(static_cast<int>(i % 2)));
      }
      input->GetAttributes(kind)->AddArray(own);
    }
  }
  vtkNew<vtkTopologyCarver> carver;
  Messages messages(carver);
  carver->SetInitialApproximation(vtkTopologyCarver::BOUNDING_BOX);
  Carve(carver, input);
  EXPECT_TRUE(messages.Errors.empty());
  for (int l = 0; l < CountLevels(carver); ++l)
  {
    vtkPolyData* level = GetLevel(carver, l);
    for (const int type : types)
    {
      const std::string name = "type " + std::to_string(type);
      for (const auto& [kind, idName] : { std::pair(vtkDataObject::POINT, "vtkOriginalPointIds"),
             std::pair(vtkDataObject::CELL, "vtkOriginalCellIds") })
      {
        vtkDataSetAttributes* data = level->GetAttributes(kind);
        vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
        ASSERT_NE(array, nullptr) << name;
        ASSERT_EQ(array->GetDataType(), type);
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          const int id = data->GetArray(idName)->GetVariantValue(i).ToInt();
          if (id >= 0)
          {
            // A bit array's own variant values are all zero.
            auto* numbers = vtkDataArray::SafeDownCast(array);
            ASSERT_EQ(numbers ? numbers->GetTuple1(i) : array->GetVariantValue(i).ToInt(), id % 2)
              << name;
          }
        }
      }
    }
  }
}

// A level can be carved again, whatever the names of its arrays.
TEST(Input, MayBeALevel)
{
  const auto first = Carve(ToPolyData(models::Joined(
    models::Torus(1.0, 0.3, 9, 6), models::Moved(models::Sphere(1), { 0.3, 0.4, 1.0 }))));
  vtkPolyData* level = LastLevel(first);
  const auto second = Carve(level);
  EXPECT_EQ(GetTriangles(LastLevel(second)), GetTriangles(level));
  vtkCellData* data = LastLevel(second)->GetCellData();
  std::set<double> ids;
  for (vtkIdType i = 0; i < level->GetNumberOfCells(); ++i)
  {
    ids.insert(data->GetArray("vtkOriginalCellIds")->GetTuple1(i));
    EXPECT_TRUE(std::isnan(data->GetArray("Priority")->GetTuple1(i)));
  }
  EXPECT_EQ(ids.size(), static_cast<std::size_t>(level->GetNumberOfCells()));
}

// Coordinates in single precision become the same numbers in double precision.
TEST(Input, MayBeInSinglePrecision)
{
  auto input = ToPolyData(models::Torus(1.0, 0.3, 9, 6));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(input->GetPoints());
  ASSERT_EQ(points->GetDataType(), VTK_FLOAT);
  input->SetPoints(points);
  const auto carver = Carve(input);
  EXPECT_EQ(LastLevel(carver)->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(GetTriangles(LastLevel(carver)), GetTriangles(input));
}

// A mesh of any size, at any distance from the origin, is carved.
TEST(Input, MayBeOfAnySizeAndPlace)
{
  const auto torus = models::Torus(1.0, 0.3, 9, 6);
  const std::pair<double, Point> cases[] = { { 1, { 1e8, 2e8, -1e8 } }, { 1e-9, { 0, 0, 0 } },
    { 1e-9, { 1, 1, 1 } }, { 1e8, { 0, 0, 0 } } };
  for (const auto& [scale, place] : cases)
  {
    auto input = ToPolyData(models::Moved(torus, place, scale));
    const auto carver = Carve(input);
    ASSERT_EQ(CountLevels(carver), 8) << scale;
    EXPECT_EQ(GetTriangles(LastLevel(carver)), GetTriangles(input)) << scale;
    const auto boxes = QuadBoxes([s = scale, p = place](const Point& q) { return s * q + p; });
    EXPECT_EQ(LastLevel(Carve(boxes))->GetNumberOfPolys(), 24) << scale;
  }
}

// Coordinates whose products overflow or vanish are an error that advises scaling.
TEST(Input, MustNotOverflow)
{
  const auto scaled = [](double s) { return QuadBoxes([s](const Point& p) { return s * p; }); };
  EXPECT_TRUE(Has(ErrorOf(scaled(1e100)), "Point 1 is (1e+100, 0, 0)"));
  EXPECT_TRUE(Has(ErrorOf(scaled(1e-100)), "Scale the input"));
}

// One triangle has a hull without volume, which is an error that advises a box; with a box it is
// carved.
TEST(Input, MayBeOneTriangleInABox)
{
  auto input = MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  const std::string error = ErrorOf(input);
  EXPECT_TRUE(Has(error, "no volume"));
  EXPECT_TRUE(Has(error, "vtkContourCarver"));
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInitialApproximation(vtkTopologyCarver::BOUNDING_BOX);
  Carve(carver, input);
  EXPECT_EQ(GetTriangles(LastLevel(carver)), GetTriangles(input));
}

// If several points are not finite, the error names the first point, in any order of the cells.
TEST(Input, NamesTheFirstPointThatIsNotFinite)
{
  auto input = QuadBoxes();
  input->GetPoints()->SetPoint(15, 0, NaN, 0);
  input->GetPoints()->SetPoint(4, 0, 0, HUGE_VAL);
  input->GetPolys()->ReplaceCellAtId(0, { 8, 10, 15, 9 });
  EXPECT_TRUE(Has(ErrorOf(input), "Point 4 is (0, 0, inf)"));
}

// A cell with a point that does not exist is an error that names both, in space and in the plane.
TEST(Input, NamesACellWithAnUnknownPoint)
{
  for (const vtkIdType unknown : { -1, 16 })
  {
    auto input = QuadBoxes();
    input->GetPolys()->InsertNextCell({ 0, 1, unknown });
    vtkNew<vtkTopologyCarver> carver;
    vtkNew<vtkContourCarver> contourCarver;
    for (vtkCarverAlgorithm* filter :
      std::initializer_list<vtkCarverAlgorithm*>{ carver, contourCarver })
    {
      EXPECT_TRUE(
        Has(CarveWithError(filter, input), "Cell 12 has the point " + std::to_string(unknown)));
    }
  }
}

// Offsets that do not divide the array of corners, as a broken file has them, are an error.
TEST(Input, RefusesOffsetsThatDoNotFit)
{
  for (const std::vector<vtkIdType>& numbers :
    { std::vector<vtkIdType>{ 1, 3, 6 }, { 0, 4, 3, 6 }, { 0, 3, 9 }, { 0, 3 }, { 0, -3, 6 } })
  {
    vtkNew<vtkIdTypeArray> offsets, corners;
    for (const vtkIdType number : numbers)
    {
      offsets->InsertNextValue(number);
    }
    for (const vtkIdType corner : { 0, 1, 2, 2, 1, 3 })
    {
      corners->InsertNextValue(corner);
    }
    auto input = QuadBoxes();
    input->GetPolys()->SetData(offsets, corners);
    vtkNew<vtkTopologyCarver> carver;
    vtkNew<vtkContourCarver> contourCarver;
    for (vtkCarverAlgorithm* filter :
      std::initializer_list<vtkCarverAlgorithm*>{ carver, contourCarver })
    {
      EXPECT_TRUE(Has(CarveWithError(filter, input), "offsets"));
    }
  }
}

// Points, vertices and lines alone give no level and no error, but a note on the cells.
TEST(Input, MayHaveNoTriangle)
{
  auto input = TwoBoxes();
  input->SetPolys(nullptr);
  EXPECT_EQ(Carve(input)->GetOutput()->GetNumberOfBlocks(), 0u);
  vtkNew<vtkCellArray> verts, lines;
  verts->InsertNextCell({ 1 });
  lines->InsertNextCell({ 2, 3, 4 });
  input->SetVerts(verts);
  input->SetLines(lines);
  const auto carver = Carve(input);
  EXPECT_EQ(CountLevels(carver), 0);
  EXPECT_TRUE(Has(GetNotes(carver), "2 cells were ignored"));
}
