"""Dynamics of arms with closed chains: cuts say the same as couplings, and functions undo each other."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.dynamics import (
    LoopError,
    effort_rows,
    forward_dynamics,
    gravity,
    gravity_loads,
    inverse_dynamics,
    mass_matrices,
    mass_matrix,
)
from ropsim.model import JointSpring, MechanismError, Payload, RobotModel, Spring
from ropsim.spatial import Array, Pose
from support.closed_arms import (
    COUPLED_PALLETIZER,
    five_bar,
    palletizer,
    two_link_with_cylinders,
)

CUT = palletizer()
CLOSE = 1e-9  # of two formulations, relative; found 4e-15
PAYLOAD = Payload(12.0, np.array([0.05, 0.1, 0.2]), np.diag([0.3, 0.2, 0.4]))


def motions(count: int) -> Array:
    """Return coordinates near home, speeds and accelerations, shape (count, 3, n)."""
    found = np.random.default_rng(3).uniform(-1.0, 1.0, (count, 3, 4))
    return np.asarray(
        found * np.array([0.2, 1.0, 3.0])[:, None] + COUPLED_PALLETIZER.home * np.array([[1.0], [0], [0]])
    )


def differ(one: Array, other: Array) -> float:
    return float(np.abs(one - other).max() / np.abs(other).max())


@pytest.mark.parametrize("payload", [None, PAYLOAD], ids=["alone", "loaded"])
def test_parallelograms_as_cuts_have_the_dynamics_of_couplings(payload: Payload | None) -> None:
    wrench = np.array([30.0, -20.0, 10.0, 1.0, 2.0, 3.0])
    for q, qd, third in motions(4):
        pairs = [
            [gravity(one, q, payload) for one in (CUT, COUPLED_PALLETIZER)],
            [
                inverse_dynamics(one, q, qd, third, wrench, payload=payload)
                for one in (CUT, COUPLED_PALLETIZER)
            ],
            [forward_dynamics(one, q, qd, 100.0 * third, payload) for one in (CUT, COUPLED_PALLETIZER)],
            [mass_matrix(one, q, payload) for one in (CUT, COUPLED_PALLETIZER)],
        ]
        assert max(differ(*pair) for pair in pairs) < CLOSE


def test_functions_of_many_rows_agree_with_couplings_too() -> None:
    rows = motions(6)
    q, qd, qdd = (np.ascontiguousarray(rows[:, k]) for k in range(3))
    assert differ(effort_rows(CUT)(q, qd, qdd), effort_rows(COUPLED_PALLETIZER)(q, qd, qdd)) < CLOSE
    assert differ(mass_matrices(CUT, q), mass_matrices(COUPLED_PALLETIZER, q)) < CLOSE
    assert differ(gravity_loads(CUT, q), gravity_loads(COUPLED_PALLETIZER, q)) < CLOSE


def upright(robot: RobotModel) -> RobotModel:
    """Return a planar arm in whose plane gravity acts."""
    return replace(robot, gravity=np.array([0.0, -9.81, 0.0]))


def sprung(robot: RobotModel) -> RobotModel:
    between = Spring("tie", 0, np.array([0.2, 0.05, 0.0]), 3, np.array([0.1, 0.0, 0.0]), 300.0, 0.1, 2.0)
    on = JointSpring("elbow", 1, 15.0, -0.4, 0.5)
    return replace(robot, springs=(between,), joint_springs=(on,))


ARMS = {
    "cylinders": upright(two_link_with_cylinders()),
    "five-bar": upright(five_bar()),
    "sprung five-bar": sprung(upright(five_bar())),
}


@pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS)
def test_forward_dynamics_undoes_inverse_dynamics(robot: RobotModel) -> None:
    rng = np.random.default_rng(5)
    for shift, qd, qdd in rng.uniform(-1.0, 1.0, (4, 3, 2)):
        q = robot.home + 0.01 * shift
        tau = inverse_dynamics(robot, q, qd, qdd)
        assert forward_dynamics(robot, q, qd, tau) == pytest.approx(qdd, rel=1e-9, abs=1e-9)
        assert mass_matrix(robot, q) == pytest.approx(mass_matrices(robot, q[np.newaxis])[0], rel=1e-9)
        assert gravity(robot, q) == pytest.approx(gravity_loads(robot, q[np.newaxis])[0], rel=1e-9)


def test_a_cylinder_beyond_its_reach_is_named_with_the_gap() -> None:
    robot = ARMS["cylinders"]
    with pytest.raises(LoopError, match=r"closed chains of .* stay .* apart with the axes at 5, ") as caught:
        gravity(robot, [5.0, robot.home[1]])
    assert caught.value.diagnostic.code == "M592"


def test_a_chain_that_is_open_at_home_or_holds_its_axis_is_refused() -> None:
    robot = ARMS["five-bar"]
    (cut,) = robot.cuts
    far = replace(robot, cuts=(replace(cut, X_first=Pose(np.array([9.0, 0.0, 0.0]))),))
    with pytest.raises(MechanismError) as caught:
        gravity(far, far.home)
    assert caught.value.diagnostic.code == "M553"
