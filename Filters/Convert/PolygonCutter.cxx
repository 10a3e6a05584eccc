// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/PolygonCutter.h"

#include "Core/Mesh/Vector.h"
#include "vtkContourTriangulator.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

using carving::operator+;
using carving::operator-;
using carving::operator/;

/** Cutting ears can take cubic time. */
constexpr vtkIdType MostCornersForEars = 300;

} // namespace

vtkCellArray* PolygonCutter::Cut(vtkIdType size, const vtkIdType* corners)
{
  this->TakeDistinct(size, corners);
  this->Triangles->Reset();
  this->Ears->Reset();
  const vtkIdType count = this->Corners->GetNumberOfIds();
  this->Left.resize(count);
  std::iota(this->Left.begin(), this->Left.end(), 0);
  bool isProper = true;
  if (count > 3)
  {
    vtkContourTriangulator::TriangulatePolygon(this->Corners, this->Points, this->Triangles);
    isProper = this->Triangles->GetNumberOfCells() == count - 2;
    if (count <= MostCornersForEars)
    {
      this->CutEars();
    }
    if (isProper && !this->AreEarsAsGood())
    {
      return this->Triangles;
    }
  }
  for (std::size_t i = 2; i < this->Left.size(); ++i)
  {
    this->AddEar(this->Left[0], this->Left[i - 1], this->Left[i]);
  }
  this->NumberOfFans += !isProper && this->DoEarsOverlap();
  return this->Ears;
}

/** Takes all corners, except those that coincide with the corner before. */
void PolygonCutter::TakeDistinct(vtkIdType size, const vtkIdType* corners)
{
  this->Corners->Reset();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (this->GetPoint(corners[i]) != this->GetPoint(corners[i > 0 ? i - 1 : size - 1]))
    {
      this->Corners->InsertNextId(corners[i]);
    }
  }
}

/** Takes the triangles that vtkPolygon finds as ears, until one is no ear of what is left. */
void PolygonCutter::CutEars()
{
  this->Polygon->Initialize(
    static_cast<int>(this->Corners->GetNumberOfIds()), this->Corners->GetPointer(0), this->Points);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617)
  this->Polygon->TriangulateLocalIds(0, this->PlacesOfEars);
#else
  this->Polygon->Triangulate(this->PlacesOfEars);
#endif
  for (vtkIdType ear = 0; ear + 2 < this->PlacesOfEars->GetNumberOfIds(); ear += 3)
  {
    const vtkIdType* const places = this->PlacesOfEars->GetPointer(ear);
    const std::size_t size = this->Left.size();
    const auto isOfEar = [&](std::size_t i)
    { return std::find(places, places + 3, this->Left[i % size]) != places + 3; };
    std::size_t before = 0;
    while (before < size && !(isOfEar(before) && isOfEar(before + 1) && isOfEar(before + 2)))
    {
      ++before;
    }
    if (size < 3 || before == size)
    {
      return;
    }
    const std::size_t tip = (before + 1) % size;
    this->AddEar(this->Left[before], this->Left[tip], this->Left[(before + 2) % size]);
    this->Left.erase(this->Left.begin() + static_cast<std::ptrdiff_t>(tip));
  }
}

/** Adds the triangle between three places in the polygon. */
void PolygonCutter::AddEar(vtkIdType i, vtkIdType j, vtkIdType k)
{
  this->Ears->InsertNextCell(
    { this->Corners->GetId(i), this->Corners->GetId(j), this->Corners->GetId(k) });
}

/** Whether the ears are the whole polygon and overlap no more than the other triangles. */
bool PolygonCutter::AreEarsAsGood() const
{
  constexpr double withRoundings = 1.0 + 1e-9;
  if (this->Left.size() > 2)
  {
    return false;
  }
  const carving::Point normal = this->FindNormal();
  return this->MeasureAlong(normal, this->Ears) <=
    withRoundings * this->MeasureAlong(normal, this->Triangles);
}

/** Whether there is no area, or more than that of a polygon that does not cross itself. */
bool PolygonCutter::DoEarsOverlap() const
{
  constexpr double withRoundings = 1.0 + 1e-6;
  const carving::Point normal = this->FindNormal();
  const double area = carving::Length(normal);
  return area == 0.0 || this->MeasureAlong(normal, this->Ears) > withRoundings * area;
}

/** The normal of the polygon, with twice its area as the length. */
carving::Point PolygonCutter::FindNormal() const
{
  carving::Point normal = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 2; i < this->Corners->GetNumberOfIds(); ++i)
  {
    normal = normal +
      this->FindNormal(
        this->Corners->GetId(0), this->Corners->GetId(i - 1), this->Corners->GetId(i));
  }
  return normal;
}

/** The normal of a triangle, with twice its area as the length. */
carving::Point PolygonCutter::FindNormal(vtkIdType a, vtkIdType b, vtkIdType c) const
{
  const carving::Point corner = this->GetPoint(a);
  return carving::Cross(this->GetPoint(b) - corner, this->GetPoint(c) - corner);
}

/**
 * Twice the sum of the triangles' areas as seen along the polygon's normal: the least possible,
 * unless triangles overlap.
 */
double PolygonCutter::MeasureAlong(const carving::Point& normal, vtkCellArray* triangles) const
{
  const double length = carving::Length(normal);
  const carving::Point direction = length > 0.0 ? normal / length : normal;
  double sum = 0.0;
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* corners;
    triangles->GetCellAtId(i, size, corners);
    sum += std::abs(carving::Dot(this->FindNormal(corners[0], corners[1], corners[2]), direction));
  }
  return sum;
}

carving::Point PolygonCutter::GetPoint(vtkIdType id) const
{
  carving::Point point;
  this->Points->GetPoint(id, point.data());
  return point;
}
