// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractCarvedLOD.h"

#include "LevelOutput.h"
#include "LevelSelection.h"
#include "StreamInput.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <list>

namespace
{

/** A stream that has been read from a grid. */
struct Prepared
{
  vtkWeakPointer<vtkUnstructuredGrid> Grid;
  vtkMTimeType Time = 0;
  std::string Error;
  carving::Profile Profile;
  // One of them, by the stream's dimension.
  carving::StoredStream<3> Space;
  carving::StoredStream<2> Plane;
};

} // namespace

/** The streams of all inputs that are alive: a composite has many. */
class vtkExtractCarvedLOD::Internals
{
public:
  Prepared& Get(vtkUnstructuredGrid* grid)
  {
    this->All.remove_if([](const Prepared& stream)
      { return !stream.Grid || stream.Grid->GetMTime() != stream.Time; });
    const auto found = std::find_if(this->All.begin(), this->All.end(),
      [grid](const Prepared& stream) { return stream.Grid == grid; });
    if (found != this->All.end())
    {
      return *found;
    }
    Prepared& stream = this->All.emplace_back();
    stream.Grid = grid;
    stream.Time = grid->GetMTime();
    stream.Error = GetStreamDimension(grid) == 2 ? ReadStream(grid, stream.Plane, stream.Profile)
                                                 : ReadStream(grid, stream.Space, stream.Profile);
    return stream;
  }

private:
  std::list<Prepared> All;
};

vtkStandardNewMacro(vtkExtractCarvedLOD);

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::vtkExtractCarvedLOD()
  : Streams(new Internals)
{
}

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::~vtkExtractCarvedLOD() = default;

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::SetLevelTargetType(int type)
{
  const int known = static_cast<int>(carving::ToLevelTarget(type));
  if (this->LevelTargetType != known)
  {
    this->LevelTargetType = known;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  auto* grid = vtkUnstructuredGrid::GetData(in[0]);
  auto* output = vtkPolyData::GetData(out);
  output->GetFieldData()->Initialize(); // the pipeline has passed the stream's
  if (grid->GetNumberOfCells() == 0)
  {
    return 1; // the stream of nothing
  }
  const Prepared& stream = this->Streams->Get(grid);
  if (!stream.Error.empty())
  {
    vtkErrorMacro(<< stream.Error);
    return 0;
  }
  const carving::SelectedStep selected = carving::SelectStep(
    stream.Profile, carving::ToLevelTarget(this->LevelTargetType), this->LevelTarget);
  if (!selected.Problem.empty())
  {
    vtkWarningMacro(<< selected.Problem);
  }
  if (GetStreamDimension(grid) == 2)
  {
    FillLevel(stream.Plane, stream.Profile, grid, selected.Step, this->ManifoldOutput, output);
  }
  else
  {
    FillLevel(stream.Space, stream.Profile, grid, selected.Step, this->ManifoldOutput, output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelTargetType: "
     << carving::LevelTargetName(static_cast<carving::LevelTarget>(this->LevelTargetType)) << "\n";
  os << indent << "LevelTarget: " << this->LevelTarget << "\n";
  os << indent << "ManifoldOutput: " << (this->ManifoldOutput ? "On" : "Off") << "\n";
}
