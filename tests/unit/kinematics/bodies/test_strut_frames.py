"""Cylinders between their pins: each end on its own, pointing to the other, one sliding in the other."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.collision import Collisions
from ropsim.kinematics import body_poses, frames_batch
from ropsim.model import BodyKind, Cylinder, Strut, StrutEnd, body_tree
from ropsim.spatial import Array, Pose
from support.cells import one_station

CRANE = robots.load("patu655")
X_WB = Pose(np.array([0.3, -0.2, 0.5]), np.array([np.cos(0.4), 0.0, 0.0, np.sin(0.4)]))
CELL = one_station("c", CRANE, robots.default_controller("patu655"), X_WB=X_WB)
TREE = body_tree(CELL)
Q = np.random.default_rng(3).uniform(CRANE.lower_limits, CRANE.upper_limits, (50, CRANE.n))
ROUNDING = 1e-12


def struts() -> list[tuple[str, Strut]]:
    """Return the bodies of the cylinders in order, barrel and rod of each."""
    return [(one.name, one.mover) for one in TREE.bodies if isinstance(one.mover, Strut)]


def pins(strut: Strut) -> tuple[Array, Array]:
    """Return where the pins of a linkage are in the world, shape (k, 3) each: on the carrier, on the link."""
    frames, joint = frames_batch(CRANE, Q), CRANE.joints[strut.joint]
    carrier = np.eye(4) if joint.parent < 0 else frames[:, joint.parent]
    ends = (
        (carrier @ joint.placement.matrix(), strut.linkage.carrier_pin),
        (frames[:, strut.joint], strut.linkage.link_pin),
    )
    one, other = (
        (np.broadcast_to(X_WB.matrix() @ X, (len(Q), 4, 4)) @ [*pin, 1.0])[:, :3] for X, pin in ends
    )
    return one, other


def test_a_crane_has_barrel_and_rod_of_both_cylinders() -> None:
    assert [name for name, _ in struts()] == ["link1/barrel", "link1/rod", "link2/barrel", "link2/rod"]
    assert {one.kind for one in TREE.bodies if isinstance(one.mover, Strut)} == {BodyKind.CYLINDER}


@pytest.mark.parametrize(("name", "strut"), struts())
def test_each_hangs_on_its_pin_and_points_to_the_other(name: str, strut: Strut) -> None:
    X = body_poses(TREE, {CELL.first.name: Q}, [name])[name]
    before, behind = pins(strut)
    way = behind - before
    length = np.array([strut.linkage.length_at(q[CRANE.axes.index(strut.joint)]) for q in Q])
    np.testing.assert_allclose(np.linalg.norm(way, axis=1), length, rtol=0, atol=ROUNDING)
    own = before if strut.end is StrutEnd.CARRIER else behind
    np.testing.assert_allclose(X[:, :3, 3], own, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(X[:, :3, 2], way / length[:, None], rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(
        X[:, :3, :3] @ np.swapaxes(X[:, :3, :3], 1, 2),
        np.broadcast_to(np.eye(3), (len(Q), 3, 3)),
        atol=ROUNDING,
    )
    np.testing.assert_allclose(np.linalg.det(X[:, :3, :3]), 1.0, rtol=0, atol=ROUNDING)


def test_a_rod_slides_in_its_barrel_and_never_leaves_it() -> None:
    bodies = TREE.by_name()
    for (barrel, strut), (rod, _) in zip(struts()[::2], struts()[1::2], strict=True):
        tube, bar = (bodies[name].shapes[0].solid for name in (barrel, rod))
        assert isinstance(tube, Cylinder)
        assert isinstance(bar, Cylinder)
        assert bar.radius < tube.radius
        axis = CRANE.axes.index(strut.joint)
        for q in np.linspace(CRANE.lower_limits[axis], CRANE.upper_limits[axis], 20).tolist():
            inner = (
                strut.linkage.length_at(q) - bar.length
            )  # where the rod begins, from the pin of the barrel
            assert 0.0 <= inner < tube.length < strut.linkage.length_at(q)


def test_they_are_looked_at_with_all_other_bodies_but_each_other() -> None:
    solids = Collisions(CELL)
    assert solids.at_rest == ()
    seen = {name for pair in solids.separation({}).pairs for name in pair}
    assert {name for name, _ in struts()} <= seen
