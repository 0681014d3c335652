"""Boxes of parts, and the gaps on the lines through their footprints, beside plain formulas."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.kinematics import NO_BLOCKS, Standing, height_above, part_blocks, stacked, standings
from ropsim.model import Part
from ropsim.spatial import Array, Pose
from support.examples import examples

ROUNDING = 1e-12
"""Of a dozen products of numbers about 1 m."""
GAP = 0.005
TURNS = st.lists(st.floats(-1.0, 1.0), min_size=4, max_size=4).filter(lambda q: np.linalg.norm(q) > 0.1)
PLACES = st.lists(st.floats(-0.05, 0.05), min_size=3, max_size=3)


def turned(place: list[float], turn: list[float]) -> Pose:
    return Pose(np.array(place), np.array(turn) / np.linalg.norm(turn))


def box_of(name: str, pose: Pose) -> tuple[Part, Pose]:
    return Part(name, np.array([0.06, 0.05, 0.04]), 0.1, pose), pose


@settings(max_examples=examples(30), derandomize=True, deadline=None)
@given(PLACES, TURNS)
def test_the_box_of_a_part_hangs_from_the_middle_of_its_top(place: list[float], turn: list[float]) -> None:
    pose = turned(place, turn)
    blocks = part_blocks([box_of("p", pose)])
    R, half = pose.rotation(), np.array([0.03, 0.025, 0.02])
    corners = np.array(
        [pose.position + R @ (half * (x, y, z - 1.0)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    )
    assert blocks.rotations[0] == pytest.approx(R, abs=ROUNDING)
    assert blocks.centres[0] == pytest.approx(corners.mean(axis=0), abs=ROUNDING)
    assert blocks.halves[0].tolist() == half.tolist()
    assert blocks.low[0] == pytest.approx(corners.min(axis=0), abs=ROUNDING)
    assert blocks.high[0] == pytest.approx(corners.max(axis=0), abs=ROUNDING)


def span(pose: Pose, x: float, y: float) -> Array | None:
    """Return between which heights a vertical line is within a part [m]: where it cuts faces of the box."""
    half, X = np.array([0.03, 0.025, 0.02]), pose.inverse()
    place = X.position + X.rotation() @ [x, y, 0.0] + [0.0, 0.0, 0.02]
    along = X.rotation()[:, 2]
    cuts = [
        (side * half[k] - place[k]) / along[k] for k in range(3) if abs(along[k]) > 1e-12 for side in (-1, 1)
    ]
    within = [z for z in cuts if (np.abs(place + z * along) <= half + ROUNDING).all()]
    return np.array([min(within), max(within)]) if within else None


@settings(max_examples=examples(60), derandomize=True, deadline=None)
@given(PLACES, TURNS, PLACES, TURNS)
def test_the_gap_below_a_part_is_the_least_on_its_lines(
    place: list[float], turn: list[float], other: list[float], other_turn: list[float]
) -> None:
    high = turned([place[0], place[1], place[2] + 0.15], turn)
    low = turned([other[0], other[1], other[2] + 0.05], other_turn)
    part, below = part_blocks([box_of("high", high)]), part_blocks([box_of("low", low)])
    inset = np.minimum(0.002, 0.1 * (part.high - part.low))[0]
    xs, ys = (np.linspace(part.low[0, k] + inset[k], part.high[0, k] - inset[k], 7) for k in (0, 1))
    both = [(span(high, x, y), span(low, x, y)) for x in xs for y in ys]
    met = [(one, two) for one, two in both if one is not None and two is not None]
    is_below = below.low[0, 2] < part.low[0, 2] - ROUNDING
    gaps = [one[0] - two[1] for one, two in met if two[0] < one[0] and is_below]
    depth = max([two[1] - one[0] for one, two in met if one[0] < two[1] and one[1] > two[0]], default=0.0)
    (found,) = standings(part, stacked([below, part]), GAP)
    assert found.depth == pytest.approx(depth if depth > 1e-9 else 0.0, abs=1e-8)
    if gaps and min(gaps) < part.low[0, 2] - ROUNDING:  # else the floor is nearer to its lowest corner
        height, name = height_above(part, 0, below)
        assert name == "low"
        assert height == pytest.approx(min(gaps), abs=1e-8)


def test_nothing_carries_where_nothing_is() -> None:
    many = part_blocks([box_of(f"p{k}", Pose(np.array([0.0, 0.0, 1.0 + k]))) for k in range(6)])
    assert standings(many, NO_BLOCKS, GAP) == [Standing(None)] * 6
    assert standings(NO_BLOCKS, many, GAP) == []
