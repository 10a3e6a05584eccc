// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carving-model: writes the models of the paper's figures to files.
 */
#include "Blocks.h"
#include "Contours.h"
#include "Figures.h"
#include "ModelFile.h"

#include <functional>
#include <iostream>
#include <map>

namespace
{

constexpr int Success = 0;
constexpr int Failure = 1;
constexpr int WrongUsage = 2;

constexpr const char* Usage =
  "usage: carving-model NAME FILE...\n"
  "       carving-model --list\n"
  "Writes a model to files: a mesh to .ply or .off, a contour to .vtk.\n";

/** Writes a model to a file. Returns an empty string or an error. */
using Writer = std::function<std::string(const std::string& fileName)>;

template <class Make>
Writer WriterOf(Make make)
{
  return [make](const std::string& fileName) { return models::Write(fileName, make()); };
}

const std::map<std::string, Writer> Writers = {
  { "blocks", WriterOf([] { return models::Blocks(128); }) },
  { "carved-figure", WriterOf(models::CarvedFigure) },
  { "eight-spheres", WriterOf(models::EightSpheres) },
  { "ribs", WriterOf(models::Ribs) },
  { "scone", WriterOf(models::Scone) },
  { "snaking-contour", WriterOf(models::SnakingContour) },
  { "tree", WriterOf([] { return models::Tree(); }) },
  { "two-spheres", WriterOf(models::TwoSpheres) },
  { "yucca-leaves", WriterOf(models::YuccaLeaves) },
};

int Fail(const std::string& error, int exitCode)
{
  std::cerr << "carving-model: " << error << "\n";
  return exitCode;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--help" && argc == 2)
  {
    std::cout << Usage;
    return Success;
  }
  if (first == "--list" && argc == 2)
  {
    for (const auto& [name, writer] : Writers)
    {
      std::cout << name << "\n";
    }
    return Success;
  }
  if (argc < 3)
  {
    std::cerr << Usage;
    return WrongUsage;
  }
  const auto found = Writers.find(first);
  if (found == Writers.end())
  {
    return Fail("there is no model \"" + first + "\" (see carving-model --list)", WrongUsage);
  }
  for (int i = 2; i < argc; ++i)
  {
    const std::string error = found->second(argv[i]);
    if (!error.empty())
    {
      return Fail(error, Failure);
    }
  }
  return Success;
}
