// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTopologyCarver.h"

#include "Convert/CarverInput.h"
#include "Process/HelperProcess.h"
#include "Session/WithinMemory.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkTopologyCarver);

//------------------------------------------------------------------------------
vtkTopologyCarver::vtkTopologyCarver()
  : vtkCarverAlgorithm(3)
{
}

//------------------------------------------------------------------------------
vtkTopologyCarver::~vtkTopologyCarver() = default;

//------------------------------------------------------------------------------
int vtkTopologyCarver::CountIntersectingPairs(vtkPolyData* mesh)
{
  carving::Reply reply;
  const auto count = [&]
  {
    CarverInput input;
    std::string error = mesh ? input.Gather(mesh) : "There is no mesh to count in.";
    if (error.empty() && !input.IsEmpty())
    {
      carving::Job job;
      job.Kind = carving::JobKind::CountIntersections;
      job.Mesh = std::move(input.Mesh);
      HelperProcess::Run(job, reply, nullptr, error);
    }
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
    }
    return error.empty();
  };
  return WithinMemory(this, "", count) ? reply.IntersectingPairs : -1;
}
