"""Look a mechanism over: what cannot be right, what is doubtful, what is only estimated."""

from collections.abc import Iterator
from itertools import chain
from math import inf, isfinite

import numpy as np

from ropsim.core import Diagnostic, Span
from ropsim.model import diagnostics as kinds
from ropsim.model.audit_place import Attribute, AuditPlace, PlaceOf, nowhere
from ropsim.model.coupled_limits import coupled_limits
from ropsim.model.doubts import doubts
from ropsim.model.joint import Joint, JointType
from ropsim.model.link import Link
from ropsim.model.mechanism import Mechanism
from ropsim.model.mechanism_check import mechanism_findings
from ropsim.spatial import Array

TRIANGLE_SLACK = 1e-9
"""Relative slack of the triangle inequality: products of rotations leave rounding errors in the moments."""

SYMMETRY_SLACK = 1e-9
"""Difference of two products of inertia, relative to the largest entry, that is rounding."""


_MOST = (Attribute.MAX_SPEED, Attribute.MAX_ACCELERATION, Attribute.MAX_JERK, Attribute.MAX_EFFORT)


def is_symmetric(inertia: Array) -> bool:
    """Return whether an inertia tensor, shape (3, 3), is one as far as symmetry goes."""
    slack = SYMMETRY_SLACK * float(np.abs(inertia).max())
    return bool(np.allclose(inertia, inertia.T, rtol=0.0, atol=slack))


def audit(robot: Mechanism, place_of: PlaceOf = nowhere) -> tuple[Diagnostic, ...]:
    """Return the findings about a mechanism, in the order structure, joints, links, home, doubts, origins.

    Errors are contradictions (reversed limits, negative masses, missing links, circles of couplings);
    warnings are numbers that no rigid body can have but that published sets contain (A + B < C), and such as
    are seldom those of an arm (`doubts`); hints name massless links, limits that look copied and estimates. A
    mechanism whose structure cannot be is looked at no further.

    Args:
        robot: that is looked over.
        place_of: where its numbers stand in the file that it was read from.
    """
    structure = mechanism_findings(robot)
    if structure:
        return structure
    found = tuple(
        chain(
            chain.from_iterable(_joint_findings(k, robot.joints[k], place_of) for k in robot.axes),
            chain.from_iterable(_placement(k, joint, place_of) for k, joint in enumerate(robot.joints)),
            _without_mass(robot, place_of),
            chain.from_iterable(_link_findings(k, link, place_of) for k, link in enumerate(robot.links)),
            _home(robot, place_of),
            _coupled_home(robot),
        )
    )
    doubtful = () if any(one.is_error for one in found) else doubts(robot, place_of)
    return (*found, *doubtful, *_origins(robot))


def _joint_findings(number: int, joint: Joint, place_of: PlaceOf) -> Iterator[Diagnostic]:
    unit = "m" if joint.type is JointType.PRISMATIC else "rad"
    if not joint.lower < joint.upper:
        yield kinds.REVERSED_LIMITS.at(
            place_of(AuditPlace(number, Attribute.LIMITS)),
            f"joint `{joint.name}` has the lower limit {joint.lower:g} {unit} and the upper limit "
            f"{joint.upper:g} {unit}",
            hint="the lower limit must be the smaller number",
            data={f"lower_{unit}": joint.lower, f"upper_{unit}": joint.upper},
        )
    for name in _MOST:
        value = float(getattr(joint, name))
        if not (value > 0.0 and (value < inf or name is Attribute.MAX_EFFORT)):
            yield kinds.UNUSABLE_LIMIT.at(
                place_of(AuditPlace(number, name)),
                f"joint `{joint.name}` has `{name}` = {value:g}, allowed is a positive number",
                hint="give the largest value that the joint may reach",
                data={"found": value},
            )


def _placement(number: int, joint: Joint, place_of: PlaceOf) -> Iterator[Diagnostic]:
    if not all(map(isfinite, (*joint.placement.as_tuple(), joint.offset, joint.lead))):
        yield _not_finite(
            f"the placement of joint `{joint.name}`", place_of(AuditPlace(number, Attribute.PLACEMENT))
        )


def _without_mass(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield links without mass; where none has any, the first one for all of them."""
    without = [number for number, link in enumerate(robot.links) if link.mass == 0.0]
    if len(without) == len(robot.links) > 1:
        message = f"no link of `{robot.name}` has a mass"
        yield kinds.MASSLESS_LINK.at(
            place_of(AuditPlace(0, Attribute.MASS)), message, hint="its dynamics cannot be simulated"
        )
        return
    for number in without:
        span = place_of(AuditPlace(number, Attribute.MASS))
        yield kinds.MASSLESS_LINK.at(span, f"link `{number + 1}` has no mass", data={"mass_kg": 0.0})


def _link_findings(number: int, link: Link, place_of: PlaceOf) -> Iterator[Diagnostic]:
    name = str(number + 1)
    of_mass, of_inertia = (
        place_of(AuditPlace(number, which)) for which in (Attribute.MASS, Attribute.INERTIA)
    )
    values = np.concatenate([[link.mass], link.com.ravel(), link.inertia.ravel()])
    if not np.isfinite(values).all():
        yield _not_finite(f"the data of link `{name}`", of_mass)
        return
    if link.mass < 0.0:
        yield kinds.NEGATIVE_MASS.at(
            of_mass,
            f"link `{name}` has a mass of {link.mass:g} kg, allowed is 0 kg or more",
            hint="check the sign",
            data={"mass_kg": link.mass},
        )
    if not is_symmetric(link.inertia):
        yield kinds.ASYMMETRIC_INERTIA.at(
            of_inertia,
            f"the inertia tensor of link `{name}` is not symmetric",
            hint="write each product of inertia on both sides of the diagonal",
        )
        return
    a, b, c = (float(moment) for moment in np.linalg.eigvalsh(link.inertia))
    figures = f"{a:.4g}, {b:.4g}, {c:.4g} kg·m²"
    if a <= 0.0 and link.inertia.any():  # no moments at all: a point mass, allowed as an idealisation
        yield kinds.INDEFINITE_INERTIA.at(
            of_inertia,
            f"link `{name}` has the principal moments of inertia {figures}, those of a body are positive",
            hint="keep them if the source says so; check signs otherwise",
            data={"moments_kgm2": (a, b, c)},
        )
    elif a + b < c * (1.0 - TRIANGLE_SLACK):
        yield kinds.TRIANGLE_VIOLATED.at(
            of_inertia,
            f"link `{name}` has the moments of inertia {figures}, allowed for the last is {a + b:.4g}",
            hint="keep them if they are as published",
            data={"moments_kgm2": (a, b, c)},
        )


def _home(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    for axis, (joint, value) in enumerate(zip(robot.axis_joints, robot.home.tolist(), strict=True)):
        if not joint.lower <= value <= joint.upper:
            unit = "m" if joint.type is JointType.PRISMATIC else "rad"
            yield kinds.HOME_OUT_OF_RANGE.at(
                place_of(AuditPlace(axis, Attribute.HOME)),
                f"the home position has joint `{joint.name}` at {value:.4g} {unit}, allowed is "
                f"{joint.lower:.4g} to {joint.upper:.4g} {unit}",
                hint="move the home position into the limits",
                data={f"found_{unit}": value, f"lower_{unit}": joint.lower, f"upper_{unit}": joint.upper},
            )


def _coupled_home(robot: Mechanism) -> Iterator[Diagnostic]:
    """Yield the joints that follow axes by couplings and are beyond their limits at home."""
    if len(robot.home) != robot.n:
        return
    limits = coupled_limits(robot)
    values, excess = limits.values(robot.home).tolist(), limits.excess(robot.home).tolist()
    for joint, value, beyond in zip(limits.joints, values, excess, strict=True):
        if beyond:
            unit = "m" if joint.measure is JointType.PRISMATIC else "rad"
            yield kinds.HOME_OUT_OF_RANGE.at(
                None,
                f"the home position brings joint `{joint.name}`, which follows axes, to {value:.4g} {unit}, "
                f"allowed is {joint.lower:.4g} to {joint.upper:.4g} {unit}",
                hint="move the home position into the limits",
                data={f"found_{unit}": value, f"lower_{unit}": joint.lower, f"upper_{unit}": joint.upper},
            )


def _origins(robot: Mechanism) -> Iterator[Diagnostic]:
    for origin in robot.origins:
        if origin.kind == "estimated":
            yield kinds.ESTIMATED_PARAMETERS.at(
                None, f"estimated in `{robot.name}`: {origin.parameters}", notes=(origin.source,)
            )


def _not_finite(what: str, span: Span | None) -> Diagnostic:
    return kinds.NOT_FINITE.at(span, f"{what} is not finite", hint="allowed are finite numbers only")
