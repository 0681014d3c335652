"""Whether the numbers of joints, links and drives can be: limits, placements, masses and inertias."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields
from itertools import chain
from math import isfinite
from types import MappingProxyType
from typing import Protocol

import numpy as np

from ropsim.core import Diagnostic, Span
from ropsim.model.drives.drive import Drive
from ropsim.model.drives.friction_parts import FrictionParts
from ropsim.model.findings import diagnostics as kinds
from ropsim.model.findings.number_range import (
    FROM_ZERO,
    POSITIVE,
    POSITIVE_OR_INFINITE,
    ModelValueError,
)
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf, nowhere
from ropsim.model.mechanism.links import Joint, JointType, Link
from ropsim.spatial import Array

SYMMETRY_SLACK = 1e-9
"""Difference of two products of inertia, relative to the largest entry, that is rounding."""

MOMENT_SLACK = 1e-3
"""Negative moment of inertia, relative to the largest one, that is rounding: files round their tensors."""

_RANGES_OF_DRIVES = MappingProxyType(
    {
        "max_voltage": POSITIVE,
        "max_input": POSITIVE,
        "max_current": POSITIVE_OR_INFINITE,  # infinite where it is unknown
        "max_effort": POSITIVE_OR_INFINITE,
        "rotor_inertia": FROM_ZERO,
        "moving_mass": FROM_ZERO,
        "backlash": POSITIVE,
        "max_rise": POSITIVE_OR_INFINITE,
    }
)
_RANGES_OF_JOINTS = MappingProxyType(
    {
        Attribute.MAX_SPEED: POSITIVE,
        Attribute.MAX_ACCELERATION: POSITIVE,
        Attribute.MAX_JERK: POSITIVE,
        Attribute.MAX_EFFORT: POSITIVE_OR_INFINITE,
    }
)


class Body(Protocol):
    """A rigid body in some frame."""

    @property
    def mass(self) -> float:
        """Return the mass [kg]."""

    @property
    def com(self) -> Array:
        """Return the centre of mass [m], shape (3,)."""

    @property
    def inertia(self) -> Array:
        """Return the inertia about the centre of mass [kg·m²], shape (3, 3)."""


def check_numbers(
    joints: Sequence[Joint], links: Sequence[Link], axes: Sequence[int], drives: Sequence[Drive]
) -> None:
    """Make sure that the numbers of joints, links and drives can be.

    Args:
        joints: of a mechanism.
        links: of it.
        axes: numbers of the joints, from 0, that are driven.
        drives: of the axes, or none.

    Raises:
        ModelValueError: with the first of the `number_findings`.
    """
    found = next(number_findings(joints, links, axes, drives), None)
    if found:
        raise ModelValueError(found)


def check_finite(what: str, numbers: Iterable[float]) -> None:
    """Make sure that numbers of a mechanism are finite.

    Args:
        what: kind of the checked numbers.
        numbers: any.

    Raises:
        ModelValueError: one is not finite.
    """
    if not all(map(isfinite, numbers)):
        raise ModelValueError(_not_finite(what, None))


def check_mass(name: str, mass: float) -> None:
    """Make sure that a mass [kg] is 0 or more.

    Args:
        name: of the body, as its messages say it.
        mass: of it, finite.

    Raises:
        ModelValueError: it is negative.
    """
    if mass < 0.0:
        raise ModelValueError(_negative_mass(name, mass, None))


def check_body(name: str, body: Body) -> None:
    """Make sure that the mass and inertia of a body can be.

    Args:
        name: of the body, as its messages say it.
        body: a tool, a payload or a link.

    Raises:
        ModelValueError: with the first of the `body_findings`.
    """
    found = next(body_findings(name, body), None)
    if found:
        raise ModelValueError(found)


def number_findings(
    joints: Sequence[Joint],
    links: Sequence[Link],
    axes: Sequence[int],
    drives: Sequence[Drive],
    place_of: PlaceOf = nowhere,
) -> Iterator[Diagnostic]:
    """Yield the numbers of joints, links and drives that cannot be; all of them are errors.

    The limits of an axis are ordered, its largest speed, acceleration, jerk and effort positive; only the
    effort may be infinite. A mass is 0 or more, an inertia symmetric. The moments of a body with mass are not
    negative; an inertia without mass is an effective one, as identification finds it, and may be. Zeros are
    allowed: published sets omit irrelevant values. The limits of a drive are positive; its moving parts have
    a mass or inertia of 0 or more. Its gear ratio is not 0; all its numbers are finite.

    Args:
        joints: of a mechanism.
        links: of it.
        axes: numbers of the joints, from 0, that are driven; others may have no limits.
        drives: of the axes, or none.
        place_of: where a number stands in the file that it was read from.
    """
    yield from chain(
        chain.from_iterable(_limits(k, joints[k], place_of) for k in axes if k < len(joints)),
        chain.from_iterable(_placement(k, joint, place_of) for k, joint in enumerate(joints)),
        chain.from_iterable(_link(k, link, place_of) for k, link in enumerate(links)),
        chain.from_iterable(_drive(k, drive, place_of) for k, drive in enumerate(drives)),
    )


def _limits(number: int, joint: Joint, place_of: PlaceOf) -> Iterator[Diagnostic]:
    unit = "m" if joint.type is JointType.PRISMATIC else "rad"
    if not joint.lower < joint.upper:
        yield kinds.REVERSED_LIMITS.at(
            place_of(AuditPlace(number, Attribute.LIMITS)),
            f"joint `{joint.name}` has the lower limit {joint.lower:g} {unit} and the upper limit "
            f"{joint.upper:g} {unit}",
            hint="the lower limit must be the smaller number",
            data={f"lower_{unit}": joint.lower, f"upper_{unit}": joint.upper},
        )
    for name, allowed in _RANGES_OF_JOINTS.items():
        value = float(getattr(joint, name))
        if not allowed.allows(value):
            yield kinds.UNUSABLE_LIMIT.at(
                place_of(AuditPlace(number, name)),
                f"joint `{joint.name}` has `{name}` = {value:g}, allowed is {allowed.allowed}",
                hint="give the largest value that the joint may reach",
                data={"found": value},
            )


def _placement(number: int, joint: Joint, place_of: PlaceOf) -> Iterator[Diagnostic]:
    if not all(map(isfinite, (*joint.placement.as_tuple(), joint.offset, joint.lead))):
        place = place_of(AuditPlace(number, Attribute.PLACEMENT))
        yield _not_finite(f"the placement of joint `{joint.name}`", place)


def _link(number: int, link: Link, place_of: PlaceOf) -> Iterator[Diagnostic]:
    of_mass, of_inertia = (
        place_of(AuditPlace(number, which)) for which in (Attribute.MASS, Attribute.INERTIA)
    )
    yield from body_findings(f"link `{number + 1}`", link, of_mass, of_inertia)


def body_findings(
    name: str, body: Body, of_mass: Span | None = None, of_inertia: Span | None = None
) -> Iterator[Diagnostic]:
    """Yield the mass and inertia of a body that cannot be; all of them are errors.

    Args:
        name: of the body, as its messages say it.
        body: a link, a tool or a payload.
        of_mass: where its mass stands in the file that it was read from.
        of_inertia: where its inertia stands there.
    """
    if not all(map(isfinite, (body.mass, *body.com.ravel().tolist(), *body.inertia.ravel().tolist()))):
        yield _not_finite(f"the data of {name}", of_mass)
        return
    if body.mass < 0.0:
        yield _negative_mass(name, body.mass, of_mass)
    if not body.inertia.any():
        return
    if not is_symmetric(body.inertia):
        yield kinds.ASYMMETRIC_INERTIA.at(
            of_inertia,
            f"the inertia tensor of {name} is not symmetric",
            hint="write each product of inertia on both sides of the diagonal",
        )
        return
    a, b, c = moments = principal_moments(body.inertia)
    if body.mass and a < -MOMENT_SLACK * c:
        yield kinds.NEGATIVE_INERTIA.at(
            of_inertia,
            f"{name} has the principal moments of inertia {a:.4g}, {b:.4g}, {c:.4g} kg·m², those of a "
            "body are positive",
            hint="check the signs of the tensor, and that it is the one about the centre of mass",
            data={"moments_kgm2": moments},
        )


def _drive(number: int, drive: Drive, place_of: PlaceOf) -> Iterator[Diagnostic]:
    parts = (drive.amplifier, drive.motor, drive.transmission, drive.supply, drive.link)
    for block in (part for part in parts if part is not None):
        for name in (field.name for field in fields(block) if field.name != "name"):
            value = getattr(block, name)
            numbers = value if isinstance(value, tuple) else (value,)
            place = place_of(AuditPlace(number, Attribute.DRIVE, name))
            if name in _RANGES_OF_DRIVES:
                yield from _bounded(number, name, float(value), place)
            elif not all(map(isfinite, numbers)):
                yield _not_finite(f"`{name}` of the drive of axis {number + 1}", place)
    if getattr(drive.transmission, "ratio", 1.0) == 0.0:
        yield kinds.UNUSABLE_DRIVE.at(
            place_of(AuditPlace(number, Attribute.DRIVE, "ratio")),
            f"the drive of axis {number + 1} has `ratio` = 0, allowed is a number other than 0",
            hint="give motor angle divided by joint coordinate",
            data={"found": 0.0},
        )
    yield from _friction(number, drive.friction, place_of)


def _bounded(number: int, name: str, value: float, place: Span | None) -> Iterator[Diagnostic]:
    """Yield a limit that is not positive, or an inertia or mass below 0."""
    allowed = _RANGES_OF_DRIVES[name]
    if allowed.allows(value):
        return
    yield kinds.UNUSABLE_DRIVE.at(
        place,
        f"the drive of axis {number + 1} has `{name}` = {value:g}, allowed is {allowed.allowed}",
        hint="check the sign",
        data={"found": value},
    )


def _friction(number: int, law: FrictionParts, place_of: PlaceOf) -> Iterator[Diagnostic]:
    for name, (allowed, hint) in law.RANGES.items():
        value = float(getattr(law, name))
        if not allowed.allows(value):
            yield kinds.UNUSABLE_DRIVE.at(
                place_of(AuditPlace(number, Attribute.DRIVE, name)),
                f"the drive of axis {number + 1} has `{name}` = {value:g}, allowed is {allowed.allowed}",
                hint=hint,
                data={"found": value},
            )


def is_symmetric(inertia: Array) -> bool:
    """Return whether an inertia tensor, shape (3, 3), is one as far as symmetry goes."""
    slack = SYMMETRY_SLACK * float(np.abs(inertia).max())
    return bool((np.abs(inertia - inertia.T) <= slack).all())


def principal_moments(inertia: Array) -> tuple[float, float, float]:
    """Return the principal moments of an inertia tensor, shape (3, 3), rising [kg·m²]."""
    a, b, c = np.linalg.eigvalsh(inertia).tolist()
    return a, b, c


def _not_finite(what: str, span: Span | None) -> Diagnostic:
    return kinds.NOT_FINITE.at(span, f"{what} is not finite", hint="allowed are finite numbers only")


def _negative_mass(name: str, mass: float, span: Span | None) -> Diagnostic:
    message = f"{name} has a mass of {mass:g} kg, allowed is 0 kg or more"
    return kinds.NEGATIVE_MASS.at(span, message, hint="check the sign", data={"mass_kg": mass})
