"""Mechanisms that move by themselves: gravity, springs and constant efforts at the axes, without drives."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Compiled, Engine, GivenCode, SourceFunction, Tracer, bound, default_engine, load
from ropsim.dynamics.loops.plant_code import LoopState, motion_code, plant_formulas
from ropsim.dynamics.loops.step_code import step_code
from ropsim.dynamics.structure import ArmStructure, arm_numbers, structure_of, traced_numbers
from ropsim.dynamics.traced.traced_arm import trace_arm
from ropsim.model import Mechanism
from ropsim.spatial import Array


class FreeMotion(NamedTuple):
    """A motion of a mechanism, row by row.

    Attributes:
        y: coordinates of the axes, then of closed chains [rad | m], shape (k, n + p).
        yd: their speeds, shape (k, n + p).
        gap: the most that a step of the integration leaves between frames of closed chains, before they are
            put together again [m, rad], shape (k,).
    """

    y: Array
    yd: Array
    gap: Array


def free_motion(
    robot: Mechanism,
    y: npt.ArrayLike,
    yd: npt.ArrayLike,
    step: float,
    count: int,
    *,
    tau: npt.ArrayLike | None = None,
    every: int = 1,
    engine: Engine | None = None,
) -> FreeMotion:
    """Return how a mechanism moves from a state on, by the classical Runge-Kutta method with projection.

    Args:
        robot: whose drives do not count.
        y: coordinates of axes and closed chains at the start, near to a closed position, shape (n + p,).
        yd: their speeds, shape (n + p,); both are put on the closed chains first.
        step: of the integration [s].
        count: number of steps.
        tau: constant efforts at the axes [N·m | N], shape (n,); None for none.
        every: steps from one row to the next.
        engine: who runs the code; None takes numba where it is installed.

    Returns:
        Rows at the start and after each `every` steps.
    """
    structure = structure_of(robot)
    n = structure.n
    state = _state(structure)
    x = np.zeros(state.stop)
    x[state.places], x[state.speed_places] = y, yd
    efforts = np.zeros(n) if tau is None else np.array(tau, np.float64)
    rows = np.empty((count // every + 1, len(x)))
    _moving(robot, engine or default_engine())(efforts, step, every, x, rows)
    return FreeMotion(rows[:, state.places], rows[:, state.speed_places], rows[:, state.gap])


def _state(structure: ArmStructure) -> LoopState:
    n, p = structure.n, structure.passive
    first = 2 * n
    return LoopState(n, range(first, first + p), range(first + p, first + 2 * p), range(0), first + 2 * p)


@lru_cache(maxsize=32)
def _moving(robot: Mechanism, engine: Engine) -> Compiled:
    structure = structure_of(robot)
    code = _plant(structure)
    rows = SourceFunction("free_rows", "void(f8[::1], f8[::1], f8, i8, f8[::1], f8[:,::1])", _ROWS)
    functions = (
        *code.functions,
        *motion_code(_state(structure), structure.rows),
        step_code(_state(structure)),
        rows,
    )
    return bound(load("free_motion", functions, engine), code.constants(arm_numbers(robot)))


@lru_cache(maxsize=32)
def _plant(structure: ArmStructure) -> GivenCode:
    tracer, state = Tracer(), _state(structure)
    y = [tracer.variable(f"x[{place}]") for place in state.places]
    yd = [tracer.variable(f"x[{place}]") for place in state.speed_places]
    arm = trace_arm(tracer, structure, traced_numbers(tracer, structure), y)
    net, none = tracer.variables("u", structure.n), [tracer.constant(0.0)] * structure.n
    return GivenCode.of(*plant_formulas(arm, structure.cuts, yd, (net, none), []))


_ROWS = """\
def free_rows(constants, u, h, every, x, rows):
    stages = np.empty((5, x.shape[0]))
    settle(x, constants)
    for row in range(rows.shape[0]):
        if row > 0:
            for _ in range(every):
                loop_step(x, u, h, stages, constants)
        for j in range(x.shape[0]):
            rows[row, j] = x[j]
"""
