// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels as a partitioned data set collection.
 */
#ifndef LevelCollection_h
#define LevelCollection_h

class vtkMultiBlockDataSet;
class vtkPartitionedDataSetCollection;

/**
 * Makes `to` a collection of the same levels: a partitioned data set each, with the level's name.
 * The tree and its names become the data assembly.
 */
void CopyLevels(vtkMultiBlockDataSet* from, vtkPartitionedDataSetCollection* to);

#endif
