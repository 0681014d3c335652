"""Corners between paths that the wrist leads: its joints go on smoothly, through singularities, too."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim.flow import MotionKind, MoveInstruction
from ropsim.model import Payload
from ropsim.planning.testing import CartesianBlend, PlannedMove, Stop, blend_between
from ropsim.spatial import Array, Pose
from support.motion import PUMA, START, planned_stretch, references
from support.walks import shares
from support.wrist_angles import LEADING, TORCH, led, move_through, torch_places

ON_PATH = 1e-6  # [m]
JOINED = 1e-7  # [rad]; the path of the joints goes through samples, to 5e-8 between them
HELD = 1.0 + 1e-9
ZONED = replace(TORCH, zone=0.01)
SEEDS = range(3)
KINDS = MotionKind.LIN, MotionKind.CIRC, MotionKind.SPLINE


def legs_of_two(first: MotionKind, second: MotionKind, seed: int) -> list[PlannedMove]:
    """Return two legs, one after the other, of random moves of two kinds."""
    random = np.random.default_rng(seed)
    counts = {MotionKind.LIN: 1, MotionKind.CIRC: 2, MotionKind.SPLINE: 3}
    q, legs = START, []
    for kind in (first, second):
        way = np.append(random.uniform(-0.15, 0.15, 3), np.zeros(3))
        bends = np.append(random.uniform(-0.03, 0.03, (3, 3)), random.uniform(-0.4, 0.4, (3, 3)), axis=1)
        points = [q + (k + 1) / counts[kind] * way + bends[k] for k in range(counts[kind])]
        legs.append(led(move_through(kind, points, ZONED), q))
        q = legs[-1].q_end
    return legs


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("second", KINDS)
@pytest.mark.parametrize("first", KINDS)
def test_joints_go_over_with_their_first_two_derivatives(
    first: MotionKind, second: MotionKind, seed: int
) -> None:
    before, behind = legs_of_two(first, second, seed)
    found = blend_between(LEADING, before, behind)
    if found is Stop.TURNS_BACK:
        return
    assert isinstance(found, CartesianBlend)
    assert before.joints is not None
    assert behind.joints is not None
    one, other = before.joints.joints(np.array([found.leave])), behind.joints.joints(np.array([found.enter]))
    ends = found.joints.joints(np.array([0.0, found.joints.length]))
    for row, side in enumerate((one, other)):
        length = found.joints.length
        np.testing.assert_allclose(ends.q[row], side.q[0], rtol=0, atol=JOINED)
        np.testing.assert_allclose(ends.d1[row] * length, side.d1[0] * length, rtol=0, atol=1e-5)
        np.testing.assert_allclose(ends.d2[row] * length**2, side.d2[0] * length**2, rtol=0, atol=1e-3)
    s = np.linspace(0.0, found.joints.length, 101)
    away = torch_places(found.joints.joints(s).q) - found.tool.positions(s)
    assert np.abs(away).max() <= ON_PATH


def zigzag() -> tuple[Array, Sequence[MoveInstruction]]:
    """Return a start and lines whose wrist passes its singularity in the corner between them."""
    start = np.array([0.2, 1.1, -2.9, 0.7, -0.3, 0.3])
    middle = start + np.array([0.1, 0.05, 0.0, 0.0, 0.3, 0.1])  # singular there
    end = start + np.array([0.2, 0.0, 0.1, 0.0, 0.6, 0.2])
    return start, [move_through(MotionKind.LIN, [q], ZONED) for q in (middle, end)]


def test_a_corner_in_the_singularity_of_the_wrist_is_flown() -> None:
    start, moves = zigzag()
    done = planned_stretch(moves, start, LEADING)
    assert done.moves[0].zone == pytest.approx(0.01, rel=1e-6)
    assert done.findings == ()
    q, _, _ = references(done)
    assert q[0, 4] < 0.0 < q[-1, 4]
    assert np.abs(q[:, 3] - 0.7).max() < JOINED  # it does not turn over
    assert (np.diff(q[:, 4]) >= -1e-12).all()
    assert max(shares(PUMA, done, Payload()).values()) <= HELD


def test_a_long_way_with_zones_keeps_to_its_lines() -> None:
    random = np.random.default_rng(3)
    q, moves = START, []
    for _ in range(5):
        step = np.append(random.uniform(-0.15, 0.15, 3), random.uniform(-0.5, 0.5, 3))
        q = START + step
        moves.append(move_through(MotionKind.LIN, [q], ZONED))
    done = planned_stretch(moves, START, LEADING)
    assert max(shares(PUMA, done, Payload()).values()) <= HELD
    targets = [move.target.position for move in moves if isinstance(move.target, Pose)]
    assert len(targets) == len(moves)
    corners = [torch_places(np.array([START]))[0], *targets]
    places = torch_places(done.reference.q)
    off = np.full(len(places), np.inf)
    for begin, end in pairwise(corners):
        way = end - begin
        share = np.clip((places - begin) @ way / (way @ way), 0.0, 1.0)
        off = np.minimum(off, np.linalg.norm(places - begin - share[:, None] * way, axis=1))
    outside = np.min([np.linalg.norm(places - corner, axis=1) for corner in corners], axis=0) > 0.0101
    assert outside.any()
    assert off[outside].max() <= ON_PATH
