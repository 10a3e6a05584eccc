// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "FileName.h"
#include "LevelWriter.h"
#include "Options.h"
#include "vtkTopologyCarver.h"

#include <algorithm>
#include <map>

namespace
{

/** The name of a given option that is for a single mesh; empty if there is none. */
std::string FindOptionForOneMesh(const Options& options)
{
  return options.Decimate      ? "--decimate"
    : !options.Stream.empty()  ? "--stream"
    : !options.Profile.empty() ? "--profile"
                               : "";
}

/**
 * Returns an empty string, or a description of options that --decimate excludes or that need it.
 */
std::string CheckDecimation(const Options& options)
{
  if (!options.Decimate)
  {
    return options.Nested ? "--nested requires --decimate" : "";
  }
  const std::string other = !options.CarvingOption.empty() ? options.CarvingOption
    : options.Simplifies()                                 ? "--simplify"
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
    : "--decimate requires --vertices, --triangles or --error-bound";
}

/** Returns an empty string, or a description of options that several inputs exclude. */
std::string CheckScene(const Options& options)
{
  if (options.Inputs.size() == 1)
  {
    return "";
  }
  std::string other = FindOptionForOneMesh(options);
  other = other.empty() && std::any_of(options.Inputs.begin(), options.Inputs.end(), IsStream)
    ? "a stored stream"
    : other;
  if (!other.empty())
  {
    return "several inputs cannot be combined with " + other;
  }
  return options.Output.empty() || options.WritesFolder() ||
      LevelWriter::HoldsSeveralMeshes(options.GetFormat())
    ? ""
    : "several inputs can be written to a folder, such as " +
      FileName::WithoutExtension(options.Output) +
      "/, or to a name that ends in .vtm, .vtpc or .glb only";
}

/** Returns an empty string, or the reason why results cannot be written where they are to be. */
std::string CheckOutput(const Options& options)
{
  if (!options.WritesFolder())
  {
    return !options.Format.empty() ? "--format requires -o FOLDER/" : "";
  }
  std::map<std::string, std::string> inputs;
  for (const std::string& input : options.Inputs)
  {
    const auto [other, isNew] = inputs.emplace(options.GetFile(input), input);
    if (!isNew)
    {
      return "the results of " + other->second + " and " + input + " would both be " +
        other->first + ": rename one of them, or carve it by itself";
    }
  }
  return {};
}

} // namespace

std::string CheckContours(const Options& options)
{
  if (options.Contours && options.Simplifies())
  {
    return "contours cannot be simplified: --simplify and --vertices beside other targets are for "
           "meshes";
  }
  return options.Contours && !options.Output.empty() &&
      !LevelWriter::HoldsLines(options.GetFormat())
    ? "contours can be written to .vtm, .vtpc or .vtp only"
    : "";
}

std::string CheckCombination(const Options& options)
{
  for (const auto check : { CheckOutput, CheckScene, CheckDecimation, CheckContours })
  {
    const std::string error = check(options);
    if (!error.empty())
    {
      return error;
    }
  }
  if (options.Properties.count("NumberOfLevels") > 0 && !options.Targets.empty())
  {
    return "--levels cannot be combined with other ways to pick levels";
  }
  if (options.Properties.count("MaximumVertices") > 0 && !options.Simplifies())
  {
    return "--maximum-vertices requires --simplify";
  }
  const auto initial = options.Properties.find("InitialApproximation");
  if (initial != options.Properties.end() && initial->second == vtkTopologyCarver::CUSTOM &&
    options.InitialMesh.empty())
  {
    return "--initial-approximation custom requires --initial-mesh FILE";
  }
  if (IsStream(options.Inputs[0]) && !options.CarvingOption.empty())
  {
    return options.CarvingOption + " requires a mesh: " + options.Inputs[0] +
      " has been carved already";
  }
  if (IsStream(options.Inputs[0]) && options.Simplifies() && options.Targets.empty())
  {
    return "--simplify requires --vertices or another way to pick levels of a stored stream";
  }
  return {};
}

std::string CheckSeveralMeshes(const Options& options, const std::string& input)
{
  const std::string other = FindOptionForOneMesh(options);
  if (!other.empty())
  {
    return input + " has several meshes, which cannot be combined with " + other;
  }
  return options.Output.empty() || LevelWriter::HoldsSeveralMeshes(options.GetFormat())
    ? ""
    : input + " has several meshes, which can be written to .vtm, .vtpc or .glb only";
}
