"""A NIROX file to a robot."""

from collections.abc import Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.express import validate
from ropsim.model import PlaceOf, ReadRobot, RobotModel, audit, nowhere
from ropsim.nirox.building import FurtherFrame
from ropsim.nirox.diagnostics import KEPT, LOST, NOT_NIROX
from ropsim.nirox.further_data import NOTHING, FurtherData, further_data_of
from ropsim.nirox.products.plain_mechanism import SCHEMA, with_arm
from ropsim.nirox.products.product_masses import with_masses
from ropsim.nirox.readers.arm import read_arm
from ropsim.nirox.readers.attributes import ImpossibleError
from ropsim.nirox.readers.number_places import places_of
from ropsim.nirox.readers.seen import Seen
from ropsim.nirox.schema_text import NAME, ConformanceClass, conformance_of, nirox_schema
from ropsim.part21 import ExchangeFile, read_exchange

_MASSLESS = "`moving_links_have_mass.doubt1`"
_OF_PLAIN = (
    "`robot_arm.doubt1`",
    _MASSLESS,
)  # X957 reports it in other words, or it is never needed
WITHOUT_MASS = "joints of links without mass"
"""Key of the data of a finding that names them."""
_NAMED = 6  # entities that a message names
_WITHOUT_EFFECT = (
    "joint_friction", "drive_train", "motor_select", "transmission", "servo_valve", "hydraulic_supply",
    "hydraulic_cylinder", "hydraulic_rotary_motor", "motion_coupling", "joint_sensor", "payload",
    "joint_elasticity", "gear_pair", "dc_servo_motor", "ideal_effort_source", "electric_amplifier",
)  # fmt: skip
"""Entities that would change a simulation; keeping them is reported as a loss."""


@frozen_dataclass
class ReadNirox(ReadRobot):
    """A robot read from a NIROX file, and the other data of the file.

    Attributes:
        conformance: the class of the file; nothing where there is no robot.
        further: data that the model does not hold; pass it to `write_nirox` to write them again.
    """

    conformance: ConformanceClass | None = None
    further: FurtherData = NOTHING


def read_nirox(source: SourceText) -> ReadNirox:
    """Return the robot that a NIROX file describes, everything in SI units.

    The file is checked against the schema first. Lengths and angles of the mechanism are converted from the
    units that its contexts declare. Entities that the model does not hold are kept with the robot.

    Args:
        source: content of the file; any text is allowed.
    """
    file, findings = read_exchange(source)
    if any(one.is_error for one in findings):
        return ReadNirox(None, findings)
    completed = _with_arm(file)
    if completed is None:
        return ReadNirox(None, (_other_schema(file),))
    arm, missing = completed
    seen = Seen(nirox_schema(), arm)
    found = validate(seen.population)
    if arm is not file:
        found = (*(one for one in found if not any(word in one.message for word in _OF_PLAIN)), *missing)
    if any(one.is_error for one in found):
        return ReadNirox(None, found)
    made = _robot(seen, source.name)
    found_here = (*found, *seen.findings)
    if made is None:
        return ReadNirox(None, found_here)
    robot, frames = made
    found_here = tuple(_with_links(one, robot) if _MASSLESS in one.message else one for one in found_here)
    further = further_data_of(seen, robot, frames)
    return ReadNirox(
        robot, (*found_here, *_kept(seen, further)), conformance=conformance_of(robot), further=further
    )


def read_valid_nirox(source: SourceText) -> RobotModel:
    """Return the robot of a file that is known to be right, in a fraction of the time of `read_nirox`.

    Args:
        source: content of a file that `write_nirox` has written.

    Raises:
        ValueError: the file has no robot.
    """
    file, _ = read_exchange(source)
    made = _robot(Seen(nirox_schema(), file), source.name)
    if made is None:
        raise ValueError(f"{source.name} has no robot")
    return made[0]


def nirox_places(source: SourceText) -> PlaceOf:
    """Return where the numbers of the robot stand in a file that could be read."""
    file, _ = read_exchange(source)
    seen = Seen(nirox_schema(), (_with_arm(file) or (file,))[0])
    made = _robot(seen, source.name)
    return places_of(seen, made[0].axes) if made else nowhere


def _with_links(finding: Diagnostic, robot: RobotModel) -> Diagnostic:
    """Return the finding of the rule on masses with the links that have none."""
    names = [
        joint.name
        for joint, link in zip(robot.joints, robot.links, strict=True)
        if not link.mass and not link.inertia.any()
    ]
    shown = ", ".join(f"`{one[:60]}`" for one in names[:_NAMED])
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    message = f"the links that joints {shown}{more} move have no mass"
    hint = "the arm moves as it is commanded; `ropsim robot estimate` gives it estimated masses"
    return replace(finding, message=message, hint=hint, data={WITHOUT_MASS: tuple(names)})


def _with_arm(file: ExchangeFile) -> tuple[ExchangeFile, tuple[Diagnostic, ...]] | None:
    """Return a NIROX file, or one of AP242 with the arm and the masses that follow from it; else nothing.

    Masses missing in AP242 are reported.
    """
    if NAME in file.schemas:
        return file, ()
    arm = with_arm(file) if any(one.startswith(SCHEMA) for one in file.schemas) else None
    return with_masses(arm) if arm is not None else None


def _other_schema(file: ExchangeFile) -> Diagnostic:
    names = ", ".join(f"`{one[:60]}`" for one in file.schemas) or "none"
    span = file.places.span(0) if file.places else None
    message = f"the schema of the file is {names}, allowed are `{NAME}`, and AP242 with a mechanism"
    return NOT_NIROX.at(span, message, hint="`ropsim robot export NAME FILE.stp` writes such files")


def _robot(seen: Seen, name: str) -> tuple[RobotModel, tuple[FurtherFrame, ...]] | None:
    """Return the robot of a valid file and its other frames; nothing where an error forbids one."""
    try:
        made = read_arm(seen, name)
    except ImpossibleError as error:
        seen.add(error.finding)
        return None
    if made and not seen.is_refused:
        for one in audit(made[0], places_of(seen, made[0].axes)):
            if one.is_error:
                seen.add(one)
    return None if seen.is_refused else made


def _kept(seen: Seen, further: FurtherData) -> Iterator[Diagnostic]:
    """Yield findings on kept entities: unknown ones, and entities without an effect."""
    if seen.unknown:
        shown = ", ".join(f"`{one[:60]}`" for one in seen.unknown[:_NAMED])
        more = f" and {len(seen.unknown) - _NAMED} more" if len(seen.unknown) > _NAMED else ""
        yield KEPT.at(None, f"entities that say nothing here are kept: {shown}{more}")
    held: dict[str, int] = {}
    for number in further.numbers:
        lineage = seen.population.lineage(number)
        if set(lineage) & set(_WITHOUT_EFFECT):
            held.setdefault(lineage[-1], number)
    spans = {one.span for one in seen.findings}
    for number in held.values():
        span = seen.population.file.span(seen.population.instances[number])
        if span not in spans:
            yield LOST.at(span, f"{seen.called(number)}: what it says has no effect here; it is kept")
