// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a carved leaf to the data objects of the three ports.
 */
#ifndef LeafOutput_h
#define LeafOutput_h

#include "Session/CarvedLeaf.h"
#include "Session/CarverPorts.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkUnstructuredGrid;

/**
 * Writes the outputs for a leaf, and reports targets that no level meets as warnings of the filter.
 */
template <int D>
class LeafOutput
{
public:
  /** `where` begins the messages. */
  LeafOutput(vtkAlgorithm* filter, const std::string& where, const CarverSettings& settings,
    CarverStages& stages, const CarverPorts& ports)
    : Filter(filter)
    , Where(where)
    , Settings(settings)
    , Stages(stages)
    , Ports(ports)
  {
  }

  /** Passes on the input's own field data. An empty leaf has no other output, except notes. */
  void WriteEmpty(vtkPolyData* input, const DecomposedLeaf<D>& leaf);

  /**
   * Writes all outputs. Releases arrays of the carving that have been written. Returns false if the
   * filter is to stop.
   */
  bool Write(vtkPolyData* input, const DecomposedLeaf<D>& leaf, CarvedLeaf<D>& carved);

private:
  void PassFieldData(vtkPolyData* input);
  void WriteStreamAndProfile(vtkPolyData* attributes, const DecomposedLeaf<D>& leaf,
    CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid);
  std::vector<int> SelectSteps(const carving::Profile& profile);
  /** Fills a block for each step. Returns false if the filter is to stop. */
  bool WriteLevels(
    const std::vector<int>& steps, const CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid);
  /** Fills a block for each simplified level. Returns false if the filter is to stop. */
  bool WriteSimplifiedLevels(const CarvedLeaf<D>& carved, vtkUnstructuredGrid* grid);
  void AppendInput(vtkPolyData* attributes, const DecomposedLeaf<D>& leaf,
    const carving::Profile& profile, vtkUnstructuredGrid* grid);
  void SetLevel(unsigned int index, vtkPolyData* level);

  vtkAlgorithm* Filter;
  const std::string& Where;
  const CarverSettings& Settings;
  CarverStages& Stages;
  const CarverPorts& Ports;
};

#endif
