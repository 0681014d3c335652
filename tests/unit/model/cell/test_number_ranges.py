"""A cell that is made in Python has no number outside its range."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from enum import Enum
from functools import partial
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import ParameterOrigin
from ropsim.model import (
    ROBOT,
    Barrier,
    BeltDrive,
    Cell,
    ClassicSettings,
    ComputedTorqueGains,
    ControllerModel,
    CorrectionLimits,
    Destination,
    Device,
    DeviceDrive,
    DistanceSensor,
    ExternalValues,
    Fingers,
    FixedObject,
    ForceSensor,
    ForceTorqueSensor,
    Frame,
    Gripper,
    IndexDrive,
    LookAhead,
    Mechanism,
    ModelValueError,
    Part,
    PathDefaults,
    Payload,
    Rates,
    SensorErrors,
    Shape,
    Signal,
    Sink,
    Station,
    SupportLimits,
    SwitchDrive,
    Tool,
    ToolPart,
    WrenchAxis,
)
from ropsim.spatial import Pose, frozen

ARM = robots.load("puma560")
AXIS = Mechanism("axis", "one axis", ARM.joints[:1], (), (), frozen([0.0]))
DRIVES: tuple[DeviceDrive, ...] = (
    BeltDrive(0.2, 1.0, "", 1.0, Barrier(0.5, "there")),
    SwitchDrive("out", 0.0, 0.1, 0.2, 1.0),
    IndexDrive("out", 0.1, 0.2, 1.0),
)
CONTROLLER = robots.default_controller(ARM, Rates(plant_steps=2))
TORQUE_GAINS = ComputedTorqueGains(frozen([100.0] * 6), frozen([20.0] * 6), frozen([5.0] * 6))
TOOL = Tool(
    "gripper",
    gripper=Gripper(0.1, 0.1, 0.01, Fingers(AXIS, 0.02, 0.0)),
    parts=(ToolPart("adapter", Pose(), Payload(1.0)),),
)
CELL = Cell(
    "c",
    {
        ROBOT: Station(ROBOT, ARM, CONTROLLER, tools={"gripper": TOOL}, start=ARM.home),
        "other": Station("other", ARM, replace(CONTROLLER, gains=TORQUE_GAINS)),
    },
    devices={f"d{k}": Device(f"d{k}", AXIS, drive, Pose()) for k, drive in enumerate(DRIVES)},
    frames={"table": Frame()},
    locations={"P": Pose()},
    parts=(Part("part", frozen([0.1, 0.1, 0.1]), 1.0, Pose(), destination=Destination(Pose(), 0.01, 0.1)),),
    objects=(FixedObject("block", Pose(), ()),),
    sinks=(Sink("sink", (0.0, 0.0, 0.0), 0.1),),
    signals={
        "there": Signal("there", is_input=True, changes=((1.0, 1.0),), sensor=DistanceSensor("", 0.1)),
        "force": Signal("force", is_input=True, analog=True, sensor=ForceSensor("", 100.0, 0.01)),
        "push": Signal("push", is_input=True, analog=True, sensor=ForceTorqueSensor("", WrenchAxis.Z)),
        "out": Signal("out", is_input=False),
    },
    external={"P": ExternalValues((0.0,))},
)

NOT_NUMBERS = (math.nan, math.inf, -math.inf)
FROM_ZERO = {
    ControllerModel: ("in_position", "settle_timeout", "settle_time", "via_zone"),
    LookAhead: ("moves", "braking"),
    CorrectionLimits: ("size",),
    Gripper: ("open_time", "close_time", "capture"),
    BeltDrive: ("length",),
    Sink: ("radius",),
    SupportLimits: ("gap", "depth"),
    Cell: ("clearance",),
    DistanceSensor: ("range", "behind"),
    ForceSensor: ("stiffness", "travel"),
    SensorErrors: ("step", "noise", "period", "delay", "most"),
    Part: ("size",),
    Destination: ("distance", "turn"),
}
ABOVE_ZERO = {
    Rates: ("control_hz", "interpolation_ticks", "plant_steps"),
    PathDefaults: tuple(one.name for one in fields(PathDefaults)),
    CorrectionLimits: ("speed", "acceleration"),
    ControllerModel: ("speed_override",),
    BeltDrive: ("speed", "acceleration"),
    SwitchDrive: ("speed", "acceleration"),
    IndexDrive: ("speed", "acceleration"),
    ClassicSettings: ("length", "angle"),
}
CHECKED_OTHERWISE = (Mechanism, Payload, ParameterOrigin, Shape)
"""Records with checks of their own, or without numbers of the run."""

NO_QUANTITY = {
    (Tool, "mass"),
    (Tool, "com"),
    (Tool, "inertia"),
    (Part, "turn"),
    (Part, "mass"),
    (Part, "X_WO"),
    (Signal, "channel"),
}
"""Counts of things, and numbers that `check_finite` and `check_mass` check."""

Rebuild = Callable[[Any], Cell]


def numbers(record: Any, rebuild: Rebuild) -> Iterator[tuple[type, str, Any, Rebuild]]:
    """Yield each numeric field below a record: its class, name, value, and the cell with another value."""
    for one in fields(record):
        value = getattr(record, one.name)

        def again(new: Any, name: str = one.name) -> Cell:
            return rebuild(replace(record, **{name: new}))

        if not isinstance(value, Enum | str | bool) and (type(record), one.name) not in NO_QUANTITY:
            yield from below(type(record), one.name, value, again)


def below(owner: type, name: str, value: Any, rebuild: Rebuild) -> Iterator[tuple[type, str, Any, Rebuild]]:
    """Yield the numeric fields of a value of a field, the value itself where it is one."""
    match value:
        case int() | float() | np.ndarray() | Pose():
            yield owner, name, value, rebuild
        case tuple() if value and not is_dataclass(value[0]) and not isinstance(value[0], str):
            yield owner, name, value, rebuild
        case tuple():
            for k, one in enumerate(value):
                before, after = value[:k], value[k + 1 :]
                again = partial(_with_item, rebuild, before, after)
                yield from below(owner, name, one, again)
        case Mapping():
            for key, one in value.items():
                yield from below(owner, name, one, partial(_with_entry, rebuild, value, key))
        case _ if is_dataclass(value) and not isinstance(value, CHECKED_OTHERWISE):
            yield from numbers(value, rebuild)
        case _:
            pass


def _with_item(rebuild: Rebuild, before: tuple[Any, ...], after: tuple[Any, ...], new: Any) -> Cell:
    return rebuild((*before, new, *after))


def _with_entry(rebuild: Rebuild, entries: Mapping[str, Any], key: str, new: Any) -> Cell:
    return rebuild({**entries, key: new})


def with_number(value: Any, number: float) -> Any:
    """Return a value of a field with one number of it replaced."""
    match value:
        case np.ndarray():
            return np.array([number, *value[1:]])
        case Pose():
            return Pose(np.array([number, 0.0, 0.0]))
        case tuple():
            return (with_number(value[0], number), *value[1:])
        case _:
            return number


def impossible(owner: type, name: str) -> tuple[float, ...]:
    """Return values that the field cannot have."""
    if name in ABOVE_ZERO.get(owner, ()):
        return (*NOT_NUMBERS, -1, 0)
    return (*NOT_NUMBERS, -1) if name in FROM_ZERO.get(owner, ()) else NOT_NUMBERS


FIELDS = [*numbers(CELL, lambda cell: cell)]
CASES = [
    pytest.param(rebuild, with_number(value, wrong), name, id=f"{owner.__name__}.{name}={wrong}-{k}")
    for k, (owner, name, value, rebuild) in enumerate(FIELDS)
    for wrong in impossible(owner, name)
]


@pytest.mark.parametrize(("rebuild", "wrong", "name"), CASES)
def test_a_number_outside_its_range_is_refused(rebuild: Rebuild, wrong: Any, name: str) -> None:
    with pytest.raises(ModelValueError) as caught:
        rebuild(wrong)
    found = caught.value.diagnostic
    assert found.code in ("X976", "X859")  # X859: poses of tools, whose numbers `check_finite` checks
    assert name in found.message or found.code == "X859"
    assert "allowed" in found.message + found.hint


def test_each_class_of_which_numbers_are_listed_is_in_the_cell() -> None:
    assert {*FROM_ZERO, *ABOVE_ZERO} <= {owner for owner, *_ in FIELDS}
    for table in (FROM_ZERO, ABOVE_ZERO):
        named = {(owner, name) for owner, names in table.items() for name in names}
        assert named <= {(owner, name) for owner, name, *_ in FIELDS}


def test_a_cell_is_made_again_with_its_own_numbers() -> None:
    for *_, value, rebuild in FIELDS:
        assert rebuild(value) == CELL


@pytest.mark.parametrize("wrong", [2.5, 1000.0, "1000"])
def test_a_rate_is_a_whole_number(wrong: Any) -> None:
    rates = replace(CONTROLLER.rates, control_hz=wrong)
    with pytest.raises(ModelValueError, match="allowed is a whole number from 1 to 1000000 Hz"):
        replace(CELL.first, controller=replace(CONTROLLER, rates=rates))


def test_the_message_names_station_field_number_and_range() -> None:
    with pytest.raises(ModelValueError) as caught:
        replace(CELL.first, controller=replace(CONTROLLER, speed_override=0.0))
    found = caught.value.diagnostic
    assert found.message == (
        f"station `{ROBOT}` has `controller.speed_override` = 0, allowed is a number from 1e-06 to 1"
    )
    assert found.data == {"field": "controller.speed_override", "found": 0.0, "lowest": 1e-6, "highest": 1.0}


@pytest.mark.parametrize("wrong", NOT_NUMBERS)
def test_a_home_position_is_finite(wrong: float) -> None:
    with pytest.raises(ModelValueError, match="home position"):
        replace(ARM, home=np.array([wrong, *ARM.home[1:]]))
