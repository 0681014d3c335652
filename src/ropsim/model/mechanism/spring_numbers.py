"""Whether the numbers of springs and dampers can be: stiffness, free length and damping."""

from collections.abc import Iterator, Sequence

from ropsim.core import Diagnostic
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.findings.number_range import FINITE, FROM_ZERO, ModelValueError, NumberRange
from ropsim.model.mechanism.springs import JointSpring, Spring
from ropsim.spatial import Array

_SIGN = "a spring pulls back and a damper brakes: check the sign"
_FINITE = "allowed are finite numbers only"


def check_springs(springs: Sequence[Spring], joint_springs: Sequence[JointSpring]) -> None:
    """Make sure that the numbers of springs can be.

    Raises:
        ModelValueError: X977, with the first of the `spring_number_findings`.
    """
    found = next(spring_number_findings(springs, joint_springs), None)
    if found:
        raise ModelValueError(found)


def spring_number_findings(
    springs: Sequence[Spring], joint_springs: Sequence[JointSpring]
) -> Iterator[Diagnostic]:
    """Yield X977 for each number of a spring that cannot be.

    Stiffness, damping and free length are 0 or more; all numbers are finite.

    Args:
        springs: between bodies.
        joint_springs: on coordinates.
    """
    for spring in springs:
        named = f"spring `{spring.name}`"
        yield from _point(named, "point_1", spring.point_1)
        yield from _point(named, "point_2", spring.point_2)
        for name in ("stiffness", "free_length", "damping"):
            yield from _number(named, name, float(getattr(spring, name)), FROM_ZERO)
    for one in joint_springs:
        named = f"joint spring `{one.name}`"
        yield from _number(named, "stiffness", one.stiffness, FROM_ZERO)
        yield from _number(named, "rest", one.rest, FINITE)
        yield from _number(named, "damping", one.damping, FROM_ZERO)


def _point(named: str, name: str, point: Array) -> Iterator[Diagnostic]:
    if point.shape != (3,):
        message = f"{named} has `{name}` with {point.size} numbers, allowed are 3"
        yield kinds.BAD_SPRING.at(None, message, hint="give x, y and z in the frame of the link [m]")
        return
    for value in point.tolist():
        yield from _number(named, name, value, FINITE)


def _number(named: str, name: str, value: float, allowed: NumberRange) -> Iterator[Diagnostic]:
    if not allowed.allows(value):
        yield kinds.BAD_SPRING.at(
            None,
            f"{named} has `{name}` = {value:g}, allowed is {allowed.allowed}",
            hint=_FINITE if allowed is FINITE else _SIGN,
            data={"found": value},
        )
