"""Diagnostics of mesh files (X880 to X885)."""

from ropsim.core import Severity, define

MESH_MISSING = define(
    "X880",
    "mesh-missing",
    Severity.WARNING,
    "a mesh file is not in the project",
    """
The cell file names a file of triangles that is not there, or that may not be read. The path counts from the
project folder, with `/` between folders; capitals matter on most machines. Everything else is drawn; the
shape appears as a hatched box until the file is there.

```toml
[[objects]]
name = "fixture"
position = [500, 0, 0]
shapes = [{ mesh = "geometry/fixture.stl" }]
```
""",
)

MESH_DAMAGED = define(
    "X881",
    "mesh-damaged",
    Severity.WARNING,
    "a mesh file cannot be read as triangles",
    """
The file is there, but its content is not what its ending says: it is cut short, holds no triangles, holds
coordinates that are no numbers, or has faces at points that it does not hold. Half of a damaged part is not
drawn, since nobody would see that it is half. Export it again from the program that made it. STL (text or
binary), OBJ, PLY and GLB (without compression of meshes) are read; points, curves and textures in them are
not.
""",
)

MESH_OUTSIDE = define(
    "X882",
    "mesh-outside-project",
    Severity.WARNING,
    "a mesh file keeps its triangles in another file",
    """
What a mesh file itself refers to, such as a file of materials, a picture or an address, is never opened: a
project from somebody else must not look around on your disk. A GLB file that keeps its triangles elsewhere is
not drawn. Export it as one file, with everything in the GLB. Where the mesh itself must lie, U962 says.
""",
)

MESH_TOO_LARGE = define(
    "X883",
    "mesh-too-large",
    Severity.WARNING,
    "a mesh file is too large to be drawn",
    """
Files of more than 50 MB or 500,000 triangles are not read: a browser would hardly turn them. CAD programs
export with a tolerance; 0.5 mm is enough to look at, and makes files a hundred times smaller than 0.01 mm.
""",
)

MANY_TRIANGLES = define(
    "X884",
    "many-triangles",
    Severity.WARNING,
    "the meshes of a cell have more triangles than views can turn smoothly",
    """
All meshes of a cell together should stay below 200,000 triangles. Beyond that the views of a machine without
a fast graphics card move in jerks. Nothing is left out. Export the largest mesh with a coarser tolerance, or
draw it by boxes and cylinders.
""",
)

MESH_EXTENT = define(
    "X885",
    "mesh-extent",
    Severity.WARNING,
    "a mesh is far too large or too small for a robot cell",
    """
Most mesh files do not say what their unit is. ropsim takes millimetres for STL, OBJ and PLY and metres for
GLB; with that the mesh is larger than a kilometre or smaller than a hundredth of a millimetre. Give
`scale`, metres per unit of the file.

```toml
shapes = [{ mesh = "geometry/fixture.stl", scale = 0.0254 }]   # inches
```
""",
)
