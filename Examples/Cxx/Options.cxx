// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "LevelWriter.h"
#include "vtkTopologyCarver.h"

#include <cctype>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <getopt.h>
#include <sstream>

const char* const HelpText = R"(NAME
    carve - simplify the topology of a mesh by carving it out of its convex hull

SYNOPSIS
    carve INPUT [-o OUTPUT] [--stream OUT.vtu] [--profile FILE] [LEVELS]
          [PROPERTY OPTIONS]
    carve STREAM.vtu [-o OUTPUT] [--profile FILE] [LEVELS]
          [--manifold-output on|off]
    carve --help | --version

DESCRIPTION
    Reads a triangle mesh, carves it out of its convex hull and prints a table of
    the levels of detail on the way from the hull (level 0) to the mesh itself. In
    that order components split off and tunnels open; every level encloses the
    mesh, lies inside the one before it and does not cross itself. The vertices
    of the levels are vertices of the mesh.

    INPUT may be open, non-manifold or cross itself. Its format is told by the end
    of its name: .obj, .ply, .stl, .off, .vtp or .vtk (legacy, polygonal data), each
    also gzipped (.obj.gz).

    STREAM.vtu is a carving that --stream has stored: any of its levels is given
    without carving again.

OPTIONS
    -o, --output OUTPUT
        Write the levels. The end of the name decides how:
            .vtm                     all levels in one multiblock data set
            .vtp .ply .obj .stl      one file per level: out.ply becomes out_0.ply,
                                     out_1.ply, ...
        .vtm and .vtp keep the levels as they are, with all their arrays. The
        other formats round coordinates; a warning is given where that makes a
        level cross itself.

    --contours
        The polygons and polylines of INPUT, which is .vtp or .vtk, lie in one plane:
        carve their contours out of their convex hull in that plane. Read edge for
        triangle and triangle for tetrahedron. OUTPUT can be .vtm or .vtp.

    --stream OUT.vtu
        Write the whole carving: tetrahedra and triangles with the steps at which
        they vanish and appear.

    --profile FILE
        Write vertices, triangles, components, tunnels, voids and more of every step:
        as a table if the name ends in .csv, as a chart over vertices if it ends in
        .png, for which an X display is needed (or xvfb-run).

LEVELS
    --levels N
        Number of levels, at most 1000, spread so that their vertex counts grow
        geometrically. Default: 8.

    --vertices N,N,...
    --triangles N,N,...
        Instead, a level for each number: the last one that has at most that many
        vertices or triangles, as have all before it.

    --feature-size X,X,...
        A level for each length: gaps wider than about that are open.

    --tunnels N,N,...
    --components N,N,...
        A level for each number: the last one that has at most that many tunnels or
        pieces, as have all before it.

    --error-bound X,X,...
        A level for each length: the first one such that no point of it, or of any
        after it, is farther than that from the mesh.

    --step N,N,...
        A level for each step of the carving.

    --help, --version
        Print this text or the version, and exit.

PROPERTY OPTIONS
    These set what is carved, and in which order. The sections are those of the
    paper "Carving for topology simplification of polygonal meshes".

    --initial-approximation convex-hull|bounding-box|custom
        What level 0 is. The box is grown by a hundredth of its diagonal on every
        side; its corners are new vertices. Default: convex-hull. (Section 3.1)

    --initial-mesh FILE
        The mesh for custom, which this option implies: closed, of genus zero, in
        one piece, without self-intersections, around INPUT.

    --priority-measure longest-edge|volume|circumradius|edge-volume
        Which tetrahedra are carved first: those with the longest edge, the largest
        volume, the largest circumscribed sphere, or the largest geometric mean of
        the longest edge and the cube root of the volume. Default: longest-edge.
        (Section 4)

    --depth-exponent X
        Divides priorities by the depth to the power of X, 0 or more, so that
        carving advances more evenly from all sides. Default: 0. (Section 5.3)

    --depth-measure hierarchy|distance
        What depth is: how many tetrahedra lie on the way from level 0, or the
        distance from it. Default: hierarchy. (Section 5.3)

    --breadth-radius X
        A step carves all tetrahedra within this distance, in the mesh's units, of
        the first one. Default: 0, one tetrahedron a step. (Section 5.4)

    --carve-exposed on|off
        Whether tetrahedra that lose more than one face to the exterior are carved
        along at once; it saves triangles. Default: on. (Section 3.4)

    --carve-voids on|off
        Whether hollows that the mesh encloses are carved too. Default: on.
        (Section 3)

    --maximum-components N
    --maximum-tunnels N
    --maximum-voids N
        The most connected pieces, tunnels (handles) and hollows that any level may
        have. What would exceed it is not carved, so that the last level may not be
        the mesh. 1, 0 and 0 give a tight wrap of it without gaps or holes. Default:
        -1, no limit.

    --solid-rule nonzero-winding|even-odd|surface-only
        What is solid of the space that the mesh encloses: where the mesh winds
        around, what an odd number of surfaces separates from the outside, or
        nothing. Default: nonzero-winding.

    --conformity exact|enclosing|auto
        What happens to a mesh that TetGen does not cope with: an error; nothing, as
        it is not used, and levels enclose the mesh without ending in it; or the
        second where the first fails. Default: auto.

    --enclosing-tolerance X
        How far what cannot be carved may reach from a mesh that is only enclosed, as
        a share of the mesh's diagonal; vertices are added until it holds. 0: none
        are. Default: 0.02.

    --snap-tolerance X
        How far points may be moved where the mesh cannot be met as it is, as a share
        of the mesh's diagonal, so that what nearly touches touches. The mesh is then
        what comes of that. 0: none is. Default: 0. Worth a try: 1e-6.

    --append-input on|off
        Whether a mesh that is only enclosed follows as a last level. Default: off.

    --time-limit SECONDS
    --memory-limit MIB
        The most that one attempt at a tetrahedralization may take, seconds by the
        clock. Default: 0, no limit that you would notice.

    --compute-error on|off
        Whether the distance of every level from the mesh is computed, for the stream
        and the profile: of the farthest point, never too small and at most 1 % too
        large. It takes longer than carving. Default: off, but for --error-bound.

    --keep-both-fold-sides off|on|auto
        Whether a sheet without solid on either side shows with both of its sides,
        as a closed surface. Default: auto, where a maximum of components, tunnels
        or voids is set. (Section 3.3)

    --manifold-output on|off
        Whether levels are cut apart where more than two triangles meet in an edge,
        or several fans of triangles in a vertex. Default: on. (Section 3.3)

OUTPUT
    The table goes to standard output: level, step (how many carving steps were
    taken), vertices, triangles, and of the closed space that the level bounds the
    components (pieces), tunnels and voids (hollows); then the seconds that each
    stage took. Progress is shown on standard error if that is a terminal.

EXIT STATUS
    0   all went well
    1   the mesh could not be read, carved or written
    2   the command line is wrong

ENVIRONMENT
    TOPOLOGYCARVING_HELPER
        Full path of the helper program carving-helper. Needed only where it is not
        found beside this program's library or where it was installed.

EXAMPLES
    carve bones.off
    carve bones.off -o bones.vtm --levels 12
    carve scan.ply.gz -o proxy.stl --triangles 500,5000
    carve scan.ply.gz --stream scan.vtu
    carve scan.vtu --vertices 1000 -o scan_1000.vtp
    carve scan.ply.gz --tunnels 0,2 -o few_tunnels.vtm --profile scan.png
)";

namespace
{

bool EndsIn(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** The whole text is a number. */
bool ToNumber(const std::string& text, double& number)
{
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(number);
}

/** The option that getopt_long has just refused: a letter, or the whole argument before the next. */
std::string GetOffender(char* argv[])
{
  return optopt > 0 && optopt < 128 && std::isprint(optopt) && argv[optind - 1][1] != '-'
    ? std::string("-") + static_cast<char>(optopt)
    : argv[optind - 1];
}

std::string ParseTargets(const std::string& name, const std::string& text, Options& options)
{
  if (!options.Targets.empty())
  {
    return "of --vertices, --triangles, --feature-size, --tunnels, --components, --error-bound and "
           "--step only one can be given, and once";
  }
  options.TargetType = name == "vertices" ? vtkTopologyCarver::VERTICES
    : name == "triangles"                 ? vtkTopologyCarver::TRIANGLES
    : name == "tunnels"                   ? vtkTopologyCarver::TUNNELS
    : name == "components"                ? vtkTopologyCarver::COMPONENTS
    : name == "error-bound"               ? vtkTopologyCarver::ERROR_BOUND
    : name == "step"                      ? vtkTopologyCarver::STEP
                                          : vtkTopologyCarver::FEATURE_SIZE;
  const bool length = options.TargetType == vtkTopologyCarver::FEATURE_SIZE ||
    options.TargetType == vtkTopologyCarver::ERROR_BOUND;
  const double smallest = name == "step" || name == "tunnels" ? 0.0 : 1.0;
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
    options.Targets.push_back(target);
  }
  return options.Targets.empty() ? "--" + name + " wants a number" : "";
}

std::string ParseSwitch(const std::string& name, const std::string& text, bool& value)
{
  value = text == "on";
  return value || text == "off" ? "" : "--" + name + " wants on or off, not \"" + text + "\"";
}

/** The index of the text among the choices, which are separated by |. */
std::string ParseChoice(
  const std::string& name, const std::string& choices, const std::string& text, int& value)
{
  std::istringstream list(choices);
  int index = 0;
  for (std::string choice; std::getline(list, choice, '|'); ++index)
  {
    if (choice == text)
    {
      value = index;
      return {};
    }
  }
  return "--" + name + " wants " + choices + ", not \"" + text + "\"";
}

std::string ParseNotNegative(const std::string& name, const std::string& text, double& value)
{
  return ToNumber(text, value) && value >= 0.0
    ? ""
    : "--" + name + " wants a number of 0 or more, not \"" + text + "\"";
}

std::string ParseShare(const std::string& name, const std::string& text, double& value)
{
  return ToNumber(text, value) && value >= 0.0 && value <= 1.0
    ? ""
    : "--" + name + " wants a number from 0 to 1, not \"" + text + "\"";
}

/** Below 0 there is but -1, for none. */
std::string ParseLimit(const std::string& name, const std::string& text, int& value)
{
  double number = 0.0;
  if (!ToNumber(text, number) || number < -1.0 || number > INT_MAX || number != std::floor(number))
  {
    return "--" + name + " wants a whole number, or -1 for no limit, not \"" + text + "\"";
  }
  value = static_cast<int>(number);
  return {};
}

/** Options that set a property of the filter. */
std::string ParseProperty(const std::string& name, const std::string& text, Options& options)
{
  return name == "initial-approximation"
    ? ParseChoice(name, "convex-hull|bounding-box|custom", text, options.InitialApproximation)
    : name == "priority-measure" ? ParseChoice(name, "longest-edge|volume|circumradius|edge-volume",
                                     text, options.PriorityMeasure)
    : name == "depth-measure" ? ParseChoice(name, "hierarchy|distance", text, options.DepthMeasure)
    : name == "solid-rule"
    ? ParseChoice(name, "nonzero-winding|even-odd|surface-only", text, options.SolidRule)
    : name == "conformity" ? ParseChoice(name, "exact|enclosing|auto", text, options.Conformity)
    : name == "enclosing-tolerance" ? ParseShare(name, text, options.EnclosingTolerance)
    : name == "snap-tolerance"      ? ParseShare(name, text, options.SnapTolerance)
    : name == "append-input"        ? ParseSwitch(name, text, options.AppendInput)
    : name == "time-limit"          ? ParseNotNegative(name, text, options.TimeLimit)
    : name == "memory-limit"        ? ParseNotNegative(name, text, options.MemoryLimit)
    : name == "depth-exponent"      ? ParseNotNegative(name, text, options.DepthExponent)
    : name == "breadth-radius"      ? ParseNotNegative(name, text, options.BreadthRadius)
    : name == "compute-error"       ? ParseSwitch(name, text, options.ComputeError)
    : name == "carve-voids"         ? ParseSwitch(name, text, options.CarveVoids)
    : name == "maximum-components"  ? ParseLimit(name, text, options.MaximumComponents)
    : name == "maximum-tunnels"     ? ParseLimit(name, text, options.MaximumTunnels)
    : name == "maximum-voids"       ? ParseLimit(name, text, options.MaximumVoids)
    : name == "keep-both-fold-sides"
    ? ParseChoice(name, "off|on|auto", text, options.KeepBothFoldSides)
    : name == "manifold-output" ? ParseSwitch(name, text, options.ManifoldOutput)
                                : ParseSwitch(name, text, options.CarveExposed);
}

} // namespace

bool IsStream(const std::string& fileName)
{
  return EndsIn(fileName, ".vtu");
}

std::string Parse(int argc, char* argv[], Options& options)
{
  // clang-format off
  const option known[] = {
    { "output", required_argument, nullptr, 'o' },
    { "contours", no_argument, nullptr, 'c' },
    { "levels", required_argument, nullptr, 'l' },
    { "vertices", required_argument, nullptr, 't' },
    { "triangles", required_argument, nullptr, 't' },
    { "feature-size", required_argument, nullptr, 't' },
    { "tunnels", required_argument, nullptr, 't' },
    { "components", required_argument, nullptr, 't' },
    { "error-bound", required_argument, nullptr, 't' },
    { "step", required_argument, nullptr, 't' },
    { "profile", required_argument, nullptr, 'f' },
    { "stream", required_argument, nullptr, 's' },
    { "initial-mesh", required_argument, nullptr, 'i' },
    { "initial-approximation", required_argument, nullptr, 'p' },
    { "priority-measure", required_argument, nullptr, 'p' },
    { "depth-exponent", required_argument, nullptr, 'p' },
    { "depth-measure", required_argument, nullptr, 'p' },
    { "breadth-radius", required_argument, nullptr, 'p' },
    { "carve-exposed", required_argument, nullptr, 'p' },
    { "carve-voids", required_argument, nullptr, 'p' },
    { "maximum-components", required_argument, nullptr, 'p' },
    { "maximum-tunnels", required_argument, nullptr, 'p' },
    { "maximum-voids", required_argument, nullptr, 'p' },
    { "solid-rule", required_argument, nullptr, 'p' },
    { "conformity", required_argument, nullptr, 'p' },
    { "enclosing-tolerance", required_argument, nullptr, 'p' },
    { "snap-tolerance", required_argument, nullptr, 'p' },
    { "append-input", required_argument, nullptr, 'p' },
    { "time-limit", required_argument, nullptr, 'p' },
    { "memory-limit", required_argument, nullptr, 'p' },
    { "compute-error", required_argument, nullptr, 'p' },
    { "keep-both-fold-sides", required_argument, nullptr, 'p' },
    { "manifold-output", required_argument, nullptr, 'm' },
    { "help", no_argument, nullptr, 'h' },
    { "version", no_argument, nullptr, 'v' },
    {} };
  // clang-format on
  opterr = 0;
  bool levelsGiven = false;
  for (int index = 0;;)
  {
    const int found = getopt_long(argc, argv, ":o:", known, &index);
    if (found == -1)
    {
      break;
    }
    std::string error;
    switch (found)
    {
      case 'h':
        options.Wanted = Options::Action::ShowHelp;
        return {};
      case 'v':
        options.Wanted = Options::Action::ShowVersion;
        return {};
      case 'o':
        options.Output = optarg;
        error = LevelWriter::CheckName(options.Output);
        break;
      case 'c':
        options.Contours = true;
        options.CarvingOption = "--contours";
        break;
      case 'l':
      {
        double number = 0.0;
        levelsGiven = true;
        if (!ToNumber(optarg, number) || number < 1.0 || number > 1000.0 ||
          number != std::floor(number))
        {
          error =
            std::string("--levels wants a whole number from 1 to 1000, not \"") + optarg + "\"";
          break;
        }
        options.NumberOfLevels = static_cast<int>(number);
        break;
      }
      case 't':
        error = ParseTargets(known[index].name, optarg, options);
        break;
      case 's':
        options.Stream = optarg;
        options.CarvingOption = "--stream";
        error = EndsIn(options.Stream, ".vtu") ? "" : "--stream wants a name that ends in .vtu";
        break;
      case 'f':
        options.Profile = optarg;
        error = EndsIn(options.Profile, ".csv") || EndsIn(options.Profile, ".png")
          ? ""
          : "--profile wants a name that ends in .csv or .png";
        break;
      case 'i':
        options.InitialMesh = optarg;
        options.InitialApproximation = vtkTopologyCarver::CUSTOM;
        options.CarvingOption = "--initial-mesh";
        break;
      case 'p':
        options.CarvingOption = std::string("--") + known[index].name;
        [[fallthrough]];
      case 'm':
        error = ParseProperty(known[index].name, optarg, options);
        break;
      case ':':
        error = "the option " + GetOffender(argv) + " wants a value";
        break;
      default:
        error = "unknown option " + GetOffender(argv);
        break;
    }
    if (!error.empty())
    {
      return error;
    }
  }
  if (levelsGiven && !options.Targets.empty())
  {
    return "--levels cannot be combined with other ways to pick levels";
  }
  if (optind != argc - 1)
  {
    return optind == argc ? "no input is given" : "more than one input is given";
  }
  options.Input = argv[optind];
  if (options.InitialApproximation == vtkTopologyCarver::CUSTOM && options.InitialMesh.empty())
  {
    return "--initial-approximation custom wants --initial-mesh FILE";
  }
  if (options.Contours && !EndsIn(options.Output, ".vtm") && !EndsIn(options.Output, ".vtp") &&
    !options.Output.empty())
  {
    return "contours can be written to a name that ends in .vtm or .vtp only";
  }
  if (IsStream(options.Input) && !options.CarvingOption.empty())
  {
    return options.CarvingOption + " wants a mesh: " + options.Input + " has been carved already";
  }
  return {};
}
