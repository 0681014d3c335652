"""Which meshes of robot files are drawn, and what is said of the others."""

import pytest

from ropsim.core import Span
from ropsim.exchange import RobotFolder
from ropsim.exchange.testing import Notes, mesh_of
from ropsim.model import MESH_ENDINGS, Mesh

PLACE = Span("arm.urdf", 1, 1, 1, 2)


@pytest.mark.parametrize("ending", [*MESH_ENDINGS, ".STL"])
def test_a_mesh_in_a_format_that_is_read_is_drawn_with_its_scale(ending: str) -> None:
    notes = Notes()
    mesh = mesh_of(f"a{ending}", (0.5, 0.5, 0.5), RobotFolder(), PLACE, notes)
    assert (mesh, notes.found) == (Mesh(f"a{ending}", 0.5), ())


@pytest.mark.parametrize("scale", [(0.0, 0.0, 0.0), (-1.0, -1.0, -1.0), (1.0, 1.0, 2.0)])
def test_a_mesh_is_scaled_by_one_positive_number(scale: tuple[float, ...]) -> None:
    notes = Notes()
    assert mesh_of("a.stl", scale, RobotFolder(), PLACE, notes) is None
    (found,) = notes.found
    figures = " ".join(f"{one:g}" for one in scale)
    assert (found.code, found.span) == ("X995", PLACE)
    assert found.message == (
        "the meshes `a.stl` are not drawn: they are scaled by other than one positive number: "
        f"the first one by {figures}"
    )


@pytest.mark.parametrize("before", ["", "file://", "file:///"])
def test_a_mesh_of_a_package_is_found_behind_the_scheme_of_files(before: str) -> None:
    """Makers write `file:///$(find arm)/...`, where `$(find arm)` is the folder of a package."""
    notes = Notes()
    folder = RobotFolder(packages={"arm": "robots/arm"})
    mesh = mesh_of(f"{before}package://arm/meshes/a.stl", (1.0, 1.0, 1.0), folder, PLACE, notes)
    assert (mesh, notes.found) == (Mesh("robots/arm/meshes/a.stl"), ())


def test_each_missing_mesh_is_counted_and_its_package_named() -> None:
    notes = Notes()
    for number in range(14):
        name = f"file:///package://arm/meshes/a_long_folder_of_one_model_of_the_maker/part_{number}.stl"
        mesh_of(name, (1.0, 1.0, 1.0), RobotFolder(), PLACE, notes)
    (found,) = notes.found
    assert found.message.startswith("14 meshes of `package://arm` are not near to the robot file, such as `")
    assert found.hint == "name the folder of the package: `--package arm=DIR`"
