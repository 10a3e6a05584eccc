// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/CarverInput.h"

#include "Convert/InputCells.h"
#include "Core/Mesh/LargePages.h"
#include "vtkContourTriangulator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <numeric>

namespace
{

/** Cuts polygons into triangles. */
class PolygonCutter
{
public:
  explicit PolygonCutter(vtkPoints* points)
    : Points(points)
  {
  }

  /**
   * Returns triangles for the whole polygon. If the polygon has no proper triangulation, its ears
   * are cut off, as vtkTriangleFilter does, and the rest becomes a fan.
   */
  vtkCellArray* Cut(vtkIdType size, const vtkIdType* corners)
  {
    this->Triangles->Reset();
    this->TakeDistinct(size, corners);
    const vtkIdType count = this->Corners->GetNumberOfIds();
    if (count > 3)
    {
      vtkContourTriangulator::TriangulatePolygon(this->Corners, this->Points, this->Triangles);
    }
    if (this->Triangles->GetNumberOfCells() != count - 2 && count > 2)
    {
      this->NumberOfFans += count > 3;
      this->Triangles->Reset();
      if (count > 3 && count <= MostForEars)
      {
        this->CutEars();
      }
      for (vtkIdType i = 2; i < this->Corners->GetNumberOfIds(); ++i)
      {
        this->AddTriangle(0, i - 1, i);
      }
    }
    return this->Triangles;
  }

  vtkIdType GetNumberOfFans() const
  {
    return this->NumberOfFans;
  }

private:
  /** To cut ears can take cubic time. */
  static constexpr vtkIdType MostForEars = 300;

  /** Takes all corners, except those that coincide with the corner before. */
  void TakeDistinct(vtkIdType size, const vtkIdType* corners)
  {
    this->Corners->Reset();
    for (vtkIdType i = 0; i < size; ++i)
    {
      double p[3], before[3];
      this->Points->GetPoint(corners[i], p);
      this->Points->GetPoint(corners[i > 0 ? i - 1 : size - 1], before);
      if (!std::equal(p, p + 3, before))
      {
        this->Corners->InsertNextId(corners[i]);
      }
    }
  }

  /** Adds the triangles that vtkPolygon finds, and keeps the corners that are left. */
  void CutEars()
  {
    const vtkIdType count = this->Corners->GetNumberOfIds();
    vtkNew<vtkPolygon> polygon;
    polygon->Initialize(static_cast<int>(count), this->Corners->GetPointer(0), this->Points);
    vtkNew<vtkIdList> ears; // three places in the polygon each
    polygon->Triangulate(ears);
    std::vector<vtkIdType> left(count); // places
    std::iota(left.begin(), left.end(), 0);
    for (vtkIdType ear = 0; ear + 2 < ears->GetNumberOfIds(); ear += 3)
    {
      const vtkIdType* const places = ears->GetPointer(ear);
      const auto size = static_cast<vtkIdType>(left.size());
      const auto isOfEar = [&](vtkIdType i)
      { return std::find(places, places + 3, left[(i + size) % size]) != places + 3; };
      vtkIdType tip = 0;
      while (tip < size && !(isOfEar(tip - 1) && isOfEar(tip) && isOfEar(tip + 1)))
      {
        ++tip;
      }
      if (size < 3 || tip == size)
      {
        break; // not an ear of what is left
      }
      const vtkIdType before = left[(tip + size - 1) % size], after = left[(tip + 1) % size];
      this->AddTriangle(before, left[tip], after);
      left.erase(left.begin() + tip);
    }
    this->Keep(left);
  }

  void Keep(const std::vector<vtkIdType>& places)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->Corners->SetId(static_cast<vtkIdType>(i), this->Corners->GetId(places[i]));
    }
    this->Corners->SetNumberOfIds(static_cast<vtkIdType>(places.size()));
  }

  void AddTriangle(vtkIdType i, vtkIdType j, vtkIdType k)
  {
    this->Triangles->InsertNextCell(
      { this->Corners->GetId(i), this->Corners->GetId(j), this->Corners->GetId(k) });
  }

  vtkPoints* Points;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkCellArray> Triangles;
  vtkIdType NumberOfFans = 0;
};

} // namespace

std::string CarverInput::Gather(vtkPolyData* input)
{
  *this = {};
  const std::string error = CheckCells(input, { input->GetPolys(), input->GetStrips() });
  if (!error.empty())
  {
    return error;
  }
  if (input->GetNumberOfVerts() > 0 || input->GetNumberOfLines() > 0)
  {
    this->Notes.push_back("Vertices and lines bound no volume: " +
      std::to_string(input->GetNumberOfVerts() + input->GetNumberOfLines()) +
      " cells were ignored.");
  }
  if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
  {
    return {};
  }
  this->Mesh.Points = carving::MakeLarge<carving::Point>(input->GetNumberOfPoints());
  carving::ReserveLarge(this->Mesh.Triangles, input->GetNumberOfPolys()); // at least
  carving::ReserveLarge(this->CellIds, input->GetNumberOfPolys());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, this->Mesh.Points[i].data());
  }
  this->AddPolygons(input);
  this->AddStrips(input);
  return {};
}

void CarverInput::AddPolygons(vtkPolyData* input)
{
  PolygonCutter cutter(input->GetPoints());
  VisitCells(input, { input->GetPolys() },
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    { this->AddTriangles(cell, cutter.Cut(size, corners)); });
  if (cutter.GetNumberOfFans() > 0)
  {
    this->Notes.push_back(std::to_string(cutter.GetNumberOfFans()) +
      " polygons cross themselves or have no area: they were cut into fans of triangles.");
  }
}

void CarverInput::AddStrips(vtkPolyData* input)
{
  vtkNew<vtkCellArray> triangles;
  VisitCells(input, { input->GetStrips() },
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      triangles->Reset();
      vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), corners, triangles);
      this->AddTriangles(cell, triangles);
    });
}

void CarverInput::AddTriangles(vtkIdType cell, vtkCellArray* triangles)
{
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* corners;
    triangles->GetCellAtId(i, size, corners);
    this->Mesh.Triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
    this->CellIds.push_back(cell);
  }
}
