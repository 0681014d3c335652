"""What messages call the bodies that external axes move."""

import pytest

from ropsim import robots
from ropsim.model import beside, carrying_links, link_name, on_track, spoken_body
from ropsim.spatial import Pose
from support.cells import one_station

ARM = robots.load("puma560")
POSED = beside(on_track(ARM, robots.gantry(3.0, 2.0, 2.5)), robots.tilting_turntable(0.3), Pose())
"""Its joints: bridge, trolley and its plate, six of the arm, cradle and plate of the positioner."""


def test_the_links_that_carry_an_arm_are_all_on_its_way_to_the_floor() -> None:
    assert carrying_links(POSED) == {0, 1, 2}
    assert carrying_links(ARM) == frozenset()


@pytest.mark.parametrize(
    ("link", "words"),
    [(0, "the track"), (1, "the track"), (2, "the track"), (9, "the positioner"), (10, "the positioner")],
)
def test_a_bridge_belongs_to_the_track_and_a_cradle_to_the_positioner(link: int, words: str) -> None:
    cell = one_station("gantry", POSED, robots.default_controller(POSED))
    assert spoken_body(cell, link_name(link + 1)) == words
