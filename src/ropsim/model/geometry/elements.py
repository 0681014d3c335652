"""Graphic elements: the solids and lines that links, tools and objects of a cell are drawn with."""

from dataclasses import field
from enum import StrEnum

from ropsim.core import frozen_dataclass
from ropsim.spatial import Pose

Point2 = tuple[float, float]
Point3 = tuple[float, float, float]

LIGHT_GREY = "#c9ced3"
DARK_GREY = "#3d464f"
STEEL_GREY = "#a3abb3"
"""Colour of entities without one."""


class Material(StrEnum):
    """Visual material of a surface: it defines the reflection of light, not the mass."""

    PAINT = "paint"
    STEEL = "steel"
    WOOD = "wood"
    CARDBOARD = "cardboard"
    RUBBER = "rubber"
    GLASS = "glass"


@frozen_dataclass
class Box:
    """A cuboid, centred at the origin.

    Attributes:
        size: edges along x, y, z [m].
    """

    size: Point3


@frozen_dataclass
class Cylinder:
    """A cylinder or, with another radius on top, a cone or frustum; round about z, centred at the origin.

    Attributes:
        radius: at the lower end, z = -length/2 [m].
        length: along z [m].
        top: radius at the upper end [m]; None for the same, 0 for a cone.
    """

    radius: float
    length: float
    top: float | None = None

    @property
    def top_radius(self) -> float:
        """Return the radius at the upper end [m]."""
        return self.radius if self.top is None else self.top


@frozen_dataclass
class Sphere:
    """A sphere about the origin.

    Attributes:
        radius: [m].
    """

    radius: float


@frozen_dataclass
class Revolve:
    """A body of revolution about z.

    Attributes:
        profile: (r, z) from the lower to the upper end [m], r >= 0; open ends stay open.
    """

    profile: tuple[Point2, ...]


@frozen_dataclass
class Prism:
    """A flat outline drawn out along z, from z = 0.

    Attributes:
        outline: simple polygon (x, y) [m], counter-clockwise, the last point joined to the first.
        length: [m].
    """

    outline: tuple[Point2, ...]
    length: float


@frozen_dataclass
class Polyline:
    """Straight lines from point to point; polygons, circles and arcs are made by `outlines`.

    Attributes:
        points: (x, y, z) [m]; a closed line repeats its first point.
    """

    points: tuple[Point3, ...]


MESH_ENDINGS = (".stl", ".obj", ".ply", ".glb", ".dae")
"""Endings of the mesh files that are drawn; `ropsim.meshes` has a reader for each."""


@frozen_dataclass
class Mesh:
    """Triangles in a file of the project.

    Attributes:
        file: path in the project folder, with `/`; it ends with one of `MESH_ENDINGS`.
        scale: metres per unit of the file.
    """

    file: str
    scale: float = 1.0


Solid = Box | Cylinder | Sphere | Revolve | Prism | Polyline | Mesh
"""Every graphic element."""


@frozen_dataclass
class Shape:
    """A graphic element in its place.

    Attributes:
        solid: the element.
        pose: its frame in the frame of the body that it belongs to.
        colour: `#rrggbb`; a mesh with colours of its own keeps those.
        opacity: from 0, invisible, to 1.
        material: how its surface takes the light.
    """

    solid: Solid
    pose: Pose = field(default_factory=Pose)
    colour: str = LIGHT_GREY
    opacity: float = 1.0
    material: Material = Material.PAINT
