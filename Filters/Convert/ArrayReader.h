// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and checks arrays of a grid, which may come from any file.
 */
#ifndef ArrayReader_h
#define ArrayReader_h

#include "vtkDataArray.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;

/**
 * The condition that all entries of an array must meet, in words and as a function. The entries of
 * an array with components are numbered tuple by tuple.
 */
struct Demand
{
  std::string What;
  std::function<bool(double value, vtkIdType entry)> IsMet;
};

/** Integers from one number to another, both included, or to the greatest there is. */
Demand IntegersFrom(int least, int greatest = VTK_INT_MAX);

/** Finite numbers of at least 0. */
Demand FiniteMeasures();

/** Numbers of at least 0 where `hasPriority(entry)` is true, and NaN elsewhere. */
Demand Priorities(const std::function<bool(vtkIdType entry)>& hasPriority);

/** Reads arrays up to the first invalid one, and describes the mistake in that one. */
class ArrayReader
{
public:
  /** A description of the first mistake; empty if there is none. */
  const std::string& GetMistake() const
  {
    return this->Mistake;
  }

  /** Reads an array, tuple by tuple; after a mistake, `values` is empty. */
  template <class Value>
  void Read(vtkFieldData* from, const char* name, vtkIdType tuples, const Demand& demand,
    std::vector<Value>& values, int components = 1)
  {
    vtkDataArray* array = this->Check(from, name, tuples, demand, components);
    values.resize(array ? tuples * components : 0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const vtkIdType entry = static_cast<vtkIdType>(i);
      values[i] = static_cast<Value>(
        array->GetComponent(entry / components, static_cast<int>(entry % components)));
    }
  }

  /** Returns the array if it is valid and there has been no mistake before, else null. */
  vtkDataArray* Check(vtkFieldData* from, const char* name, vtkIdType tuples, const Demand& demand,
    int components = 1);

  /** Checks a text: an array of one string. */
  void CheckText(vtkFieldData* from, const char* name);

  /** Checks that every array has this number of tuples. */
  void CheckLengths(vtkDataSetAttributes* data, vtkIdType tuples);

  /** Records a mistake in an array, unless there has been one before. */
  void Refuse(const char* name, const std::string& why);

private:
  std::string Mistake;
};

#endif
