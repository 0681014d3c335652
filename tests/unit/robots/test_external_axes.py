"""Mechanisms for stations: where they carry things, and what their drives have to move."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity, inverse_dynamics, mass_matrices
from ropsim.kinematics import body_poses, frames_batch
from ropsim.model import Body, BodyKind, BodyTree, IdealMotor, Mechanism, Mover, audit
from ropsim.spatial import Array, Pose

TRACK = robots.linear_track(4.0, carriage_mass=300.0)
TABLE = robots.turntable(0.8, height=0.7, inertia=25.0)
GANTRY = robots.gantry(3.0, 2.0, 2.5, bridge_mass=400.0, trolley_mass=120.0)
TILTING = robots.tilting_turntable(0.4, height=0.9, inertia=10.0)
ALL = [(TRACK, 1), (TABLE, 1), (GANTRY, 2), (TILTING, 2)]
ROUNDING = 1e-12


def mounting(mechanism: Mechanism, *q: float) -> Array:
    return np.asarray(frames_batch(mechanism, [q])[0, -1])


@pytest.mark.parametrize(("mechanism", "axes"), ALL)
def test_each_is_sound_and_has_a_drive_for_each_axis(mechanism: Mechanism, axes: int) -> None:
    assert not [finding for finding in audit(mechanism) if finding.is_error]
    assert (mechanism.n, len(mechanism.drives)) == (axes, axes)
    assert [joint.name for joint in mechanism.axis_joints] == ["1", "2"][:axes]
    assert {origin.kind for origin in mechanism.origins} == {"estimated"}


def test_the_carriage_keeps_the_axes_of_the_floor() -> None:
    expected = Pose(np.array([1.3, 0.0, 0.35])).matrix()
    np.testing.assert_allclose(mounting(TRACK, 1.3), expected, rtol=0, atol=ROUNDING)
    assert (TRACK.lower_limits.tolist(), TRACK.upper_limits.tolist()) == ([-2.0], [2.0])


def test_the_table_turns_about_the_vertical() -> None:
    turned = Pose(np.array([0.0, 0.0, 0.7]), np.array([np.cos(0.2), 0.0, 0.0, np.sin(0.2)])).matrix()
    np.testing.assert_allclose(mounting(TABLE, 0.4), turned, rtol=0, atol=ROUNDING)


def test_the_trolley_of_a_gantry_keeps_the_axes_of_the_floor() -> None:
    expected = Pose(np.array([1.2, -0.7, 2.5])).matrix()
    np.testing.assert_allclose(mounting(GANTRY, 1.2, -0.7), expected, rtol=0, atol=ROUNDING)
    assert (GANTRY.lower_limits.tolist(), GANTRY.upper_limits.tolist()) == ([-1.5, -1.0], [1.5, 1.0])


def test_the_bridge_carries_the_trolley() -> None:
    assert np.diag(mass_matrices(GANTRY, [[0.3, 0.2]])[0]) == pytest.approx(
        [520.0 + rotor(GANTRY, 0), 120.0 + rotor(GANTRY, 1)], rel=1e-12
    )
    assert gravity(GANTRY, [0.3, 0.2]) == pytest.approx([0.0, 0.0], abs=1e-9)


def rotor(mechanism: Mechanism, axis: int) -> float:
    """Return the inertia of a rotor seen at its axis [kg | kg·m²]."""
    drive = mechanism.drives[axis]
    return float(drive.motor.rotor_inertia * drive.ratio_at(0.0) ** 2)


def test_the_plate_of_a_tilting_table_tilts_about_x_and_turns_about_its_own_axis() -> None:
    """Rx(tilt) about a line 100 mm under the plate, then Rz(turn), worked out by hand."""
    tilt, turn = 0.5, 0.8
    c, s, ct, st = np.cos(tilt), np.sin(tilt), np.cos(turn), np.sin(turn)
    expected = np.eye(4)
    expected[:3, :3] = np.array([[1, 0, 0], [0, c, -s], [0, s, c]]) @ np.array(
        [[ct, -st, 0], [st, ct, 0], [0, 0, 1]]
    )
    expected[:3, 3] = [0.0, -0.1 * s, 0.8 + 0.1 * c]
    np.testing.assert_allclose(mounting(TILTING, tilt, turn), expected, rtol=0, atol=ROUNDING)


def test_a_tilted_plate_pulls_at_its_drive() -> None:
    """The centres of mass of plate and cradle lie 75 and 10 mm over the axis of tilting."""
    mass = 2.0 * 10.0 / 0.4**2
    moment = 9.81 * (mass * 0.075 + 90.0 * 0.01)
    assert gravity(TILTING, [0.3, 0.2]) == pytest.approx([-moment * np.sin(0.3), 0.0], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("mechanism", "moved"), [(TRACK, 300.0), (TABLE, 25.0)])
def test_a_drive_moves_the_body_and_its_own_rotor(mechanism: Mechanism, moved: float) -> None:
    inertia = moved + rotor(mechanism, 0)
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


def test_the_drive_of_a_single_axis_has_the_rotor_and_the_friction_that_are_estimated() -> None:
    """Seen at the axis, the inertia of the rotor is three tenths of the load.

    Dry friction is 2 % of its weight on a slide and 5 % of what accelerates it on a turntable; at full speed
    there is as much viscous friction.
    """
    data = robots.AxisData(-0.5, 0.5, 0.8, 2.0, 15.0)
    for robot, dry in (
        (robots.driven_slide((), data), 0.02 * 15.0 * 9.81),
        (robots.driven_rotary((), data), 0.05 * 15.0 * 2.0),
    ):
        (drive,) = robot.drives
        assert isinstance(drive.motor, IdealMotor)
        ratio = drive.ratio_at(0.0)
        assert drive.motor.rotor_inertia * ratio**2 == pytest.approx(0.3 * 15.0)
        assert drive.friction.coulomb_positive * ratio == pytest.approx(dry)
        assert drive.friction.coulomb_negative * ratio == pytest.approx(-dry)
        assert drive.friction.viscous * ratio**2 * 0.8 == pytest.approx(dry)
