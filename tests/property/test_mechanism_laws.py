"""Laws of trees with couplings: against MuJoCo, by virtual work and by energy."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.codegen import Engine
from ropsim.dynamics import compiled, mass_matrices
from ropsim.kinematics import forward_batch, frames_batch, jacobian
from ropsim.model import BASE_LINK, Payload, coordinates
from ropsim.spatial import Array
from support.arms import drive
from support.examples import examples
from support.mujoco_tree import MujocoTree
from support.trees import Tree, random_tree

ROUNDING = 1e-9  # poses of some metres, couplings of couplings
EFFORTS = 1e-8  # [N·m], sums of some thousands
STEP = 1e-6  # of difference quotients
SLOPES = 1e-7  # their error

trees = st.builds(random_tree, st.integers(0, 10_000), st.integers(2, 8))
LAWS = settings(max_examples=examples(25), derandomize=True)


def state(tree: Tree, seed: int = 0) -> Array:
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (3, tree.robot.n))


@LAWS
@given(tree=trees)
def test_joint_coordinates_are_those_of_the_couplings(tree: Tree) -> None:
    made = coordinates(tree.robot)
    np.testing.assert_allclose(made.T, tree.C, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(made.c, tree.c, rtol=0, atol=ROUNDING)


@LAWS
@given(tree=trees)
def test_links_are_where_another_engine_has_them(tree: Tree) -> None:
    (q, _, _), oracle = state(tree), MujocoTree(tree.robot)
    frames = frames_batch(tree.robot, q[np.newaxis])[0]
    np.testing.assert_allclose(frames[:-1], oracle.frames(tree.C @ q + tree.c), rtol=0, atol=ROUNDING)
    at_tip = frames[tree.robot.tip] @ tree.robot.X_nM.matrix()
    np.testing.assert_allclose(frames[-1], at_tip, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(forward_batch(tree.robot, q[np.newaxis])[0], at_tip, rtol=0, atol=ROUNDING)


@LAWS
@given(tree=trees)
def test_the_jacobian_is_the_slope_of_forward_kinematics(tree: Tree) -> None:
    q = state(tree)[0]
    J = jacobian(tree.robot, q)
    for axis in range(tree.robot.n):
        step = STEP * np.eye(tree.robot.n)[axis]
        after, before = forward_batch(tree.robot, np.stack((q + step, q - step)))
        slope = (after - before) / (2.0 * STEP)
        spin = slope[:3, :3] @ ((after + before) / 2.0)[:3, :3].T
        turned = np.array([spin[2, 1] - spin[1, 2], spin[0, 2] - spin[2, 0], spin[1, 0] - spin[0, 1]]) / 2.0
        np.testing.assert_allclose(J[:3, axis], slope[:3, 3], rtol=0, atol=SLOPES)
        np.testing.assert_allclose(J[3:, axis], turned, rtol=0, atol=SLOPES)


@LAWS
@given(tree=trees)
def test_efforts_at_the_axes_do_the_work_of_those_at_all_joints(tree: Tree) -> None:
    """Virtual work: for any motion of the axes, that of the free tree in another engine."""
    (q, qd, qdd), oracle, n = state(tree), MujocoTree(tree.robot), tree.robot.n
    tau = np.empty(n)
    compiled(tree.robot, engine=Engine.PYTHON).rigid_inverse(q, qd, qdd, np.zeros(6), tau)
    at_joints = oracle.inverse(tree.C @ q + tree.c, tree.C @ qd, tree.C @ qdd)
    for virtual in np.eye(n):
        assert tau @ virtual == pytest.approx(at_joints @ (tree.C @ virtual), rel=0, abs=EFFORTS)


@LAWS
@given(tree=trees)
def test_a_wrench_at_the_interface_is_carried_by_the_axes(tree: Tree) -> None:
    q, n = state(tree)[0], tree.robot.n
    functions = compiled(tree.robot, engine=Engine.PYTHON)
    rest, wrench = np.zeros(n), np.array([3.0, -5.0, 2.0, 0.4, 1.0, -0.7])
    free, loaded = np.empty(n), np.empty(n)
    functions.rigid_inverse(q, rest, rest, np.zeros(6), free)
    functions.rigid_inverse(q, rest, rest, wrench, loaded)
    R = forward_batch(tree.robot, q[np.newaxis])[0][:3, :3]
    in_base = np.concatenate((R @ wrench[:3], R @ wrench[3:]))
    np.testing.assert_allclose(loaded - free, jacobian(tree.robot, q).T @ in_base, rtol=0, atol=EFFORTS)


@LAWS
@given(tree=trees)
def test_the_mass_matrix_gives_the_kinetic_energy_of_another_engine(tree: Tree) -> None:
    (q, qd, _), oracle, n = state(tree), MujocoTree(tree.robot), tree.robot.n
    entries = np.empty(n * n)
    compiled(tree.robot, engine=Engine.PYTHON).mass_matrix(q, entries)
    _, kinetic = oracle.energy(tree.C @ q + tree.c, tree.C @ qd)
    assert qd @ entries.reshape(n, n) @ qd / 2.0 == pytest.approx(kinetic, rel=1e-10, abs=EFFORTS)
    at_once = mass_matrices(tree.robot, q[np.newaxis])[0]
    assert qd @ at_once @ qd / 2.0 == pytest.approx(kinetic, rel=1e-10, abs=EFFORTS)


@LAWS
@given(seed=st.integers(0, 10_000), count=st.integers(2, 8))
def test_forward_dynamics_undo_inverse_dynamics_with_drives(seed: int, count: int) -> None:
    tree = random_tree(seed, count, (drive(),) * 8)
    (q, qd, qdd), n = state(tree), tree.robot.n
    functions = compiled(tree.robot, Payload(2.0, np.array([0.1, 0.0, 0.2])), Engine.PYTHON)
    tau, back = np.empty(n), np.empty(n)
    functions.inverse(q, qd, qdd, np.zeros(6), tau)
    functions.forward(q, qd, tau, back)
    np.testing.assert_allclose(back, qdd, rtol=0, atol=1e-7)


@LAWS
@given(tree=trees)
def test_a_payload_is_a_body_at_the_interface(tree: Tree) -> None:
    """Its weight is felt as the wrench that carries it."""
    q, n = state(tree)[0], tree.robot.n
    rest, plain, carried = np.zeros(n), np.empty(n), np.empty(n)
    load = Payload(3.0, np.array([0.1, -0.2, 0.3]))
    compiled(tree.robot, None, Engine.PYTHON).rigid_inverse(q, rest, rest, np.zeros(6), plain)
    compiled(tree.robot, load, Engine.PYTHON).rigid_inverse(q, rest, rest, np.zeros(6), carried)
    R = forward_batch(tree.robot, q[np.newaxis])[0][:3, :3]
    weight = -load.mass * tree.robot.gravity
    wrench = np.concatenate((weight, np.cross(R @ load.com, weight)))
    np.testing.assert_allclose(carried - plain, jacobian(tree.robot, q).T @ wrench, rtol=0, atol=EFFORTS)


def test_random_trees_have_branches_couplings_and_every_type() -> None:
    """The laws above would say little about chains."""
    made = [random_tree(seed, 8).robot for seed in range(40)]
    assert {joint.type for robot in made for joint in robot.joints} == set(type(made[0].joints[0].type))
    parents = [[joint.parent for joint in robot.joints] for robot in made]
    assert any(len(set(row)) < len(row) for row in parents)
    assert any(BASE_LINK in row[1:] for row in parents)
    assert all(robot.couplings for robot in made if robot.n < 8)
