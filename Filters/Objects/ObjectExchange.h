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

#include <vector>

class vtkDataObject;
class vtkMultiBlockDataSet;
class vtkMultiProcessController;
class vtkPolyData;
struct TreeSummary;

/**
 * All processes must call the same functions in the same order. If memory runs out on one of them,
 * the others wait for it: a controller cannot end their calls.
 */
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
   * one; for a composite, a tree with null leaves. An object that is spread over several processes
   * is merged on one of them, which counts it in `numberOfMerged`. Objects move to other processes
   * if some would have clearly more cells than others. An object that no process has changed is the
   * same as before, with the same time stamp, unless it moves.
   */
  vtkSmartPointer<vtkDataObject> Gather(vtkDataObject* input, int& numberOfMerged);

  /**
   * Returns all parts of a mesh, on every process; the same object as before if no part has
   * changed.
   */
  vtkSmartPointer<vtkPolyData> GatherOnAll(vtkPolyData* mesh);

  /**
   * Gives the output trees of all processes the same blocks and names. Where another process has a
   * grid or a table, this process gets an empty one, and the ranges of level targets of the other's
   * stream. Where another process has any other data, this process gets null.
   */
  void Match(vtkDataObject* output);

private:
  struct Merged
  {
    DataVersion Given; ///< the part of this process
    vtkSmartPointer<vtkPolyData> Mesh;
    int Destination = -1; ///< the only process that has the mesh, unless all have it
    bool IsNew = false;   ///< since the last exchange
  };

  /** A leaf of the input: the part of this process, and the place in the tree. */
  struct Leaf
  {
    vtkPolyData* Part;
    vtkMultiBlockDataSet* Parent; ///< null for the root
    unsigned int Block;
  };

  /** The processes that have parts of a leaf. */
  struct Owners
  {
    int First;
    int Number;
    double Cells; ///< of all parts
  };

  static vtkSmartPointer<vtkDataObject> GatherNode(vtkDataObject* node, const TreeSummary& summary,
    vtkMultiBlockDataSet* parent, unsigned int block, std::vector<Leaf>& leaves);
  static bool StaysInPlace(const Owners& owners, int destination)
  {
    return owners.Number == 0 || (owners.Number == 1 && owners.First == destination);
  }

  int Largest(int value) const;
  template <class Value>
  void Reduce(std::vector<Value>& values, int operation) const;
  std::vector<Owners> FindOwners(const std::vector<Leaf>& leaves) const;
  void FillCache(const std::vector<Leaf>& leaves, const std::vector<Owners>& owners);
  vtkSmartPointer<vtkPolyData> GatherLeaf(
    vtkPolyData* part, const Owners& owners, int destination) const;
  vtkSmartPointer<vtkPolyData> Move(vtkPolyData* mesh, int owner, int destination) const;
  vtkSmartPointer<vtkPolyData> Merge(vtkPolyData* part, int destination) const;

  vtkMultiProcessController* Controller = nullptr;
  std::vector<Merged> Cache; ///< an entry for each leaf, in the order of the tree
  Merged OnAll;
};

#endif
