// SPDX-License-Identifier: BSD-3-Clause
#ifndef XmlFile_h
#define XmlFile_h

#include <string>

class vtkDataObject;

namespace XmlFile
{

/**
 * Writes a data set, or a multiblock of data sets with one file for each, in VTK's XML formats; a
 * multiblock of polydata as a partitioned data set collection if the name ends in .vtpc. No data
 * set may be empty. Returns whether everything has been written.
 */
bool Write(const std::string& fileName, vtkDataObject* data);

} // namespace XmlFile

#endif
