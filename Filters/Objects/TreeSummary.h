// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A data object, or a tree of them, as other processes need to know it.
 */
#ifndef TreeSummary_h
#define TreeSummary_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkMultiProcessStream;

/** A node of a tree without its mesh. */
struct TreeSummary
{
  std::string Name;    ///< empty if the node has none
  std::string Type;    ///< the class; empty for a null node
  bool IsTree = false; ///< whether the node is composite, so that it may have children
  bool IsMesh = true;  ///< whether the node is null, polydata, or a tree with known children
  std::vector<double> TargetRanges; ///< the array of the field data; empty without one
  std::vector<TreeSummary> Children;

  TreeSummary() = default;
  TreeSummary(vtkDataObject* node, const std::string& name);
  explicit TreeSummary(vtkMultiProcessStream& stream);
  void Write(vtkMultiProcessStream& stream) const;

  /**
   * Adds what another process knows. Where both know something, this process prevails, but a tree
   * prevails over a leaf.
   */
  void Add(const TreeSummary& other);

  /** Returns the sum of the summaries of all processes. The processes before others prevail. */
  static TreeSummary MergeAll(vtkDataObject* tree, vtkMultiProcessController* controller);
};

#endif
