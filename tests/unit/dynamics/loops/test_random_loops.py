"""Random closed chains in space obey d'Alembert's principle, found from poses of their bodies alone.

The poses come from `kinematics`, as functions of time along a motion of the axes, and are differentiated
numerically; the equations of motion of each free body give the power of a virtual motion of each axis.
"""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled, free_motion
from ropsim.kinematics import frames_batch, joint_motion, loop_freedom, loop_gaps
from ropsim.model import Mechanism, passive_coordinates
from ropsim.spatial import Array
from support.arms import random_link
from support.random_loops import random_loop

STEP = 1e-3
"""Of differences of fourth order [s]."""
BLOCK = 85
"""Seeds of a test: about fifty of them make chains that move."""
STEEPEST = 5.0
"""Largest ratio of speeds of a coordinate and an axis [rad | m over rad | m]."""
AGREED = 1e-5
"""Relative difference of torques: errors of differences where a chain is fast; found 1e-6 at most."""
FIRST = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12.0
SECOND = np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / 12.0


def heavy_loop(seed: int) -> Mechanism:
    rng = np.random.default_rng(seed)
    loop = random_loop(seed)
    return replace(
        loop, links=tuple(random_link(rng) for _ in loop.joints), gravity=rng.uniform(-10.0, 10.0, 3)
    )


def motion(q: Array, qd: Array, qdd: Array, times: Array) -> Array:
    return np.asarray(q + times[:, None] * qd + 0.5 * times[:, None] ** 2 * qdd)


def virtual_torques(loop: Mechanism, q: Array, qd: Array, qdd: Array) -> Array:
    """Return the torques of the axes by d'Alembert's principle, shape (n,)."""
    times = STEP * np.arange(-2.0, 3.0)
    frames = frames_batch(loop, motion(q, qd, qdd, times))
    beside = [
        frames_batch(loop, q + times[:, None] * axis / STEP * 1e-3) for axis in np.eye(loop.n)
    ]  # virtual motions of each axis
    tau = np.zeros(loop.n)
    for number, link in enumerate(loop.links):
        R, c = frames[:, number, :3, :3], frames[:, number] @ np.array([*link.com, 1.0])
        acceleration = np.tensordot(SECOND, c[:, :3], 1) / STEP**2
        rates = np.tensordot(FIRST, R, 1) / STEP
        w = turn(rates @ R[2].T)
        wd = turn(np.tensordot(SECOND, R, 1) / STEP**2 @ R[2].T)
        inertia = R[2] @ link.inertia @ R[2].T
        force = link.mass * (acceleration - loop.gravity)
        moment = inertia @ wd + np.cross(w, inertia @ w)
        for axis, found in enumerate(beside):
            moved = np.tensordot(FIRST, (found[:, number] @ np.array([*link.com, 1.0]))[:, :3], 1) / 1e-3
            turned = turn(np.tensordot(FIRST, found[:, number, :3, :3], 1) / 1e-3 @ R[2].T)
            tau[axis] += force @ moved + moment @ turned
    return tau


def turn(S: Array) -> Array:
    """Return the vector of the antisymmetric part of a matrix."""
    return np.array([S[2, 1] - S[1, 2], S[0, 2] - S[2, 0], S[1, 0] - S[0, 1]]) / 2.0


def chosen(seeds: range) -> list[tuple[int, Mechanism, Array, Array, Array]]:
    """Return loops with motions of their axes in places where no coordinate runs away: not near singular."""
    found = []
    for seed in seeds:
        loop, rng = heavy_loop(seed), np.random.default_rng(seed + 1)
        qd, qdd = rng.uniform(-0.5, 0.5, (2, loop.n))
        q = rng.uniform(-0.1, 0.1, loop.n)
        near = motion(q, qd, qdd, STEP * np.arange(-2.0, 3.0))
        if loop_freedom(loop) or loop_gaps(loop, near).max() > 1e-12:
            continue
        if np.abs(joint_motion(loop, np.tile(q, (loop.n, 1)), np.eye(loop.n)).speed).max() < STEEPEST:
            found.append((seed, loop, q, qd, qdd))
    return found


@pytest.mark.parametrize("block", range(4))
def test_random_loops_obey_d_alembert(block: int) -> None:
    loops = chosen(range(BLOCK * block, BLOCK * (block + 1)))
    assert len(loops) >= BLOCK // 2
    for seed, loop, q, qd, qdd in loops:
        tau, back = np.empty((2, loop.n))
        functions = compiled(loop, engine=Engine.PYTHON)
        functions.inverse(q, qd, qdd, np.zeros(6), tau)
        wanted = virtual_torques(loop, q, qd, qdd)
        assert np.abs(tau - wanted).max() < AGREED * max(1.0, np.abs(wanted).max()), seed
        functions.forward(q, qd, tau, back)
        assert back == pytest.approx(qdd, rel=1e-9, abs=1e-9), seed


def passive(loop: Mechanism, Q: Array, speeds: Array) -> tuple[Array, Array]:
    """Return coordinates that chains determine, and their speeds, for axes at Q (k, n), each (k, p)."""
    found, places = joint_motion(loop, Q, speeds), list(passive_coordinates(loop))
    return found.position[:, places], found.speed[:, places]


def energy(loop: Mechanism, q: Array, qd: Array) -> float:
    """Return kinetic and potential energy [J], by differences of the poses of the bodies."""
    frames = frames_batch(loop, motion(q, qd, np.zeros(loop.n), STEP * np.arange(-2.0, 3.0)))
    total = 0.0
    for number, link in enumerate(loop.links):
        R, c = frames[:, number, :3, :3], (frames[:, number] @ np.array([*link.com, 1.0]))[:, :3]
        v, w = np.tensordot(FIRST, c, 1) / STEP, turn(np.tensordot(FIRST, R, 1) / STEP @ R[2].T)
        total += 0.5 * link.mass * v @ v + 0.5 * w @ R[2] @ link.inertia @ R[2].T @ w
        total -= link.mass * loop.gravity @ c[2]
    return float(total)


def test_random_loops_keep_their_energy_and_the_assembly_of_kinematics() -> None:
    """One of them runs into a dead centre, behind which the axes do not say where the chain is."""
    regular = 0
    for seed, loop, q, qd, _ in chosen(range(40)):
        z, zd = passive(loop, q[np.newaxis], qd[np.newaxis])
        moved = free_motion(loop, [*q, *z[0]], [*qd, *zd[0]], STEP, 60, every=20, engine=Engine.PYTHON)
        axes, speeds = moved.y[:, : loop.n], moved.yd[:, : loop.n]
        assert moved.gap.max() < 1e-9, seed
        if np.abs(moved.yd).max() > STEEPEST:
            continue
        regular += 1
        wanted = passive(loop, axes, speeds)
        assert np.abs(moved.y[:, loop.n :] - wanted[0]).max() < 1e-11, seed
        assert np.abs(moved.yd[:, loop.n :] - wanted[1]).max() < 1e-10, seed
        energies = np.array([energy(loop, *one) for one in zip(axes, speeds, strict=True)])
        assert np.abs(energies - energies[0]).max() < 1e-9 * max(1.0, np.abs(energies).max()), seed
    assert regular >= 20
