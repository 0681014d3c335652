"""Laws of arm dynamics on random arms."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.codegen import Engine
from ropsim.dynamics import compiled
from ropsim.model import Friction, RobotModel
from support.arms import drive, random_arm, random_states, textbook_mass_matrix
from support.examples import examples

FRICTION = Friction(1e-3, 0.3, -0.2)
ROUNDING = 1e-8  # accelerations up to 1e3, condition of the mass matrix up to 1e4

arms = st.builds(
    lambda seed, types: random_arm(seed, types, (drive(friction=FRICTION),) * len(types)),
    st.integers(0, 10_000),
    st.text("RP", min_size=1, max_size=5),
)
LAWS = settings(max_examples=examples(25), derandomize=True)


@LAWS
@given(robot=arms)
def test_forward_dynamics_undo_inverse_dynamics(robot: RobotModel) -> None:
    functions = compiled(robot, engine=Engine.PYTHON)
    for q, qd, qdd in random_states(robot, 2):
        tau, back = np.empty(robot.n), np.empty(robot.n)
        functions.inverse(q, qd, qdd, np.zeros(6), tau)
        functions.forward(q, qd, tau, back)
        np.testing.assert_allclose(back, qdd, rtol=0, atol=ROUNDING)


@LAWS
@given(robot=arms)
def test_the_mass_matrix_gives_the_kinetic_energy_of_links_and_rotors(robot: RobotModel) -> None:
    """In every pair of velocities, so that an entry on the wrong side of the diagonal shows."""
    n = robot.n
    rotors = np.diag([one.motor.rotor_inertia * one.ratio_at(0.0) ** 2 for one in robot.drives])
    for q, one, other in random_states(robot, 2):
        entries = np.empty(n * n)
        compiled(robot, engine=Engine.PYTHON).mass_matrix(q, entries)
        M = entries.reshape(n, n)
        energy = one @ (textbook_mass_matrix(robot, q) + rotors) @ other
        assert one @ M @ other == pytest.approx(energy, rel=0, abs=ROUNDING)
        assert other @ M @ one == pytest.approx(energy, rel=0, abs=ROUNDING)
        assert np.linalg.eigvalsh(M).min() > 0.0


@LAWS
@given(robot=arms)
def test_columns_of_the_mass_matrix_are_torques_of_unit_accelerations(robot: RobotModel) -> None:
    n = robot.n
    functions = compiled(robot, engine=Engine.PYTHON)
    rest = np.zeros(n)
    q = random_states(robot, 1)[0, 0]
    entries, still, moved = np.empty(n * n), np.empty(n), np.empty(n)
    functions.mass_matrix(q, entries)
    functions.inverse(q, rest, rest, np.zeros(6), still)
    for k, unit in enumerate(np.eye(n)):
        functions.inverse(q, rest, unit, np.zeros(6), moved)
        np.testing.assert_allclose(moved - still, entries.reshape(n, n)[:, k], rtol=0, atol=ROUNDING)


@LAWS
@given(robot=arms, seed=st.integers(0, 1000))
def test_a_wrench_at_the_tip_adds_linearly(robot: RobotModel, seed: int) -> None:
    functions = compiled(robot, engine=Engine.PYTHON)
    rest = np.zeros(robot.n)
    q = random_states(robot, 1)[0, 0]
    wrench = np.random.default_rng(seed).normal(size=6)
    torques = []
    for factor in (0.0, 1.0, 2.0):
        tau = np.empty(robot.n)
        functions.inverse(q, rest, rest, factor * wrench, tau)
        torques.append(tau)
    np.testing.assert_allclose(torques[2] - torques[1], torques[1] - torques[0], rtol=0, atol=ROUNDING)
