"""Meshes that a robot file names: paths inside of the project folder, in a format that is drawn."""

from ropsim.core import Span
from ropsim.exchange.files.folder import SCHEMES, RobotFolder, without_file_scheme
from ropsim.exchange.losses.diagnostics import MESH_MISSING
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes
from ropsim.model import LARGEST_MESH, MESH_ENDINGS, Mesh

_UNDRAWN = Topic(
    LOST_DESCRIPTION,
    "meshes in other formats",
    f"the meshes {{}} are not drawn: read are {', '.join(MESH_ENDINGS)}",
    "convert them to one of these",
)
_LARGE = Topic(
    LOST_DESCRIPTION,
    "large meshes",
    f"the meshes {{}} are not drawn: they have more than {LARGEST_MESH / 1e6:.0f} MB",
    "export them with a coarser tolerance",
)
_SCALED = Topic(
    LOST_DESCRIPTION,
    "mirrored or stretched meshes",
    "the meshes {} are not drawn: they are scaled by other than one positive number",
    "scale or mirror the mesh files themselves",
)


def package_of(name: str) -> str:
    """Return the package of a mesh as a robot file names it, otherwise its folder; bounded in length."""
    name = without_file_scheme(name)
    for scheme in SCHEMES:
        if name.startswith(scheme):
            return shown(scheme + name.removeprefix(scheme).partition("/")[0])
    return shown(name.replace("\\", "/").rpartition("/")[0])


def mesh_of(
    name: str, scale: tuple[float, ...], folder: RobotFolder, span: Span, notes: Notes
) -> Mesh | None:
    """Return the mesh of a file; nothing where it cannot be drawn (noted).

    Args:
        name: as the robot file says it.
        scale: of the three axes [m per unit of the mesh file].
        folder: where meshes are.
        span: of the element that names it.
        notes: for errors.
    """
    path = folder.path(name)
    if path is None:
        notes.absent(MESH_MISSING, package_of(name), span, name, *folder.absence(name))
        return None
    if not folder.has(path):
        path = folder.path(name, beside="") or path  # counted from the folder of the project
    if not path.lower().endswith(MESH_ENDINGS):
        notes.gather(_UNDRAWN, span, [name])
        return None
    if len(set(scale)) > 1 or scale[0] <= 0.0:
        figures = " ".join(f"{one:g}" for one in scale)
        notes.gather(_SCALED, span, [name], f"the first one by {figures}")
        return None
    if not folder.has(path):
        hint = "put it there; the path counts from the folder of the robot file"
        notes.absent(MESH_MISSING, package_of(name), span, name, "not there", hint)
        return None
    if folder.size(path) > LARGEST_MESH:
        notes.gather(_LARGE, span, [name], f"the first one has {folder.size(path) / 1e6:.0f} MB")
        return None
    return Mesh(path, scale[0])
