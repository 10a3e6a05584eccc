// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/ArrayReader.h"

#include "vtkDataSetAttributes.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>

namespace
{

std::string WrongLength(vtkIdType tuples, vtkIdType wanted)
{
  return "has " + std::to_string(tuples) + " tuples instead of " + std::to_string(wanted);
}

} // namespace

Demand IntegersFrom(int least, int greatest)
{
  return { "an integer from " + std::to_string(least) + " to " + std::to_string(greatest),
    [=](double value, vtkIdType)
    { return value >= least && value <= greatest && value == std::floor(value); } };
}

Demand FiniteMeasures()
{
  return { "a finite number of at least 0",
    [](double value, vtkIdType) { return std::isfinite(value) && value >= 0.0; } };
}

Demand Priorities(const std::function<bool(vtkIdType entry)>& hasPriority)
{
  return { "a number of at least 0 (NaN where nothing is carved)",
    [=](double value, vtkIdType i) { return hasPriority(i) ? value >= 0.0 : std::isnan(value); } };
}

vtkDataArray* ArrayReader::Check(
  vtkFieldData* from, const char* name, vtkIdType tuples, const Demand& demand, int components)
{
  if (!this->Mistake.empty())
  {
    return nullptr;
  }
  vtkAbstractArray* any = from->GetAbstractArray(name);
  if (!any)
  {
    this->Refuse(name, "is missing");
    return nullptr;
  }
  auto* array = vtkDataArray::SafeDownCast(any);
  if (!array)
  {
    this->Refuse(name, "has no numbers");
    return nullptr;
  }
  if (array->GetNumberOfComponents() != components)
  {
    this->Refuse(name,
      "has " + std::to_string(array->GetNumberOfComponents()) + " components instead of " +
        std::to_string(components));
    return nullptr;
  }
  if (array->GetNumberOfTuples() != tuples)
  {
    this->Refuse(name, WrongLength(array->GetNumberOfTuples(), tuples));
    return nullptr;
  }
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    const double value = array->GetComponent(i / components, static_cast<int>(i % components));
    if (!demand.IsMet(value, i))
    {
      std::ostringstream why;
      why << "has the value " << value << " at " << i << ", which is not " << demand.What;
      this->Refuse(name, why.str());
      return nullptr;
    }
  }
  return array;
}

void ArrayReader::CheckText(vtkFieldData* from, const char* name)
{
  auto* text = vtkStringArray::SafeDownCast(from->GetAbstractArray(name));
  if (!text)
  {
    this->Refuse(name, "has no text");
  }
  else if (text->GetNumberOfValues() != 1)
  {
    this->Refuse(name, WrongLength(text->GetNumberOfValues(), 1));
  }
}

void ArrayReader::CheckLengths(vtkDataSetAttributes* data, vtkIdType tuples)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != tuples)
    {
      this->Refuse(array->GetName(), WrongLength(array->GetNumberOfTuples(), tuples));
    }
  }
}

void ArrayReader::Refuse(const char* name, const std::string& why)
{
  if (this->Mistake.empty())
  {
    this->Mistake = std::string("the array \"") + (name ? name : "") + "\" " + why + ".";
  }
}
