"""Errors in the couplings of a mechanism."""

from collections.abc import Iterator
from math import isfinite

from ropsim.core import Diagnostic
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.mechanism.coordinates import circle
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates


def coupling_findings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return the errors in couplings; without any, the coordinates that nothing moves."""
    wrong = (*_impossible(mechanism), *_circle(mechanism))
    return wrong or tuple(_free(mechanism))


def coordinate_name(mechanism: Mechanism, number: int) -> str:
    """Return a coordinate in words: its joint, and which of its coordinates where it has several."""
    first = first_coordinates(mechanism.joints)
    for joint, start, end in zip(mechanism.joints, first, first[1:], strict=False):
        if start <= number < end:
            several = f", coordinate {number - start + 1}" if end - start > 1 else ""
            return f"joint `{joint.name}`{several}"
    return f"coordinate {number}"


def _impossible(mechanism: Mechanism) -> Iterator[Diagnostic]:
    count = first_coordinates(mechanism.joints)[-1]
    seen: set[int] = set()
    for coupling in mechanism.couplings:
        numbers = (coupling.dependent, *(number for number, _ in coupling.terms))
        absent = [number for number in numbers if not 0 <= number < count]
        name = coordinate_name(mechanism, coupling.dependent)
        values = (coupling.constant, *(factor for _, factor in coupling.terms))
        if absent:
            why = f"names coordinate {absent[0]}, there are {count}, counted from 0"
        elif coupling.dependent in seen:
            why = f"determines {name} a second time"
        elif not all(map(isfinite, values)):
            why = f"of {name} holds a number that is not finite"
        else:
            seen.add(coupling.dependent)
            continue
        message = f"a coupling of `{mechanism.name}` {why}"
        yield kinds.BAD_COUPLING.at(None, message, hint="look at its numbers")


def _circle(mechanism: Mechanism) -> Iterator[Diagnostic]:
    way = circle(mechanism.couplings)
    if way:
        names = " → ".join(coordinate_name(mechanism, number) for number in (*way, way[0]))
        yield kinds.COUPLING_CIRCLE.at(
            None,
            f"couplings of `{mechanism.name}` go in a circle: {names}",
            hint="let each coordinate follow axes, or coordinates that follow axes",
            data={"found": way},
        )


def _free(mechanism: Mechanism) -> Iterator[Diagnostic]:
    held = held_coordinates(mechanism)
    count = first_coordinates(mechanism.joints)[-1] if not mechanism.cuts else 0
    for number in range(count):
        if number not in held:
            yield kinds.FREE_COORDINATE.at(
                None,
                f"{coordinate_name(mechanism, number)} of `{mechanism.name}` is no axis and not coupled",
                hint="make it an axis, or give a coupling that it follows",
                data={"found": number},
            )


def held_coordinates(mechanism: Mechanism) -> set[int]:
    """Return the coordinates that axes and couplings determine."""
    first = first_coordinates(mechanism.joints)
    return {first[number] for number in mechanism.axes} | {one.dependent for one in mechanism.couplings}
