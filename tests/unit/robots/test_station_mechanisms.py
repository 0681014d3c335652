"""Mechanisms for stations: where they carry things, and what their drives have to move."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity, inverse_dynamics, mass_matrices
from ropsim.kinematics import body_poses, frames_batch
from ropsim.model import Body, BodyKind, BodyTree, Mechanism, Mover, audit
from ropsim.spatial import Array, Pose

TRACK = robots.linear_track(4.0, carriage_mass=300.0)
TABLE = robots.turntable(0.8, height=0.7, inertia=25.0)
ALL = [TRACK, TABLE]
ROUNDING = 1e-12


def mounting(mechanism: Mechanism, q: float) -> Array:
    return np.asarray(frames_batch(mechanism, [[q]])[0, -1])


@pytest.mark.parametrize("mechanism", ALL, ids=lambda one: one.name)
def test_each_is_sound_and_has_one_axis_with_a_drive(mechanism: Mechanism) -> None:
    assert not [finding for finding in audit(mechanism) if finding.is_error]
    assert (mechanism.n, len(mechanism.drives), mechanism.axis_joints[0].name) == (1, 1, "1")
    assert {origin.kind for origin in mechanism.origins} == {"estimated"}


def test_the_carriage_keeps_the_axes_of_the_floor() -> None:
    expected = Pose(np.array([1.3, 0.0, 0.35])).matrix()
    np.testing.assert_allclose(mounting(TRACK, 1.3), expected, rtol=0, atol=ROUNDING)
    assert (TRACK.lower_limits.tolist(), TRACK.upper_limits.tolist()) == ([-2.0], [2.0])


def test_the_table_turns_about_the_vertical() -> None:
    turned = Pose(np.array([0.0, 0.0, 0.7]), np.array([np.cos(0.2), 0.0, 0.0, np.sin(0.2)])).matrix()
    np.testing.assert_allclose(mounting(TABLE, 0.4), turned, rtol=0, atol=ROUNDING)


@pytest.mark.parametrize(("mechanism", "moved"), [(TRACK, 300.0), (TABLE, 25.0)])
def test_a_drive_moves_the_body_and_its_own_rotor(mechanism: Mechanism, moved: float) -> None:
    drive = mechanism.drives[0]
    inertia = moved + drive.motor.rotor_inertia * drive.ratio**2
    assert mass_matrices(mechanism, [[0.3]])[0, 0, 0] == pytest.approx(inertia, rel=1e-12)
    assert inverse_dynamics(mechanism, [0.3], [0.0], [2.0]) == pytest.approx([2.0 * inertia], rel=1e-12)
    assert gravity(mechanism, [0.3]) == pytest.approx([0.0], abs=1e-9)


def test_a_mechanism_moves_bodies_of_a_cell_as_a_robot_does() -> None:
    """A plate on a table that stands in the world, by the function that places all bodies of cells."""
    tree = BodyTree(
        (
            Body("foot", BodyKind.BASE, "", Pose(np.array([2.0, 0.0, 0.0]))),
            Body("plate", BodyKind.LINK, "foot", TABLE.joints[0].placement, (), Mover("table", 0)),
            Body("box", BodyKind.OBJECT, "plate", Pose(np.array([0.5, 0.0, 0.0]))),
        ),
        {"table": TABLE},
    )
    poses = body_poses(tree, {"table": [[0.0], [np.pi / 2.0]]}, ["box"])["box"]
    np.testing.assert_allclose(poses[0, :3, 3], [2.5, 0.0, 0.7], rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(poses[1, :3, 3], [2.0, 0.5, 0.7], rtol=0, atol=ROUNDING)
