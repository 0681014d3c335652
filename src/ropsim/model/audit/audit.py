"""Audit of a mechanism: contradictions, doubts, estimates."""

from collections.abc import Iterator
from itertools import chain

from ropsim.core import Diagnostic
from ropsim.flow import OriginKind
from ropsim.model.audit.doubts import doubts
from ropsim.model.findings import diagnostics as kinds
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf, nowhere
from ropsim.model.mechanism.coupled_limits import coupled_limits
from ropsim.model.mechanism.links import JointType, Link
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.model.mechanism.mechanism_check import mechanism_findings
from ropsim.model.mechanism.number_check import principal_moments

TRIANGLE_SLACK = 1e-9
"""Relative slack of the triangle inequality: products of rotations leave rounding errors in the moments."""


def audit(robot: Mechanism, place_of: PlaceOf = nowhere) -> tuple[Diagnostic, ...]:
    """Return the findings about a mechanism, in the order structure, links, home, doubts, origins.

    Errors are contradictions (missing links, circles of couplings, a home position out of range); numbers
    that cannot be are refused where the mechanism is made. Warnings are numbers that no rigid body can have
    but that published sets contain (A + B < C), and numbers that are unusual for an arm (`doubts`). Hints
    name massless links, limits that look copied and estimates. An impossible structure ends the check.

    Args:
        robot: audited mechanism.
        place_of: where its numbers stand in the file that it was read from.
    """
    structure = mechanism_findings(robot)
    if structure:
        return structure
    found = tuple(
        chain(
            _without_mass(robot, place_of),
            chain.from_iterable(_moments(k, link, place_of) for k, link in enumerate(robot.links)),
            _home(robot, place_of),
            _coupled_home(robot),
        )
    )
    doubtful = () if any(one.is_error for one in found) else doubts(robot, place_of)
    return (*found, *doubtful, *_origins(robot))


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


def _moments(number: int, link: Link, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield moments of inertia that no body has, but that published sets contain."""
    if not link.inertia.any():  # a point mass, allowed as an idealisation
        return
    a, b, c = moments = principal_moments(link.inertia)
    figures = f"{a:.4g}, {b:.4g}, {c:.4g} kg·m²"
    place = place_of(AuditPlace(number, Attribute.INERTIA))
    if a <= 0.0:
        yield kinds.INDEFINITE_INERTIA.at(
            place,
            f"link `{number + 1}` has the principal moments of inertia {figures}, those of a body are "
            "positive",
            hint="keep them if the source says so; check signs otherwise",
            data={"moments_kgm2": moments},
        )
    elif a + b < c * (1.0 - TRIANGLE_SLACK):
        yield kinds.TRIANGLE_VIOLATED.at(
            place,
            f"link `{number + 1}` has the moments of inertia {figures}, allowed for the last is {a + b:.4g}",
            hint="keep them if they are as published",
            data={"moments_kgm2": moments},
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
    """Yield one finding on all that is estimated, with a note on the source of each estimate."""
    estimated = [one for one in robot.origins if one.kind is OriginKind.ESTIMATED]
    if estimated:
        what = ", ".join(one.parameters for one in estimated)
        sources = tuple(f"{one.parameters}: {one.source}" for one in estimated)
        yield kinds.ESTIMATED_PARAMETERS.at(None, f"estimated in `{robot.name}`: {what}", notes=sources)
