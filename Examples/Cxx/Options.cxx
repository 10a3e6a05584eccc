// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Help.h"
#include "LevelWriter.h"
#include "vtkCarverProperty.h"
#include "vtkTopologyCarver.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <getopt.h>
#include <sstream>

namespace
{

bool EndsIn(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Returns false unless the whole text is a finite number. */
bool ToNumber(const std::string& text, double& number)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

const vtkCarverProperty& FindProperty(const std::string& name)
{
  const auto& all = vtkCarverProperty::GetAll();
  return *std::find_if(all.begin(), all.end(),
    [&](const vtkCarverProperty& property) { return property.Name == name; });
}

/** The types of level targets, each of which has an option. */
const std::vector<std::string>& GetTargetTypes()
{
  return FindProperty("LevelTargetType").Choices;
}

/**
 * The option that getopt_long has just refused: a letter, or the whole argument before the next.
 */
std::string GetOffender(char* argv[])
{
  return optopt > 0 && optopt < 128 && std::isprint(optopt) && argv[optind - 1][1] != '-'
    ? std::string("-") + static_cast<char>(optopt)
    : argv[optind - 1];
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
      return "--" + name + " wants " + (length ? "lengths above 0" : "whole numbers") +
        (!length && smallest > 0.0 ? " above 0" : "") + " with commas between, not \"" + text +
        "\"";
    }
    targets.push_back(target);
  }
  return targets.empty() ? "--" + name + " wants a number" : "";
}

/** Whether a number of vertices can limit the levels that targets of a type pick. */
bool CanBeLimited(int type)
{
  return type == vtkTopologyCarver::TUNNELS || type == vtkTopologyCarver::COMPONENTS ||
    type == vtkTopologyCarver::FEATURE_SIZE || type == vtkTopologyCarver::STEP;
}

/** Takes the targets of a type, and a number of vertices as a limit for those of another type. */
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
  options.CarvingOption = "--vertices with --" + ToOption(GetTargetTypes()[type]);
  options.Targets = targets;
  options.TargetType = type;
  return {};
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

/** Reads the value of a property. Returns an empty string, or a description of the mistake. */
std::string ParseValue(const std::string& option, const vtkCarverProperty& property,
  const std::string& text, double& value)
{
  if (property.Choices.empty())
  {
    const bool good = ToNumber(text, value) && value >= property.Least &&
      value <= property.Greatest && (!property.IsInteger || value == std::floor(value));
    return good ? "" : option + " wants " + DescribeRange(property) + ", not \"" + text + "\"";
  }
  const auto found = std::find_if(property.Choices.begin(), property.Choices.end(),
    [&](const std::string& choice) { return ToOption(choice) == text; });
  value = static_cast<double>(found - property.Choices.begin());
  return found != property.Choices.end()
    ? ""
    : option + " wants " + ListChoices(property) + ", not \"" + text + "\"";
}

/** An option of the command line. */
struct KnownOption
{
  std::string Name;
  int HasValue;
  /** Takes the value. Returns an empty string, or a description of the mistake. */
  std::function<std::string(const std::string& value)> Take;
};

void AddFileOptions(Options& options, std::vector<KnownOption>& known)
{
  known.push_back({ "output", required_argument,
    [&](const std::string& value)
    {
      options.Output = value;
      return LevelWriter::CheckName(value);
    } });
  known.push_back({ "stream", required_argument,
    [&](const std::string& value)
    {
      options.Stream = value;
      options.CarvingOption = "--stream";
      return IsStream(value) ? "" : "--stream wants a name that ends in .vtu";
    } });
  known.push_back({ "profile", required_argument,
    [&](const std::string& value)
    {
      options.Profile = value;
      return EndsIn(value, ".csv") || EndsIn(value, ".png")
        ? ""
        : "--profile wants a name that ends in .csv or .png";
    } });
  known.push_back({ "initial-mesh", required_argument,
    [&](const std::string& value)
    {
      options.InitialMesh = value;
      options.Properties["InitialApproximation"] = vtkTopologyCarver::CUSTOM;
      options.CarvingOption = "--initial-mesh";
      return "";
    } });
}

void AddLevelOptions(Options& options, std::vector<KnownOption>& known)
{
  known.push_back({ "levels", required_argument,
    [&](const std::string& value)
    {
      double& number = options.Properties["NumberOfLevels"];
      const std::string error =
        ParseValue("--levels", FindProperty("NumberOfLevels"), value, number);
      options.NumberOfLevels = static_cast<int>(error.empty() ? number : 0.0);
      return error;
    } });
  for (int type = 0; type < static_cast<int>(GetTargetTypes().size()); ++type)
  {
    known.push_back({ ToOption(GetTargetTypes()[type]), required_argument,
      [&options, type](const std::string& value) { return TakeTargets(type, value, options); } });
  }
}

void AddThreadsOption(Options& options, std::vector<KnownOption>& known)
{
  known.push_back({ "threads", required_argument,
    [&](const std::string& value)
    {
      options.CarvingOption = "--threads";
      const vtkCarverProperty& property = FindProperty("NumberOfThreads");
      return ParseValue("--threads", property, value, options.Properties[property.Name]);
    } });
}

void AddPropertyOptions(Options& options, std::vector<KnownOption>& known)
{
  for (const vtkCarverProperty& property : vtkCarverProperty::GetAll())
  {
    if (property.Help.empty())
    {
      continue; // has an option of another name
    }
    known.push_back({ ToOption(property.Name), required_argument,
      [&](const std::string& text)
      {
        double& value = options.Properties[property.Name];
        const std::string option = "--" + ToOption(property.Name);
        const std::string error = ParseValue(option, property, text, value);
        if (property.Name == "ManifoldOutput") // which levels of a stored stream have, too
        {
          options.ManifoldOutput = value != 0.0;
        }
        else
        {
          options.CarvingOption = option;
        }
        return error;
      } });
  }
}

/** All options; the first is the one with the short name. */
std::vector<KnownOption> MakeKnownOptions(Options& options)
{
  std::vector<KnownOption> known;
  AddFileOptions(options, known);
  AddLevelOptions(options, known);
  AddThreadsOption(options, known);
  AddPropertyOptions(options, known);
  known.push_back({ "contours", no_argument,
    [&](const std::string&)
    {
      options.Contours = true;
      options.CarvingOption = "--contours";
      return "";
    } });
  known.push_back({ "simplify", no_argument,
    [&](const std::string&)
    {
      options.Properties["LevelSimplification"] = vtkTopologyCarver::ENCLOSING_COLLAPSE;
      options.CarvingOption = "--simplify";
      return "";
    } });
  for (const auto& [name, flag] :
    { std::pair("decimate", &options.Decimate), std::pair("nested", &options.Nested) })
  {
    known.push_back({ name, no_argument,
      [flag = flag](const std::string&)
      {
        *flag = true;
        return "";
      } });
  }
  for (const auto& [name, action] : { std::pair("help", Options::Action::ShowHelp),
         std::pair("version", Options::Action::ShowVersion) })
  {
    known.push_back({ name, no_argument,
      [&options, wanted = action](const std::string&)
      {
        options.Wanted = wanted;
        return "";
      } });
  }
  return known;
}

/** Takes all options up to a mistake, which is described, or up to --help or --version. */
std::string TakeOptions(int argc, char* argv[], Options& options)
{
  const std::vector<KnownOption> known = MakeKnownOptions(options);
  constexpr int firstValue = 256; // beyond all letters
  std::vector<option> names;
  for (const KnownOption& one : known)
  {
    const int value = firstValue + static_cast<int>(names.size());
    names.push_back({ one.Name.c_str(), one.HasValue, nullptr, value });
  }
  names.push_back({});
  opterr = 0;
  while (options.Wanted == Options::Action::Carve)
  {
    const int found = getopt_long(argc, argv, ":o:", names.data(), nullptr);
    if (found == -1)
    {
      break;
    }
    const bool isKnown = found == 'o' || found >= firstValue;
    const std::string error = isKnown
      ? known[found == 'o' ? 0 : found - firstValue].Take(optarg ? optarg : "")
      : found == ':' ? "the option " + GetOffender(argv) + " wants a value"
                     : "unknown option " + GetOffender(argv);
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

/**
 * Returns an empty string, or a description of options that --decimate excludes or that need it.
 */
std::string CheckDecimation(const Options& options)
{
  if (!options.Decimate)
  {
    return options.Nested ? "--nested wants --decimate" : "";
  }
  const std::string other = !options.CarvingOption.empty() ? options.CarvingOption
    : !options.Profile.empty()                             ? "--profile"
    : options.Properties.count("NumberOfLevels") > 0       ? "--levels"
    : IsStream(options.Inputs[0])                          ? "a stored stream"
                                                           : "";
  if (!other.empty())
  {
    return "--decimate cannot be combined with " + other;
  }
  return options.TargetType == vtkTopologyCarver::VERTICES ||
      options.TargetType == vtkTopologyCarver::TRIANGLES ||
      options.TargetType == vtkTopologyCarver::ERROR_BOUND
    ? ""
    : "--decimate wants --vertices, --triangles or --error-bound";
}

/** Returns an empty string, or a description of options that several inputs exclude. */
std::string CheckScene(const Options& options)
{
  if (!options.IsScene())
  {
    return "";
  }
  const std::string other = options.Decimate                              ? "--decimate"
    : !options.Stream.empty()                                             ? "--stream"
    : !options.Profile.empty()                                            ? "--profile"
    : std::any_of(options.Inputs.begin(), options.Inputs.end(), IsStream) ? "a stored stream"
                                                                          : "";
  if (!other.empty())
  {
    return "several inputs cannot be combined with " + other;
  }
  return options.Output.empty() || EndsIn(options.Output, ".vtm")
    ? ""
    : "several inputs can be written to a name that ends in .vtm only";
}

/** Returns an empty string, or a description of options that contradict each other. */
std::string CheckCombination(const Options& options)
{
  std::string error = CheckScene(options);
  error = error.empty() ? CheckDecimation(options) : error;
  if (!error.empty())
  {
    return error;
  }
  if (options.Properties.count("NumberOfLevels") > 0 && !options.Targets.empty())
  {
    return "--levels cannot be combined with other ways to pick levels";
  }
  const auto initial = options.Properties.find("InitialApproximation");
  if (initial != options.Properties.end() && initial->second == vtkTopologyCarver::CUSTOM &&
    options.InitialMesh.empty())
  {
    return "--initial-approximation custom wants --initial-mesh FILE";
  }
  if (options.Contours && !EndsIn(options.Output, ".vtm") && !EndsIn(options.Output, ".vtp") &&
    !options.Output.empty())
  {
    return "contours can be written to a name that ends in .vtm or .vtp only";
  }
  if (IsStream(options.Inputs[0]) && !options.CarvingOption.empty())
  {
    return options.CarvingOption + " wants a mesh: " + options.Inputs[0] +
      " has been carved already";
  }
  return {};
}

} // namespace

bool IsStream(const std::string& fileName)
{
  return EndsIn(fileName, ".vtu");
}

std::string Parse(int argc, char* argv[], Options& options)
{
  const std::string error = TakeOptions(argc, argv, options);
  if (!error.empty() || options.Wanted != Options::Action::Carve)
  {
    return error;
  }
  if (optind == argc)
  {
    return "no input is given";
  }
  options.Inputs.assign(argv + optind, argv + argc);
  return CheckCombination(options);
}
