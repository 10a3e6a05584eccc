// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arrays from files, which may hold anything.
 */
#ifndef ArrayReader_h
#define ArrayReader_h

#include "vtkDataArray.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;

/** What the entries of an array have to be. */
struct Demand
{
  std::string What;
  std::function<bool(double value, vtkIdType entry)> IsMet;
};

/** Integers between two that an `int` can hold. */
Demand IntegersFrom(int least, int greatest);

/** Finite numbers that are not negative. */
Demand FiniteMeasures();

/** Numbers that are not negative where `hasPriority(entry)`, and NaN elsewhere. */
Demand Priorities(const std::function<bool(vtkIdType entry)>& hasPriority);

/** Reads arrays up to the first one that is not as it has to be, and says what is wrong with that one. */
class ArrayReader
{
public:
  /** Empty if nothing has been wrong. */
  const std::string& GetMistake() const
  {
    return this->Mistake;
  }

  /** Reads an array of one number per tuple. */
  template <class Value>
  void Read(vtkFieldData* from, const char* name, vtkIdType tuples, const Demand& demand,
    std::vector<Value>& values)
  {
    vtkDataArray* array = this->Check(from, name, tuples, demand);
    values.resize(array ? tuples : 0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = static_cast<Value>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }

  /** The array if it is as it has to be, else null. */
  vtkDataArray* Check(vtkFieldData* from, const char* name, vtkIdType tuples, const Demand& demand);

  /** Checks a text, for which an array of one string stands. */
  void CheckText(vtkFieldData* from, const char* name);

  /** Checks the lengths of all arrays. */
  void CheckLengths(vtkDataSetAttributes* data, vtkIdType tuples);

  /** Refuses an array, unless there has been a mistake before. */
  void Refuse(const char* name, const std::string& why);

private:
  std::string Mistake;
};

#endif
