"""Planning the sequences of a program again, under other limits."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from ropsim.calibration.limits import ORDERS, MotionSettings, under
from ropsim.model import Cell, RobotModel, Station, with_axis_limits
from ropsim.planning import (
    MotionChain,
    MotionPlan,
    MotionSequence,
    StandardPathPlanner,
    standard_chain,
    timed,
)
from ropsim.spatial import Array

Replan = Callable[[int, MotionSettings], MotionPlan | None]
"""From the number of a sequence and settings to its motion; None where that cannot be made whole."""

_KEPT = 512


def replanner(
    cell: Cell,
    station: Station,
    orders: Sequence[MotionSequence],
    planning: Callable[[], None] = lambda: None,
) -> Replan:
    """Return a function that plans the motion sequences of a program under any settings, from their starts.

    Args:
        cell: static model.
        station: that makes the moves.
        orders: the sequences.
        planning: called before each planning of a sequence, which takes most of the time.
    """
    made_for = standard_chain(cell, station)

    @lru_cache(maxsize=_KEPT)
    def robot_under(joints: bytes) -> RobotModel:
        """Return one arm for all settings with these joint limits, so that it is analysed once."""
        return with_axis_limits(station.robot, *np.frombuffer(joints).reshape(ORDERS, -1))

    @lru_cache(maxsize=_KEPT)
    def chain(settings: MotionSettings) -> MotionChain:
        robot, controller = robot_under(settings.joints.tobytes()), under(station.controller, settings)
        planner = made_for.planner
        assert isinstance(planner, StandardPathPlanner)
        planner = replace(planner, robot=robot, controller=controller)
        return replace(made_for, planner=planner, robot=robot, controller=controller)

    @lru_cache(maxsize=_KEPT)
    def planned(number: int, settings: MotionSettings) -> MotionPlan | None:
        planning()
        order = orders[number]
        made, refusal = timed(chain(settings), order)
        return made if refusal is None else None

    return planned


def coordinates(motion: MotionPlan, times: Array) -> Array:
    """Return where the joints are [rad | m], shape (k, n); before and behind the motion at its ends.

    Args:
        motion: planned.
        times: since its start [s], shape (k,).
    """
    q = motion.reference.q
    rows = np.clip(times / motion.period, 0.0, float(motion.ticks))
    low = np.minimum(rows.astype(np.intp), motion.ticks - 1)
    share = (rows - low)[:, None]
    before = np.where((low > 0)[:, None], q[np.maximum(low - 1, 0)], motion.q_start)
    return before + share * (q[low] - before)


def difference(motion: MotionPlan, other: MotionPlan) -> float:
    """Return how far two motions of one way are from each other at most, begun together [rad | m]."""
    rows: Array = np.arange(1.0, max(motion.ticks, other.ticks) + 1.0) * motion.period
    return float(np.abs(coordinates(motion, rows) - coordinates(other, rows)).max())


def speeds(motion: MotionPlan, times: Array) -> Array:
    """Return the speeds of the joints [rad/s | m/s], shape (k, n); see `coordinates`."""
    rows = times / motion.period
    inside = (rows > 0.0) & (rows < motion.ticks)
    low = np.clip(rows.astype(np.intp), 0, motion.ticks - 1)
    return np.where(inside[:, None], motion.reference.qd[low], 0.0)
