// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polygons as triangles.
 */
#ifndef PolygonCutter_h
#define PolygonCutter_h

#include "Core/Mesh/Mesh.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <vector>

/**
 * Cuts polygons into triangles: into those of vtkTriangleFilter, which users expect, unless those
 * of vtkContourTriangulator overlap less. The latter handles holes, and takes less time for
 * polygons of very many corners. The two differ where corners are not in one plane.
 */
class PolygonCutter
{
public:
  explicit PolygonCutter(vtkPoints* points)
    : Points(points)
  {
  }

  /**
   * Returns triangles for the whole polygon. If there is no proper triangulation, ears are cut off,
   * as vtkTriangleFilter does, and the rest becomes a fan.
   */
  vtkCellArray* Cut(vtkIdType size, const vtkIdType* corners);

  /** The number of polygons that have no triangulation without overlaps. */
  vtkIdType GetNumberOfFans() const
  {
    return this->NumberOfFans;
  }

private:
  void TakeDistinct(vtkIdType size, const vtkIdType* corners);
  void CutEars();
  void AddEar(vtkIdType i, vtkIdType j, vtkIdType k);
  bool AreEarsAsGood() const;
  bool DoEarsOverlap() const;
  carving::Point FindNormal() const;
  carving::Point FindNormal(vtkIdType a, vtkIdType b, vtkIdType c) const;
  double MeasureAlong(const carving::Point& normal, vtkCellArray* triangles) const;
  carving::Point GetPoint(vtkIdType id) const;

  vtkPoints* Points;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkCellArray> Triangles; ///< by vtkContourTriangulator
  vtkNew<vtkCellArray> Ears;      ///< by vtkPolygon
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> PlacesOfEars; ///< in the polygon, three each
  std::vector<vtkIdType> Left;    ///< places of the corners that are left without the ears
  vtkIdType NumberOfFans = 0;
};

#endif
