// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Between the processes of a parallel run: every object whole on one of them, the same tree on all.
 */
#ifndef ObjectExchange_h
#define ObjectExchange_h

#include "Objects/DataVersion.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

/** All processes have to call the same functions in the same order. */
class ObjectExchange
{
public:
  /** Null stands for a single process. */
  void SetController(vtkMultiProcessController* controller)
  {
    this->Controller = controller;
  }
  bool IsParallel() const;

  /** Whether a condition holds on every process. */
  bool IsTrueOnAll(bool here) const;

  /**
   * The input as the process is to carve it: for a polydata, that or an empty one, for a composite of
   * them a tree with null leaves. An object that only one process has stays there; one that is spread
   * is merged on the lowest of those that have a part of it, and counted in `numberOfMerged` there. An
   * object that none of them has changed is given as before, with the same time stamp.
   */
  vtkSmartPointer<vtkDataObject> Gather(vtkDataObject* input, int& numberOfMerged);

  /** All parts of a mesh, on every process; the same as before if no process has changed its part. */
  vtkSmartPointer<vtkPolyData> GatherOnAll(vtkPolyData* mesh);

  /**
   * Gives the trees of all processes the same blocks and names, null where another process has the
   * data, except that grids and tables become empty ones with the field data of the other process, so
   * that all know about the stream.
   */
  void Match(vtkDataObject* output);

private:
  struct Merged
  {
    DataVersion Given; ///< the part that this process gave
    vtkSmartPointer<vtkPolyData> Mesh;
  };

  int Largest(int value) const;
  std::vector<int> All(int value) const;
  std::string First(const std::string& text) const;
  vtkSmartPointer<vtkDataObject> GatherNode(vtkDataObject* node, int& numberOfMerged);
  vtkSmartPointer<vtkDataObject> GatherLeaf(vtkPolyData* leaf, int& numberOfMerged);
  void MatchFieldData(vtkDataObject* leaf);

  vtkMultiProcessController* Controller = nullptr;
  std::vector<Merged> Cache; ///< one entry for each leaf, in the order of the tree
  std::size_t NextLeaf = 0;
  Merged OnAll;
};

#endif
