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
    carve INPUT [-o OUTPUT] [--stream OUT.vtu] [--profile FILE] [--json FILE]
          [LEVELS] [PROPERTY OPTIONS]
    carve INPUT INPUT... [-o OUTPUT] [--threads N] [--json FILE] [LEVELS]
          [PROPERTY OPTIONS]
    carve STREAM.vtu [-o OUTPUT] [--profile FILE] [--json FILE] [LEVELS]
          [--manifold-output on|off]
    carve SURFACE --decimate [--nested] [-o OUTPUT] [--json FILE]
          [--vertices N,... | --triangles N,... | --error-bound X,...]
    carve --help | --version

DESCRIPTION
    Reads a triangle mesh, carves it out of its convex hull and prints a table of
    levels of detail from the hull (level 0) to the mesh itself. From level to
    level, components split off and tunnels open. Every level encloses the mesh,
    lies inside the level before and does not cross itself. The vertices of the
    levels are vertices of the mesh.

    INPUT may be open, non-manifold or cross itself. The end of its name determines
    the format: .obj, .ply, .stl, .off, .vtp or .vtk (legacy, polygonal data), each
    also gzipped (.obj.gz); .vtm, .vtpc, .glb or .gltf, which can have several meshes.

    Each of several inputs, and each mesh of an INPUT with several, is carved by
    itself. They become the blocks of OUTPUT, in the same order and with their names.

    STREAM.vtu is a carving that --stream has stored. Any level can be extracted
    from it without carving again.

    SURFACE is a closed mesh that does not cross itself. With --decimate, it is not
    carved: the levels are surfaces of the same topology with fewer vertices that
    enclose it.

OPTIONS
    -o, --output OUTPUT
        Write the levels. The end of the name determines the format:
            .vtm                     all levels in one multiblock data set
            .vtpc                    all levels in one partitioned data set collection
            .glb                     all levels in one binary glTF file: a node with
                                     normals, its numbers as extras and the name LOD 0,
                                     LOD 1, ... for each; show one of them at a time
            .vtp .ply .obj .stl      one file per level: out.ply becomes out_0.ply,
                                     out_1.ply, ...
        .vtm, .vtpc and .vtp preserve the levels exactly, with all their arrays; .vtpc
        does not have the notes. The other formats round coordinates; if a level then
        crosses itself, a warning says so. Only .vtm, .vtpc and .glb can have the
        levels of several meshes.

        If OUTPUT ends in / or is a folder, each INPUT has a file of its own there,
        which is named after it: a/part.stl becomes OUTPUT/part.vtm.

    --format vtm|vtpc|glb|vtp|ply|obj|stl
        The format of the files in a folder. Default: vtm.

    --contours
        Take the polygons and polylines of INPUT, which is .vtp or .vtk, as contours
        in a plane, and carve them out of their convex hull in that plane. Read edge
        for triangle and triangle for tetrahedron. OUTPUT can be .vtm, .vtpc or .vtp.

    --simplify
        Carve further than a level's number of vertices needs, and decimate the
        result. Such levels are many times closer to the mesh. They still enclose the
        mesh and do not cross themselves, but have new vertices, and need not lie
        inside the level before.

    --decimate
        Decimate SURFACE into surfaces that enclose it, one per number of
        --vertices, --triangles or --error-bound (default: 1000 vertices).

    --nested
        With --decimate: every level lies inside all coarser ones. Otherwise levels
        are tighter.

    --stream OUT.vtu
        Write the whole carving: the tetrahedra and triangles, and the steps at which
        they vanish and appear.

    --profile FILE
        Write the number of vertices, triangles, components, tunnels, voids and more
        for every step: as a table if the name ends in .csv, as a chart over vertices
        if the name ends in .png. The chart needs an X display (or xvfb-run).

    --json FILE
        Write the table in JSON, in UTF-8; to standard output, and nothing else there,
        if FILE is -. The keys:
            objects     one for each mesh: input (the file as given), block (its name
                        in the file; null if the file is a single mesh), notes, and
                        levels: level, step, vertices, triangles, components, tunnels,
                        voids, feature_size, error. Numbers that are unknown or
                        infinite are null.
            notes       those of the whole scene
            warnings, errors, files (that were written), version
            seconds     of each stage, by its name

    --threads N
        The number of processors to use, for several inputs and within each. Default: 0,
        as many as VTK has threads.

    --initial-mesh FILE
        The mesh for the initial approximation custom, which this option implies. The
        mesh must be closed, of genus zero, connected, without self-intersections,
        and around INPUT.

    --help, --version
        Print this text or the version, and exit.

LEVELS
    --levels N
        The number of levels, at most 1000, spread so that their vertex counts grow
        geometrically. Default: 8.

    Instead, each of the following options gives a level for each of its numbers.

    --vertices N,N,...
    --triangles N,N,...
    --tunnels N,N,...
    --components N,N,...
        The last level such that neither it nor any level before has more vertices,
        triangles, tunnels or components than the number.

        With --simplify, the closest level with at most that many vertices or
        triangles that some trials find.

    --feature-size X,X,...
        The level at which gaps wider than about this length, above 0, are open.

    --error-bound X,X,...
        The first level such that no point of it, or of any level after it, is
        farther from the mesh than this length, above 0. With --simplify, the level
        with the fewest vertices that some trials find within this length, or if there
        is none, the closest.

    --step N,N,...
        The level after this number of carving steps.

    A single number of --vertices can be given with --tunnels, --components,
    --feature-size or --step. Their levels are then simplified to that number.

PROPERTY OPTIONS
    These options determine the carving and its order. The sections are those of the
    paper "Carving for topology simplification of polygonal meshes".

)";

constexpr const char* TextAfterProperties = R"(OUTPUT
    The table goes to standard output. Its columns are the level, the step (the number
    of carving steps), vertices and triangles, and the components, tunnels and voids
    (hollows) of the closed space that the level bounds. A line before the table has
    the number of tetrahedra of the carving and the strategy that made them. A last
    line has the seconds of each stage. Progress is shown on standard error if that is
    a terminal.

EXIT STATUS
    0   success
    1   the mesh could not be read, carved or written
    2   the command line is wrong

ENVIRONMENT
    TOPOLOGYCARVING_HELPER
        The full path of the helper program carving-helper. Needed only if the program
        is neither next to the library of this program nor where it was installed.

EXAMPLES
    carve bones.off
    carve bones.off -o bones.vtm --levels 12
    carve bones.off -o bones.glb --json bones.json
    carve left.stl right.stl -o scene.vtm
    carve *.stl -o levels/ --format glb
    carve scan.ply.gz -o proxy.stl --triangles 500,5000
    carve scan.ply.gz --stream scan.vtu
    carve scan.vtu --vertices 1000 -o scan_1000.vtp
    carve scan.ply.gz --tunnels 0,2 -o few_tunnels.vtm --profile scan.png
    carve scan.ply.gz --simplify --vertices 200,1000 -o close.vtm
    carve scan.ply.gz --tunnels 0 --vertices 500 -o closed.vtm
    carve part.stl --decimate --vertices 500,2000 -o proxy.vtm
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
