// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time to extract a level from a stored stream of about 150,000 tetrahedra.
 */
#include "Figures.h"
#include "PolyData.h"
#include "Shapes.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkTopologyCarver.h"
#include "vtkUnstructuredGrid.h"

#include <benchmark/benchmark.h>

namespace
{

/** The stream of a tree, as if read from a file. */
vtkUnstructuredGrid* GetStream()
{
  static const vtkSmartPointer<vtkUnstructuredGrid> stream = []
  {
    vtkNew<vtkTopologyCarver> carver;
    carver->SetInputData(ToPolyData(models::Tree(4800)));
    carver->Update();
    auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    copy->DeepCopy(carver->GetOutputDataObject(1));
    return copy;
  }();
  return stream;
}

/**
 * Extracts a different level each time, so that nothing is reused. Argument: whether levels are
 * cut.
 */
void ExtractLevel(benchmark::State& state)
{
  vtkUnstructuredGrid* stream = GetStream();
  const int steps = static_cast<int>(
    stream->GetFieldData()->GetAbstractArray("ProfileVertices")->GetNumberOfTuples());
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetLevelTargetType(vtkExtractCarvedLOD::STEP);
  extract->SetManifoldOutput(state.range(0) != 0);
  extract->Update(); // prepares the stream
  int i = 0;
  for (auto _ : state)
  {
    extract->SetLevelTarget((i++ * 37) % steps);
    extract->Update();
  }
  state.counters["cells"] = static_cast<double>(stream->GetNumberOfCells());
}

/** Extracts the finest level, which has the most triangles. */
void ExtractLastLevel(benchmark::State& state)
{
  vtkUnstructuredGrid* stream = GetStream();
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetLevelTarget(1e9);
  for (auto _ : state)
  {
    extract->Modified();
    extract->Update();
  }
  state.counters["triangles"] = static_cast<double>(extract->GetOutput()->GetNumberOfPolys());
}

/** Extracts a different simplified level of a torus of 20,000 vertices each time. */
void ExtractSimplified(benchmark::State& state)
{
  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(ToPolyData(models::Torus(1.0, 0.3, 200, 100)));
  carver->SetLevelSimplification(vtkTopologyCarver::ENCLOSING_COLLAPSE);
  carver->AddLevelTarget(1000);
  carver->Update();
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(carver->GetOutputDataObject(1));
  extract->SetLevelSimplification(vtkExtractCarvedLOD::ENCLOSING_COLLAPSE);
  extract->Update(); // prepares the stream
  int i = 0;
  for (auto _ : state)
  {
    extract->SetLevelTarget(static_cast<double>(state.range(0) - i++ % 100));
    extract->Update();
  }
  state.counters["triangles"] = static_cast<double>(extract->GetOutput()->GetNumberOfPolys());
}

/** Prepares a stream and extracts one level, as the first request does. */
void PrepareStream(benchmark::State& state)
{
  vtkUnstructuredGrid* stream = GetStream();
  for (auto _ : state)
  {
    vtkNew<vtkExtractCarvedLOD> extract;
    extract->SetInputData(stream);
    extract->Update();
  }
}

} // namespace

BENCHMARK(ExtractLevel)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(ExtractLastLevel)->Unit(benchmark::kMillisecond);
BENCHMARK(ExtractSimplified)->Arg(2000)->Arg(19000)->Unit(benchmark::kMillisecond);
BENCHMARK(PrepareStream)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
