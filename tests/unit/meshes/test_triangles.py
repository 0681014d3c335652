"""Normals are smooth over rounded faces and sharp at edges."""

import numpy as np
import pytest

from ropsim.meshes.testing import shaded
from support.meshes import cube_soup, drum

GRID = 2e-4  # normals are rounded to 1/8192


def test_a_cube_keeps_its_edges() -> None:
    cube = shaded(cube_soup())
    assert len(cube.points) == 24  # each corner once per side
    assert np.abs(cube.normals).sum(axis=1) == pytest.approx(np.ones(24), abs=GRID)


def test_a_drum_is_round_about_its_axis_and_sharp_at_its_rims() -> None:
    found = shaded(drum())
    upright = np.abs(found.normals[:, 2]) > 0.5
    assert found.normals[upright][:, :2] == pytest.approx(np.zeros((upright.sum(), 2)), abs=GRID)
    side = found.points[~upright]
    assert len(side) == 64  # each point of both rims once
    assert found.normals[~upright] == pytest.approx(side * [1.0, 1.0, 0.0], abs=GRID)


def test_triangles_keep_their_turn_and_their_places() -> None:
    soup = drum(7)
    found = shaded(soup)
    assert found.points[found.faces] == pytest.approx(soup, abs=1e-6)
    corners = found.points[found.faces].astype(np.float64)
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
    assert volume == pytest.approx(3.5 * np.sin(2.0 * np.pi / 7), rel=1e-6)  # area of a regular heptagon


def test_triangles_without_an_area_are_left_out() -> None:
    soup = cube_soup()
    soup[0, 2] = soup[0, 1]
    assert len(shaded(soup).faces) == 11


def test_corners_of_different_colours_stay_apart() -> None:
    colours = np.zeros((12, 3, 4), dtype=np.uint8)
    colours[0] = 255
    plain, coloured = shaded(cube_soup()), shaded(cube_soup(), colours)
    assert len(coloured.points) > len(plain.points)
    assert coloured.colours is not None
    assert (coloured.colours[coloured.faces] == colours).all()


def test_a_cone_of_very_many_chords_is_drawn() -> None:
    found = shaded(drum(1000))
    assert np.isfinite(found.normals).all()
    assert len(found.faces) == 4000
