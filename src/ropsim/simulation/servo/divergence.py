"""Report of a state that is not finite, grows beyond all bounds or left its assembly: when, and what part."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from ropsim.dynamics import GAP, structure_of
from ropsim.kinematics import configurations, dead_centre, is_as_at_home, usual_volume
from ropsim.model import BASE_LINK, JointType, Rates, RobotModel
from ropsim.simulation.servo.diagnostics import CAME_APART, DIVERGED, PASSED_DEAD_CENTRE, DivergedError
from ropsim.simulation.servo.state import ServoState, StateLayout
from ropsim.simulation.servo.stiffness import STEEP_HINT, steep_axes, steep_words
from ropsim.spatial import Array

LARGEST = 1e12
"""Largest magnitude of a coordinate, speed or state of a drive in SI units; pressures of oil are 1e8."""

_SAMPLES = 8
ALIKE = 1e-4
"""Nearer to a dead centre than this the assemblies on both sides may be alike; see `DeadCentre.distance`."""


def is_sound(values: Array, layout: StateLayout) -> bool:
    """Return whether a state vector is finite, not beyond all bounds, and its closed chains are closed."""
    integrated = values[: layout.integrated]
    if layout.passive and not values[layout.loops.gap] <= GAP:
        return False
    return bool((np.abs(integrated) < LARGEST).all() and np.isfinite(values).all())


@lru_cache(maxsize=64)
def volume_at_rest(robot: RobotModel) -> float:
    """Return the greatest volume of the watched rows of closed chains at home and in some configurations."""
    rows = structure_of(robot).watched
    Q = np.vstack((robot.home, configurations(robot, _SAMPLES)))
    return usual_volume(robot, rows, Q) if rows else 0.0


def has_passed(values: Array, layout: StateLayout) -> bool:
    """Return whether closed chains have changed their side of a dead centre, or are next to one."""
    return bool(layout.passive) and bool(values[layout.loops.passed])


def is_assembled(robot: RobotModel, values: Array, layout: StateLayout) -> bool:
    """Return whether the closed chains of a state are still put together as at home.

    Where that is sure the mark that they are next to a dead centre or beyond it is taken back; in one the
    assemblies are alike, and it stays.

    Args:
        robot: the arm.
        values: the state vector, shape (m,).
        layout: of the vector.
    """
    if not has_passed(values, layout):
        return True
    state = values[layout.loops.places]
    if not is_as_at_home(robot, state):
        return False
    if dead_centre(robot, state).distance > ALIKE:
        values[layout.loops.passed] = 0.0
    return True


def first_fault(
    robot: RobotModel, values: Array, layout: StateLayout, ticks: int, advance: Callable[[int], None]
) -> int | None:
    """Return the number of ticks after which a state vector is not sound any more; it keeps its state there.

    A slice is one call, and a NaN shows at its end only; so it is repeated tick by tick. A value may become
    finite again (a counter that is reset), so every tick is checked; and so may an assembly.

    Args:
        robot: the arm.
        values: the state vector, shape (m,), before the first tick; it is advanced.
        layout: of the vector.
        ticks: of the slice.
        advance: advances the vector by the tick of a number, from 0; an `ArithmeticError` or a `ValueError`
            is also a fault.

    Returns:
        None if all ticks are without fault.
    """
    for k in range(ticks):
        try:
            advance(k)
        except (ArithmeticError, ValueError):  # plain Python raises where compiled code yields NaN
            return k + 1
        if not (is_sound(values, layout) and is_assembled(robot, values, layout)):
            return k + 1
    return None


def diverged(robot: RobotModel, state: ServoState, rates: Rates) -> DivergedError:
    """Return the error of a state at the first tick at which it is not sound.

    Args:
        robot: the arm.
        state: there.
        rates: of its controller.
    """
    time = state.tick / rates.control_hz
    if _is_finite(state):
        apart = float(state.values[state.layout.loops.gap]) > GAP
        return _apart(robot, state, time) if apart else _passed(robot, state, time)
    what = _first(robot, state.layout, state.values)
    when = f"{time:.6g} s (control tick {state.tick})"
    message = f"{what} at {when}; all numbers must be finite, and in SI units below {LARGEST:g}"
    hint = "look for a NaN in reference, payload, gains or a law of your own, or raise `plant_steps`"
    steep = steep_axes(robot, rates)
    if steep:
        message, hint = f"{message}: {steep_words(robot, steep[0])}", STEEP_HINT
    return DivergedError(
        DIVERGED.at(None, message, hint=hint, data={"time_s": time, "tick": state.tick, "what": what})
    )


def _is_finite(state: ServoState) -> bool:
    """Return whether all numbers are as they should be, and only closed chains are not."""
    layout, values = state.layout, state.values
    integrated = values[: layout.integrated]
    return bool(layout.passive and np.isfinite(values).all() and (np.abs(integrated) < LARGEST).all())


def _apart(robot: RobotModel, state: ServoState, time: float) -> DivergedError:
    """Return the error of a state whose closed chains have come apart."""
    gap = float(state.values[state.layout.loops.gap])
    message = (
        f"closed chains of `{robot.name}` are {gap:.3g} (m, rad) apart at {time:.6g} s "
        f"(control tick {state.tick}); allowed are {GAP:g}"
    )
    hint = "look for a chain at the end of its reach, or raise `plant_steps`"
    data = {"time_s": time, "tick": state.tick, "gap": gap}
    return DivergedError(CAME_APART.at(None, message, hint=hint, data=data))


def _passed(robot: RobotModel, state: ServoState, time: float) -> DivergedError:
    """Return the error of a state whose closed chains have gone through a dead centre."""
    found = dead_centre(robot, state.values[state.layout.loops.places])
    axis, joint, cut = robot.axis_joints[found.axis], robot.joints[found.joint], robot.cuts[found.chain]
    turns = axis.type is JointType.REVOLUTE
    place = float(state.q[found.axis])
    where = f"{np.degrees(place):.2f}°" if turns else f"{1e3 * place:.2f} mm"
    ends = " and ".join(
        "the base" if k == BASE_LINK else f"`{robot.joints[k].name}`" for k in (cut.first, cut.second)
    )
    message = (
        f"closed chain {found.chain + 1} of `{robot.name}`, cut between {ends}, has gone through a dead "
        f"centre into another assembly at {time:.6g} s (control tick {state.tick}): axis `{axis.name}` "
        f"is at {where}, joint `{joint.name}` went over"
    )
    hint = f"keep axis `{axis.name}` off {where}, or limit joint `{joint.name}`"
    data = {
        "time_s": time,
        "tick": state.tick,
        "chain": found.chain + 1,
        "axis": axis.name,
        "joint": joint.name,
        "q": place,
    }
    return DivergedError(PASSED_DEAD_CENTRE.at(None, message, hint=hint, data=data))


def _first(robot: RobotModel, layout: StateLayout, values: Array) -> str:
    """Return the part of a state vector that is not sound, and why: causes come first."""
    every = tuple(range(layout.n))
    places = [
        ("output of the joint controller", every, layout.output),
        *(("output of the joint controller", every, place) for place in _rows(layout.pending, layout.n)),
        *(("memory of the joint controller", every, place) for place in _rows(layout.law, layout.n)),
        *(("reference", every, place) for place in _rows(layout.reference, layout.n)),
        *((f"`{field.name}` of the drive", field.axes, field.place) for field in layout.drives),
        ("speed", every, layout.qd),
        ("coordinate", every, layout.q),
    ]
    for name, axes, place in places:
        largest = LARGEST if place.stop <= layout.integrated else np.inf
        bad = np.flatnonzero(~(np.abs(values[place]) < largest))
        if len(bad):
            value = values[place][bad[0]]
            why = f"is {value:.3g}" if np.isfinite(value) else "is not finite any more"
            return f"the {name} of joint `{robot.axis_joints[axes[int(bad[0])]].name}` {why}"
    return "the pressure of a supply of oil is not finite any more"


def _rows(place: slice, n: int) -> list[slice]:
    return [slice(first, first + n) for first in range(place.start, place.stop, n)]
