"""The page of parts shows the catalogue as it is."""

from dataclasses import replace

import numpy as np
from tools import part_page

from ropsim.model import Payload
from ropsim.parts import LibraryPart, library_part
from ropsim.spatial import Pose
from ropsim.views import part_print


def test_page_and_pictures_are_those_of_the_catalogue() -> None:
    assert part_page.main(["--check"]) == 0


def shifted(part: LibraryPart, by: float) -> LibraryPart:
    """Return a part whose fixed shapes are moved along x [m]."""
    X = Pose(np.array([by, 0.0, 0.0]))
    return replace(part, shapes=tuple(replace(one, pose=X @ one.pose) for one in part.shapes))


def test_a_picture_depends_on_what_is_drawn_and_not_on_the_last_digits_of_places() -> None:
    part = library_part("two_finger_gripper")
    assert part_print(replace(part, load=Payload())) == part_print(part)
    assert shifted(part, 1e-16) != part
    assert part_print(shifted(part, 1e-16)) == part_print(part)
    assert part_print(shifted(part, 1e-3)) != part_print(part)
    recoloured = tuple(replace(one, colour="#ff0000") for one in part.shapes)
    assert part_print(replace(part, shapes=recoloured)) != part_print(part)
