// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The properties of vtkCarverAlgorithm as a table, for code that prints, stores or sets all of
 * them.
 */
#ifndef vtkCarverProperty_h
#define vtkCarverProperty_h

#include "vtkTopologyCarvingModule.h" // for export macro

#include <string>
#include <vector>

class vtkCarverAlgorithm;

/** A property with a single value, which is a number for every type of property. */
struct VTKTOPOLOGYCARVING_EXPORT vtkCarverProperty
{
  std::string Name; ///< "BreadthRadius" for SetBreadthRadius and GetBreadthRadius
  double (*Get)(vtkCarverAlgorithm* carver);
  void (*Set)(vtkCarverAlgorithm* carver, double value);
  bool IsInteger; ///< also for enumerations and switches

  /** The names of the values 0, 1, ... of an enumeration or a switch; empty for a number. */
  std::vector<std::string> Choices;
  double Least;    ///< for a number
  double Greatest; ///< for a number

  /** Whether the field data of a stream has the value, under the property's name. */
  bool IsStored;

  /**
   * A description without the default. Empty if command-line programs have other options for the
   * property.
   */
  std::string Help;

  /** The value as text: the name of a choice, or a number. */
  std::string GetText(vtkCarverAlgorithm* carver) const;

  /** All properties, in the order of the work: decompose, carve, measure, write levels. */
  static const std::vector<vtkCarverProperty>& GetAll();
};

#endif
