// SPDX-License-Identifier: BSD-3-Clause
#include "OptionValues.h"

#include "Help.h"
#include "Options.h"
#include "vtkCarverProperty.h"
#include "vtkTopologyCarver.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace
{

/** Returns false unless the whole text is a finite number. */
bool ToNumber(const std::string& text, double& number)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

/** Reads the targets of a type. Returns an empty string, or a description of the mistake. */
std::string ParseTargets(int type, const std::string& text, std::vector<double>& targets)
{
  const std::string name = ToOption(GetTargetTypes()[type]);
  const bool length =
    type == vtkTopologyCarver::FEATURE_SIZE || type == vtkTopologyCarver::ERROR_BOUND;
  const double smallest =
    type == vtkTopologyCarver::STEP || type == vtkTopologyCarver::TUNNELS ? 0.0 : 1.0;
  std::istringstream list(text);
  for (std::string item; std::getline(list, item, ',');)
  {
    double target = 0.0;
    if (!ToNumber(item, target) ||
      (length ? target <= 0.0 : target < smallest || target != std::floor(target)))
    {
      return "--" + name + " requires " + (length ? "lengths above 0" : "whole numbers") +
        (!length && smallest > 0.0 ? " above 0" : "") + " with commas between, not \"" + text +
        "\"";
    }
    targets.push_back(target);
  }
  return targets.empty() ? "--" + name + " requires a number" : "";
}

/** Whether a number of vertices can limit the levels that targets of a type pick. */
bool CanBeLimited(int type)
{
  return type == vtkTopologyCarver::TUNNELS || type == vtkTopologyCarver::COMPONENTS ||
    type == vtkTopologyCarver::FEATURE_SIZE || type == vtkTopologyCarver::STEP;
}

/** Describes the values of a property whose values are numbers. */
std::string DescribeRange(const vtkCarverProperty& property)
{
  std::ostringstream text;
  text << "a " << (property.IsInteger ? "whole " : "") << "number";
  if (property.Least < 0.0)
  {
    text << ", or -1 for no limit";
  }
  else if (property.Greatest < VTK_INT_MAX)
  {
    text << " from " << property.Least << " to " << property.Greatest;
  }
  else
  {
    text << " of " << property.Least << " or more";
  }
  return text.str();
}

} // namespace

const vtkCarverProperty& FindProperty(const char* name)
{
  const auto& all = vtkCarverProperty::GetAll();
  return *std::find_if(all.begin(), all.end(),
    [&](const vtkCarverProperty& property) { return property.Name == name; });
}

const std::vector<std::string>& GetTargetTypes()
{
  return FindProperty("LevelTargetType").Choices;
}

std::string TakeTargets(int type, const std::string& text, Options& options)
{
  std::vector<double> targets;
  const std::string error = ParseTargets(type, text, targets);
  if (!error.empty())
  {
    return error;
  }
  if (!options.Targets.empty() && type == vtkTopologyCarver::VERTICES)
  {
    std::swap(targets, options.Targets);
    std::swap(type, options.TargetType);
  }
  if (options.Targets.empty())
  {
    options.Targets = targets;
    options.TargetType = type;
    return {};
  }
  if (options.TargetType != vtkTopologyCarver::VERTICES || options.Targets.size() > 1 ||
    !CanBeLimited(type))
  {
    std::string list;
    for (const std::string& other : GetTargetTypes())
    {
      list += (list.empty() ? "--" : ", --") + ToOption(other);
    }
    return "levels can be picked by one of the following options only, except that one number of "
           "--vertices can limit those of --tunnels, --components, --feature-size or --step: " +
      list;
  }
  options.Properties["MaximumVertices"] = options.Targets.front();
  options.Properties["LevelSimplification"] = vtkTopologyCarver::ENCLOSING_COLLAPSE;
  options.Targets = targets;
  options.TargetType = type;
  return {};
}

std::string ParseValue(const std::string& option, const vtkCarverProperty& property,
  const std::string& text, double& value)
{
  if (property.Choices.empty())
  {
    const bool good = ToNumber(text, value) && value >= property.Least &&
      value <= property.Greatest && (!property.IsInteger || value == std::floor(value));
    return good ? "" : option + " requires " + DescribeRange(property) + ", not \"" + text + "\"";
  }
  const auto found = std::find_if(property.Choices.begin(), property.Choices.end(),
    [&](const std::string& choice) { return ToOption(choice) == text; });
  value = static_cast<double>(found - property.Choices.begin());
  return found != property.Choices.end()
    ? ""
    : option + " requires " + ListChoices(property) + ", not \"" + text + "\"";
}
