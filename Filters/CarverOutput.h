// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the core's results to the data objects of vtkTopologyCarver's output ports.
 */
#ifndef CarverOutput_h
#define CarverOutput_h

#include "Carver.h"
#include "Classification.h"
#include "Mesh.h"
#include "Profile.h"
#include "vtkNew.h"
#include "vtkPointData.h" // for a vtkNew member
#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/** All that is known of one carved mesh. */
struct CarvedMesh
{
  explicit CarvedMesh(const carving::Tetrahedralization& mesh)
    : Mesh(mesh)
  {
  }

  const carving::Tetrahedralization& Mesh;
  carving::Classification Regions;
  carving::Stream Stream;
  carving::Profile Profile;
  /** Per step: the smallest priority that has been popped so far; infinite at step 0. */
  std::vector<double> FeatureSizes;
};

/** Writes levels, stream and profile of a carved mesh; vtkTopologyCarver documents the arrays. */
class CarverOutput
{
public:
  /** `cellIds` has the cell of `input` for every triangle that the helper program was given. */
  CarverOutput(const CarvedMesh& carved, vtkPolyData* input, const std::vector<vtkIdType>& cellIds);

  void FillLevel(int step, vtkPolyData* level) const;
  void FillStream(vtkUnstructuredGrid* stream) const;
  void FillProfile(vtkTable* profile) const;

private:
  /** The cell of the input that a triangle of M is (a part of). */
  vtkIdType GetOriginalCell(int triangle) const;
  /** Interpolates the input's point data at points that resolving or TetGen made. */
  void InterpolateNewPoints();

  const CarvedMesh& Carved;
  vtkPolyData* Input;
  const std::vector<vtkIdType>& CellIds;
  vtkNew<vtkPointData> PointData; ///< of all points of the tetrahedralization
};

#endif
