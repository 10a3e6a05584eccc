// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "FileName.h"
#include "Help.h"
#include "LevelWriter.h"
#include "OptionChecks.h"
#include "OptionValues.h"
#include "vtkCarverProperty.h"
#include "vtkTopologyCarver.h"
#include "vtksys/SystemTools.hxx"

#include <cctype>
#include <functional>
#include <getopt.h>

namespace
{

/**
 * The option that getopt_long has just refused: a letter, or the whole argument before the next.
 */
std::string GetOffender(char* argv[])
{
  return optopt > 0 && optopt < 128 && std::isprint(optopt) && argv[optind - 1][1] != '-'
    ? std::string("-") + static_cast<char>(optopt)
    : argv[optind - 1];
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
      return options.WritesFolder()
        ? ""
        : LevelWriter::CheckFormat(FileName::GetExtension(value), value);
    } });
  known.push_back({ "format", required_argument,
    [&](const std::string& value)
    {
      options.Format = "." + value;
      return LevelWriter::CheckFormat(options.Format, "--format " + value);
    } });
  known.push_back({ "stream", required_argument,
    [&](const std::string& value)
    {
      options.Stream = value;
      options.CarvingOption = "--stream";
      return IsStream(value) ? "" : "--stream requires a name that ends in .vtu";
    } });
  known.push_back({ "profile", required_argument,
    [&](const std::string& value)
    {
      options.Profile = value;
      const std::string extension = FileName::GetExtension(value);
      return extension == ".csv" || extension == ".png"
        ? ""
        : "--profile requires a name that ends in .csv or .png";
    } });
  known.push_back({ "json", required_argument,
    [&](const std::string& value)
    {
      options.Json = value;
      return value.empty() ? "--json requires a name, or - for standard output" : "";
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
        if (property.Name == "ManifoldOutput")
        {
          options.ManifoldOutput = value != 0.0;
        }
        const bool isForLevels = // also for those of a stored stream
          property.Name == "ManifoldOutput" || property.Name == "MaximumVertices";
        options.CarvingOption = isForLevels ? options.CarvingOption : option;
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
      : found == ':' ? "the option " + GetOffender(argv) + " requires a value"
                     : "unknown option " + GetOffender(argv);
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

} // namespace

bool Options::WritesFolder() const
{
  return !this->Output.empty() &&
    (this->Output.back() == '/' || vtksys::SystemTools::FileIsDirectory(this->Output));
}

std::string Options::GetFormat() const
{
  return !this->WritesFolder() ? FileName::GetExtension(this->Output)
    : this->Format.empty()     ? ".vtm"
                               : this->Format;
}

std::string Options::GetFile(const std::string& input) const
{
  return this->WritesFolder() ? this->Output + (this->Output.back() == '/' ? "" : "/") +
      FileName::GetStem(input) + this->GetFormat()
                              : this->Output;
}

bool IsStream(const std::string& fileName)
{
  return FileName::GetExtension(fileName) == ".vtu";
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
