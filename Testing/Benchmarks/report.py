# SPDX-License-Identifier: BSD-3-Clause
"""The tables of measured meshes, in Markdown."""
import growth
from measure import AFTER_TETGEN, WRAPS

STAGES = ("read", "clean", "resolve", "attempts", "tetrahedralize", "transfer", "classify", "carve", "measure",
          "output", "write")
SECONDS = (*STAGES, "whole", "carve, budget")
DECIMATIONS = ("vtkQuadricDecimation", "vtkDecimatePro", "vtkQuadricClustering")
PEERS = ("TetGen", *("wrap " + size for size in WRAPS), *DECIMATIONS)
MEMORY = ("host memory", "helper memory", "TetGen memory")
MILLION = 1e6


def ratio_to(name, *parts):
    """A function of a sample: the sum of the parts divided by the figure `name`."""
    return lambda sample: sum(sample[part] for part in parts) / sample[name]


def formatted(value, digits):
    return "–" if value is None else f"{value:.{digits}f}"


def scaled(value, factor):
    return None if value is None else value * factor


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|",
                      *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def sizes(meshes):
    return table(["mesh", "vertices", "tetrahedra", "strategy", "tetrahedra of TetGen"],
                 [[mesh.name, str(mesh.vertices), str(mesh.tetrahedra), mesh.strategy,
                   str(mesh.tetgen_tetrahedra or "–")] for mesh in meshes])


def seconds(meshes, figures):
    return table(["mesh", *figures],
                 [[mesh.name, *(formatted(mesh.median(name), 3) for name in figures)] for mesh in meshes])


def nanoseconds(meshes):
    return table(["mesh", *SECONDS],
                 [[mesh.name, *(formatted(scaled(mesh.median(name), 1e9 / mesh.tetrahedra), 0) for name in SECONDS)]
                  for mesh in meshes])


def memory(meshes):
    rows = []
    for mesh in meshes:
        peaks = [mesh.median(name) for name in MEMORY]
        rows.append([mesh.name, *(formatted(scaled(peak, 1 / 2**20), 0) for peak in peaks),
                     *(formatted(scaled(peak, 1 / mesh.tetrahedra), 0) for peak in peaks)])
    return table(["mesh", "host, MiB", "helper", "TetGen", "host, bytes/tetrahedron", "helper", "TetGen"], rows)


def exponents(meshes):
    families = growth.families(meshes)
    names = [*SECONDS, *PEERS, *MEMORY]
    return table(["figure", *families],
                 [[name, *(formatted(growth.exponent(members, name), 2) for members in families.values())]
                  for name in names])


def ratios(meshes):
    head = ["mesh", "whole ÷ TetGen", "the same, processor", "after TetGen ÷ TetGen", "clean + resolve ÷ TetGen",
            "carve, µs/tetrahedron", "measure, µs/tetrahedron", "measure ÷ TetGen", "transfer ÷ TetGen",
            "host memory, bytes/tetrahedron", "whole ÷ wrap d/100"]
    rows = []
    for mesh in meshes:
        rows.append([
            mesh.name,
            formatted(mesh.median(ratio_to("TetGen", "whole")), 2),
            formatted(mesh.median(ratio_to("TetGen processor", "processor")), 2),
            formatted(mesh.median(ratio_to("TetGen", *AFTER_TETGEN)), 2),
            formatted(mesh.median(ratio_to("TetGen", "clean", "resolve")), 2),
            formatted(scaled(mesh.median("carve"), MILLION / mesh.tetrahedra), 2),
            formatted(scaled(mesh.median("measure"), MILLION / mesh.tetrahedra), 2),
            formatted(mesh.median(ratio_to("TetGen", "measure")), 2),
            formatted(mesh.median(ratio_to("TetGen", "transfer")), 2),
            formatted(scaled(mesh.median("host memory"), 1.0 / mesh.tetrahedra), 0),
            formatted(mesh.median(ratio_to("wrap d/100", "whole")), 2)])
    return table(head, rows)


TEXT = """# Times and memory

`{command}` made this page:

{machine}

Every figure is the median of {repetitions} repetition(s), in each of which all programs run one after the other on the
same mesh. Compare ratios: seconds depend on the machine and on its load. "–": the program failed.

![Seconds over vertices](growth.svg)

## Ratios

"TetGen" is the whole time of Debian's bare program, which has the flags of carve's first attempt with TetGen (`{flags}`),
reads OFF and writes nothing. It refuses meshes that cross themselves. "whole" is
`carve MESH.ply --levels 8 -o levels.vtm --profile profile.csv`, with binary PLY. The ratio of processor seconds depends
less on other programs. "after TetGen" are the stages {after}. Tetrahedra are those
of the stream, which for a closed mesh are outside the solid; TetGen makes those inside, too.

{ratios}
## Growth

The exponents of the numbers of vertices, by least squares in logarithms from {smallest} vertices on.

{exponents}
## Meshes

{sizes}
## Seconds

The stages are those that `carve` prints: "measure" is the profile, "output" are the eight levels, the stream and their
arrays in memory, "write" is the levels as files. "carve, budget" is the stage "carve" of another run, with at most one
component, no tunnel and no void.

{seconds}
## Nanoseconds per tetrahedron

{nanoseconds}
## Seconds of other programs

"wrap" is CGAL's alpha wrap with alpha as a part of the mesh's diagonal and an offset of alpha/30, without reading and
writing. Decimations remove nine tenths of the triangles; clustering has VTK's default divisions.

{peers}
## Peak memory

Resident memory of `carve`, of the largest process of its helper, and of TetGen, looked at every 10 milliseconds.

{memory}"""


def page(meshes, **facts):
    return TEXT.format(ratios=ratios(meshes), exponents=exponents(meshes), sizes=sizes(meshes),
                       seconds=seconds(meshes, SECONDS), nanoseconds=nanoseconds(meshes), peers=seconds(meshes, PEERS),
                       memory=memory(meshes), smallest=growth.SMALLEST, after=", ".join(AFTER_TETGEN), **facts)
