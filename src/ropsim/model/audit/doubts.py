"""Numbers of an arm that could be and are most often slips: units, columns, stand-ins for the unknown.

Bounds are those of commercial arms, with a margin: from table-top arms of 4 kg to arms of 9 t that reach 4 m.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import inf, sqrt

import numpy as np

from ropsim.core import Diagnostic
from ropsim.model.audit.distant_centres import distant_centres
from ropsim.model.audit.drive_doubts import drive_doubts
from ropsim.model.audit.weights import SAME, length_of, one_mass, weight_doubts
from ropsim.model.drives.drive import IdealMotor
from ropsim.model.findings import doubt_diagnostics as kinds
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf
from ropsim.model.mechanism.links import BASE_LINK, Joint, JointType, Link
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import Array

SHORTEST = 0.05
"""Least sum of lengths of an arm [m]."""
LONGEST = 50.0
"""Greatest sum of lengths of an arm [m]."""
NARROWEST = 1e-2
"""Least range of a joint [rad | m]."""
SAME_DRIVES = 5
"""Number of axes from which equal drives are no coincidence: small arms have one motor up to four times."""
_AXIS_SLACK = 1e-9  # [m, sine of an angle] of two axes that are one


def doubts(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the doubts about a mechanism with a valid structure.

    Args:
        robot: audited mechanism.
        place_of: where its numbers stand in the file that it was read from.
    """
    yield from _size(robot, place_of)
    yield from weight_doubts(robot, place_of)
    yield from _masses(robot, place_of)
    for number in robot.axes:
        yield from _range(number, robot.joints[number], place_of)
    yield from _copied(robot, place_of)
    yield from _doubled_axes(robot, place_of)
    yield from distant_centres(robot, place_of)
    yield from drive_doubts(robot, place_of)


def _size(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    length = length_of(robot)
    if robot.joints and not SHORTEST <= length <= LONGEST:
        yield kinds.UNLIKELY_SIZE.at(
            place_of(AuditPlace(0, Attribute.PLACEMENT)),
            f"all lengths of `{robot.name}` together are {length:.4g} m, those of arms are {SHORTEST:g} to "
            f"{LONGEST:g} m",
            hint="are the lengths in the unit that the file says?",
            data={"length_m": length},
        )


def _masses(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    length = length_of(robot)
    yield from _placeholders(robot.links, place_of)
    for number, link in enumerate(robot.links):
        if link.mass > 0.0 and np.isfinite(link.inertia).all():
            turns = number < len(robot.joints) and robot.joints[number].type is JointType.REVOLUTE
            measures = _measures(link)[1:] if turns else _measures(link)
            yield from _extent(number, measures, length, place_of)


def _measures(link: Link) -> tuple[tuple[float, Attribute, str, str], ...]:
    """Return distance of the centre of mass and radius of gyration [m], with words for a finding."""
    away = float(np.linalg.norm(link.com))
    gyration = sqrt(max(float(np.abs(np.diagonal(link.inertia)).max()), 0.0) / link.mass)
    return (
        (away, Attribute.COM, "its centre of mass", "are centres of mass in the unit of length of the file?"),
        (gyration, Attribute.INERTIA, "its radius of gyration", "inertias are in kg·m²"),
    )


def _extent(
    number: int, measures: tuple[tuple[float, Attribute, str, str], ...], length: float, place_of: PlaceOf
) -> Iterator[Diagnostic]:
    """Yield measures of a link that are outside of the whole arm; for turning links see `distant_centres`."""
    for value, attribute, what, unit in measures:
        if value > length > 0.0:
            yield kinds.UNLIKELY_INERTIA.at(
                place_of(AuditPlace(number, attribute)),
                f"link `{number + 1}` has {what} at {value:.4g} m, the whole arm is {length:.4g} m long",
                hint=unit,
                data={"found_m": value, "length_m": length},
            )


def _placeholders(links: Sequence[Link], place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the first of several links with the same mass, or the same tensor of inertia."""
    bodies = [(number, link) for number, link in enumerate(links) if link.mass > 0.0]
    if len(bodies) < SAME:
        return
    (first, one), *others = bodies
    for attribute, what, same in (
        (Attribute.MASS, f"a mass of {one.mass:g} kg", one_mass(links) is not None),
        (
            Attribute.INERTIA,
            "one tensor of inertia",
            bool(one.inertia.any()) and all(np.array_equal(link.inertia, one.inertia) for _, link in others),
        ),
    ):
        if same:
            yield kinds.PLACEHOLDER_MASSES.at(
                place_of(AuditPlace(first, attribute)),
                f"all {len(bodies)} links with mass have {what}",
                hint="such numbers stand in files where nobody knew them; leave them out to get estimates",
                data={"links": len(bodies)},
            )


def _range(number: int, joint: Joint, place_of: PlaceOf) -> Iterator[Diagnostic]:
    if 0.0 < joint.upper - joint.lower < NARROWEST:
        unit = "m" if joint.type is JointType.PRISMATIC else "rad"
        yield kinds.JOINT_WITHOUT_RANGE.at(
            place_of(AuditPlace(number, Attribute.LIMITS)),
            f"joint `{joint.name}` has a range of {joint.upper - joint.lower:.3g} {unit} only",
            hint="a joint that does not move is no joint: leave its row out, or give its real limits",
            data={f"range_{unit}": joint.upper - joint.lower},
        )


def _copied(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the first joint where all turning ones have the same limits and speeds, efforts, or rotors."""
    turning = [number for number in robot.axes if robot.joints[number].type is JointType.REVOLUTE]
    rows = {_limits(robot.joints[number]) for number in turning}
    if len(turning) >= SAME and len(rows) == 1:
        yield kinds.COPIED_LIMITS.at(
            place_of(AuditPlace(turning[0], Attribute.LIMITS)),
            f"all {len(turning)} turning joints of `{robot.name}` have the same limits, speeds and "
            "accelerations",
            hint="compare them with the data sheet",
        )
    for what, numbers in (("greatest effort", _efforts(robot)), ("inertia of the rotor", _rotors(robot))):
        if len(numbers) >= SAME_DRIVES and len(set(numbers)) == 1 and 0.0 < numbers[0] < inf:
            yield kinds.COPIED_LIMITS.at(
                place_of(AuditPlace(turning[0], Attribute.LIMITS)),
                f"all {len(numbers)} turning joints of `{robot.name}` have {numbers[0]:g} as their {what}",
                hint="such numbers stand in files where nobody knew them: compare them with the data sheet",
            )


def _efforts(robot: Mechanism) -> list[float]:
    return [joint.max_effort for joint in robot.axis_joints if joint.type is JointType.REVOLUTE]


def _rotors(robot: Mechanism) -> list[float]:
    """Return the inertias of the rotors of ideal motors of turning joints [kg·m²]."""
    pairs = zip(robot.axis_joints, robot.drives, strict=False)
    turning = [drive.motor for joint, drive in pairs if joint.type is JointType.REVOLUTE]
    return [motor.rotor_inertia for motor in turning if isinstance(motor, IdealMotor)]


def _limits(joint: Joint) -> tuple[float, ...]:
    return joint.lower, joint.upper, joint.max_speed, joint.max_acceleration


def _doubled_axes(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield joints that turn about, or slide along, the axis of the joint that carries them."""
    for before, number in pairwise((BASE_LINK, *robot.axes)):
        joint = robot.joints[number]
        if before == BASE_LINK or joint.parent != before or joint.type is not robot.joints[before].type:
            continue
        rotation, position = joint.placement.rotation(), joint.placement.position
        if _parallel(rotation) and (joint.type is JointType.PRISMATIC or _on_axis(position)):
            does = "slides along" if joint.type is JointType.PRISMATIC else "turns about"
            yield kinds.DOUBLED_AXIS.at(
                place_of(AuditPlace(number, Attribute.PLACEMENT)),
                f"joint `{joint.name}` {does} the axis of joint `{robot.joints[before].name}` again",
                hint="is an `alpha` or a length missing in the row before it?",
            )


def _parallel(rotation: Array) -> bool:
    return float(np.linalg.norm(rotation[:2, 2])) < _AXIS_SLACK


def _on_axis(position: Array) -> bool:
    return float(np.linalg.norm(position[:2])) < _AXIS_SLACK
