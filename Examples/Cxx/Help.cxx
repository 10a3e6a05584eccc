// SPDX-License-Identifier: BSD-3-Clause
#include "Help.h"

#include "vtkCarverProperty.h"
#include "vtkNew.h"
#include "vtkTopologyCarver.h"

#include <cctype>
#include <sstream>

namespace
{

constexpr const char* TextBeforeProperties = R"(NAME
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

    --initial-mesh FILE
        The mesh for the initial approximation custom, which this option implies:
        closed, of genus zero, in one piece, without self-intersections, around
        INPUT.

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

)";

constexpr const char* TextAfterProperties = R"(OUTPUT
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

/** Breaks a text into indented lines of at most 80 characters. */
std::string Wrap(const std::string& text)
{
  const std::string indent(8, ' ');
  std::istringstream words(text);
  std::string lines, line = indent;
  for (std::string word; words >> word;)
  {
    if (line.size() + 1 + word.size() > 80)
    {
      lines += line + "\n";
      line = indent;
    }
    line += (line == indent ? "" : " ") + word;
  }
  return lines + line + "\n";
}

std::string DescribeProperties()
{
  vtkNew<vtkTopologyCarver> carver;
  std::string text;
  for (const vtkCarverProperty& property : vtkCarverProperty::GetAll())
  {
    if (!property.Help.empty())
    {
      const std::string choices = ListChoices(property);
      text += "    --" + ToOption(property.Name) + " " +
        (!choices.empty()        ? choices
            : property.IsInteger ? "N"
                                 : "X") +
        "\n" + Wrap(property.Help + " Default: " + ToOption(property.GetText(carver)) + ".") + "\n";
    }
  }
  return text;
}

} // namespace

std::string ToOption(const std::string& name)
{
  std::string option;
  bool afterLower = false;
  for (const unsigned char c : name)
  {
    option += afterLower && std::isupper(c) ? "-" : "";
    option += c == '_' ? '-' : static_cast<char>(std::tolower(c));
    afterLower = std::islower(c) != 0;
  }
  return option;
}

std::string ListChoices(const vtkCarverProperty& property)
{
  std::string list;
  for (const std::string& choice : property.Choices)
  {
    list += (list.empty() ? "" : "|") + ToOption(choice);
  }
  return list;
}

std::string GetHelp()
{
  return TextBeforeProperties + DescribeProperties() + TextAfterProperties;
}
