// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carving-model: writes the models of the paper's figures, and models of any size, to files.
 */
#include "Blocks.h"
#include "Contours.h"
#include "Figures.h"
#include "ModelFile.h"
#include "Shapes.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>

namespace
{

constexpr int Success = 0;
constexpr int Failure = 1;
constexpr int WrongUsage = 2;

constexpr const char* Usage = "usage: carving-model NAME FILE...\n"
                              "       carving-model bumpy-torus:VERTICES|tree:VERTICES FILE...\n"
                              "       carving-model --list\n"
                              "Writes a model to files: a mesh to .ply or .off, a contour to .vtk. "
                              "VERTICES is the approximate\n"
                              "number of vertices, 1000 to 10000000.\n";

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

using Maker = models::TriangleMesh (*)(int vertices);

/** A row of trees: one has no room for more than about 100,000 vertices. */
models::TriangleMesh Trees(int vertices)
{
  const double ofLeaf = 4.66; // its own four, and its share of the limbs
  const int number = 1 + (vertices - 1) / 100000;
  const models::TriangleMesh tree = models::Tree(static_cast<int>(vertices / ofLeaf / number));
  models::TriangleMesh row;
  for (int i = 0; i < number; ++i)
  {
    // Trees of the same size would have too many points on common spheres.
    row =
      models::Joined(row, models::Moved(tree, { 1.2 * i, 0.1 * (i % 3), 0 }, 1.0 - 0.01 * (i % 7)));
  }
  return row;
}

const std::map<std::string, Maker> Makers = {
  { "bumpy-torus", models::BumpyTorus },
  { "tree", Trees },
};

/** The writer of a model. Empty if there is no such model. */
Writer FindWriter(const std::string& text)
{
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
  {
    const auto found = Writers.find(text);
    return found == Writers.end() ? Writer() : found->second;
  }
  const auto found = Makers.find(text.substr(0, colon));
  const int vertices = std::atoi(text.c_str() + colon + 1);
  return found == Makers.end() || vertices < 1000 || vertices > 10000000
    ? Writer()
    : WriterOf([=] { return found->second(vertices); });
}

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
  const Writer write = FindWriter(first);
  if (!write)
  {
    return Fail(
      "there is no model \"" + first + "\" (see carving-model --help and --list)", WrongUsage);
  }
  for (int i = 2; i < argc; ++i)
  {
    const std::string error = write(argv[i]);
    if (!error.empty())
    {
      return Fail(error, Failure);
    }
  }
  return Success;
}
