"""A robot to a file of AP242: its mechanism, in entities of that schema only."""

from dataclasses import replace

from ropsim.model import RobotModel, WrittenRobot, check_counts
from ropsim.nirox.building import DERIVED, Building
from ropsim.nirox.diagnostics import REFUSED
from ropsim.nirox.products.plain_form import plain_form
from ropsim.nirox.writers.arm import write_state
from ropsim.nirox.writers.mechanism import MechanismWriting
from ropsim.part21 import ExchangeFile, Instance, Record, Reference, Value, write_exchange
from ropsim.version import __version__

AP242 = "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 3 1 4 }"
"""The long form of edition 2 of AP242."""
_OWN = ("LOOP_CUT", "PLACEMENT_ORIENTATION")
"""Entities that the writer of a mechanism makes and that AP242 does not have."""


def write_mechanism(robot: RobotModel) -> WrittenRobot:
    """Return the mechanism of a robot as a file of AP242 in its one canonical form.

    Its content is `plain_form` of the robot. Read again it has the same axes in the same order and the same
    rest position; written once more it is the same text. Losses are not reported here.

    Args:
        robot: to be written.

    Raises:
        MechanismError: the robot cannot be.
    """
    check_counts(robot)
    plain = plain_form(robot)
    building = Building()
    writing = MechanismWriting(building, plain)
    mechanism = writing.write()
    states = tuple(write_state(building, plain, place) for place in range(plain.n))
    building.add(("home",), "MECHANISM_STATE_REPRESENTATION", "home", states, DERIVED, mechanism)
    relations = [building.at(("pair", number, "relation")) for number in plain.axes]
    instances = tuple(
        _with_axes_first(one, relations) if one.number == mechanism.number else one
        for one in building.instances()
        if one.keyword not in _OWN
    )
    header = (
        Record("FILE_DESCRIPTION", (("mechanism of an arm",), "2;1")),
        Record("FILE_NAME", (robot.name, "", ("",), ("",), "ropsim", f"ropsim {__version__}", "")),
        Record("FILE_SCHEMA", ((AP242,),)),
    )
    try:
        text = write_exchange(ExchangeFile(header, instances))
    except ValueError as error:
        return WrittenRobot("", (REFUSED.at(None, str(error)),))
    return WrittenRobot(text, tuple(writing.losses()))


def _with_axes_first(instance: Instance, relations: list[Reference]) -> Instance:
    """Return the mechanism with the pairs of its axes in their order, before the others."""
    (record,) = instance.records
    values: list[Value] = list(record.values)
    listed = values[1] if isinstance(values[1], tuple) else ()
    values[1] = (*relations, *(one for one in listed if one not in relations))
    return replace(instance, records=(Record(record.keyword, tuple(values)),))
