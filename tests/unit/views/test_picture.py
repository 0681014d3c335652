"""Pictures of robots: what is nearest is seen, all of the arm is in them, and they say of what they are."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import Box, Cylinder, Mesh, Prism, Shape, Sphere
from ropsim.spatial import Pose
from ropsim.views import PictureOptions, has_no_shapes, picture_print, png_words, robot_png
from ropsim.views.testing import DepthBuffer, facets
from support.png import read_png

SMALL = PictureOptions(width=60, finer=1)
L_SHAPE = ((0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.1, 0.1), (0.1, 0.4), (0.0, 0.4))


@pytest.mark.parametrize(
    ("shape", "volume", "within"),
    [
        (Shape(Box((0.2, 0.3, 0.5)), Pose(np.array([1.0, -2.0, 0.5]))), 0.03, 1e-12),
        (Shape(Prism(L_SHAPE, 0.5)), 0.5 * (0.03 + 0.03), 1e-12),
        (Shape(Cylinder(0.1, 0.4, 0.05)), np.pi * 0.4 / 3.0 * (0.01 + 0.005 + 0.0025), 1e-2),
        (Shape(Sphere(0.2)), 4.0 / 3.0 * np.pi * 0.008, 2e-2),
    ],
)
def test_facets_close_around_the_volume_of_their_solid(shape: Shape, volume: float, within: float) -> None:
    a, b, c = facets(shape).transpose(1, 0, 2)
    assert float(np.sum(a * np.cross(b, c)) / 6.0) == pytest.approx(volume, rel=within)


def test_of_two_triangles_the_nearer_one_is_seen() -> None:
    far = np.array([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]])
    near = far + np.array([2.0, 2.0, 1.0])
    for order in ((far, near), (near, far)):
        buffer = DepthBuffer(12, 12)
        buffer.draw(np.array(order))
        assert buffer.depth[3, 3] == 1.0
        assert buffer.depth[1, 1] == 0.0
        assert buffer.seen[11, 11] == -1


def test_a_picture_shows_all_of_the_arm_in_its_colours_and_says_of_what_it_is() -> None:
    robot = robots.load("kr6_r900_2")
    content = robot_png(robot, SMALL)
    picture = read_png(content)
    assert picture.shape == (60, 60, 3)
    orange = (picture[..., 0] > 1.6 * picture[..., 2]) & (picture[..., 0] > 100.0)
    rows, columns = np.nonzero(orange)
    assert max(rows.max() - rows.min(), columns.max() - columns.min()) > 45
    assert 0 < rows.min() < rows.max() < 59
    assert png_words(content) == {"Title": "kr6_r900_2", "Source": picture_print(robot, SMALL)}


def test_another_state_of_a_model_has_another_print() -> None:
    prints = {picture_print(robots.load(name)) for name in ("gp7", "gp25", "two_link")}
    assert len(prints) == 3
    assert picture_print(robots.load("gp7"), SMALL) not in prints


def test_an_arm_without_shapes_or_with_meshes_alone_is_drawn_by_its_axes() -> None:
    whole = robots.load("ur5e")
    links = tuple(replace(link, shapes=()) for link in whole.links)
    bare = replace(whole, base_shapes=(), links=links)
    meshes = replace(bare, base_shapes=(Shape(Mesh("meshes/base.stl")),))
    assert [has_no_shapes(one) for one in (whole, bare, meshes)] == [False, True, True]
    from_axes, from_meshes = (read_png(robot_png(one, SMALL)) for one in (bare, meshes))
    np.testing.assert_array_equal(from_axes, from_meshes)
    assert np.count_nonzero(from_axes.max(axis=2)) > 60  # of 3600 points: an arm, not its shadow alone
