// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exchange between the processes of a parallel run. An object is the input, or a leaf of a
 * composite input. Every object is whole on one process, and all processes have the same tree.
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

/** All processes must call the same functions in the same order. */
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
   * Returns the input that this process carves. For a polydata, that is the polydata or an empty
   * one; for a composite, a tree with null leaves. An object of a single process stays there. An
   * object that is spread over several processes is merged on the lowest of these, which counts it
   * in `numberOfMerged`. An object that no process has changed is the same as before, with the same
   * time stamp.
   */
  vtkSmartPointer<vtkDataObject> Gather(vtkDataObject* input, int& numberOfMerged);

  /**
   * Returns all parts of a mesh, on every process; the same object as before if no part has
   * changed.
   */
  vtkSmartPointer<vtkPolyData> GatherOnAll(vtkPolyData* mesh);

  /**
   * Gives the output trees of all processes the same blocks and names. Where another process has a
   * grid or a table, this process gets an empty one with the same field data, so that every process
   * knows the stream. Where another process has any other data, this process gets null.
   */
  void Match(vtkDataObject* output);

private:
  struct Merged
  {
    DataVersion Given; ///< the part of this process
    vtkSmartPointer<vtkPolyData> Mesh;
  };

  int Largest(int value) const;
  std::vector<int> All(int value) const;
  std::string First(const std::string& text) const;
  vtkSmartPointer<vtkDataObject> GatherNode(vtkDataObject* node, int& numberOfMerged);
  vtkSmartPointer<vtkDataObject> GatherLeaf(vtkPolyData* leaf, int& numberOfMerged);
  void MatchFieldData(vtkDataObject* leaf);

  vtkMultiProcessController* Controller = nullptr;
  std::vector<Merged> Cache; ///< an entry for each leaf, in the order of the tree
  std::size_t NextLeaf = 0;
  Merged OnAll;
};

#endif
