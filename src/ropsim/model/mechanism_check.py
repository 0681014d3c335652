"""Whether a mechanism can be: its counts, the tree of its joints, its axes, couplings and cuts."""

from collections.abc import Iterator
from functools import lru_cache
from itertools import chain
from math import isfinite

from ropsim.core import Diagnostic, RopsimError
from ropsim.model import mechanism_diagnostics as kinds
from ropsim.model.coordinates import circle
from ropsim.model.diagnostics import COUNT_MISMATCH, HOME_OUT_OF_RANGE
from ropsim.model.joint import BASE_LINK
from ropsim.model.loop_cut import LoopCut
from ropsim.model.mechanism import Mechanism, first_coordinates


class MechanismError(RopsimError):
    """A mechanism cannot be."""


def check_mechanism(mechanism: Mechanism) -> None:
    """Make sure that the joints of a mechanism move its links in one way.

    Raises:
        MechanismError: with the first of its `tree_findings`.
    """
    found = tree_findings(mechanism)
    if found:
        raise MechanismError(found[0])


def check_counts(mechanism: Mechanism) -> None:
    """Make sure that a mechanism has a link for each joint, and drives, if any, for its axes.

    Raises:
        MechanismError: it has not, or `check_mechanism` has something against it.
    """
    found = mechanism_findings(mechanism)
    if found:
        raise MechanismError(found[0])


def check_open(mechanism: Mechanism) -> None:
    """Make sure that a mechanism can be moved by a controller: it has no closed chains that are cut.

    Raises:
        MechanismError: it has, or `check_mechanism` has something against it.
    """
    check_mechanism(mechanism)
    if mechanism.cuts:
        raise MechanismError(
            kinds.LOOP_NOT_SIMULATED.at(
                None,
                f"`{mechanism.name}` has {len(mechanism.cuts)} closed chains that are cut",
                hint="describe it by couplings where its coordinates are linear functions of the axes",
            )
        )


def mechanism_findings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return the contradictions of a mechanism: of its counts, and those of `tree_findings`."""
    return (*_counts(mechanism), *tree_findings(mechanism))


@lru_cache(maxsize=256)
def tree_findings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return what is wrong with joints, axes, couplings and loops; without that kinematics has a meaning."""
    tree = (*_names(mechanism), *_parents(mechanism), *_axes(mechanism), *_external(mechanism))
    return tree or tuple(chain(_couplings(mechanism), _loops(mechanism)))


def coordinate_name(mechanism: Mechanism, number: int) -> str:
    """Return a coordinate in words: its joint, and which of its coordinates where it has several."""
    first = first_coordinates(mechanism.joints)
    for joint, start, end in zip(mechanism.joints, first, first[1:], strict=False):
        if start <= number < end:
            several = f", coordinate {number - start + 1}" if end - start > 1 else ""
            return f"joint `{joint.name}`{several}"
    return f"coordinate {number}"


def _counts(mechanism: Mechanism) -> Iterator[Diagnostic]:
    joints, n = len(mechanism.joints), mechanism.n
    rows = (
        ("links", len(mechanism.links), joints, "joints"),
        ("drives", len(mechanism.drives) or n, n, "axes"),
    )
    for what, count, allowed, of in rows:
        if count != allowed:
            yield COUNT_MISMATCH.at(
                None,
                f"`{mechanism.name}` has {count} {what} for {allowed} {of}",
                hint=f"give one entry of {what} for each of the {of}",
                data={"found": count, "allowed": allowed},
            )
    if mechanism.home.shape != (n,):
        yield HOME_OUT_OF_RANGE.at(
            None,
            f"the home position has {mechanism.home.size} coordinates for {n} axes",
            hint="give one coordinate for each axis",
            data={"found": mechanism.home.size, "allowed": n},
        )


def _names(mechanism: Mechanism) -> Iterator[Diagnostic]:
    names = [joint.name for joint in mechanism.joints]
    for name in dict.fromkeys(name for name in names if names.count(name) > 1):
        yield kinds.SAME_NAME.at(
            None,
            f"`{mechanism.name}` has {names.count(name)} joints called `{name}`",
            hint="give each joint its own name",
            data={"found": name},
        )


def _parents(mechanism: Mechanism) -> Iterator[Diagnostic]:
    for number, joint in enumerate(mechanism.joints):
        if BASE_LINK <= joint.parent < number:
            continue
        if not BASE_LINK <= joint.parent < len(mechanism.joints):
            found = f"link {joint.parent + 1}, which does not exist"
        elif number in _way_up(mechanism, number):
            found = f"link {joint.parent + 1}, which hangs on it"
        else:
            found = f"link {joint.parent + 1}, which comes after it"
        yield kinds.BAD_PARENT.at(
            None,
            f"joint `{joint.name}` is carried by {found}",
            hint=f"allowed are the base and links before it, 1 to {number}"
            if number
            else "put it on the base",
            data={"joint": joint.name, "parent": joint.parent},
        )
    tip = mechanism.interface_link
    if not BASE_LINK <= tip < len(mechanism.joints):
        yield kinds.BAD_PARENT.at(
            None,
            f"the interface of `{mechanism.name}` is on link {tip + 1}, which does not exist",
            hint=f"allowed are the links 1 to {len(mechanism.joints)}",
            data={"found": tip},
        )


def _way_up(mechanism: Mechanism, number: int) -> set[int]:
    """Return the links that a joint hangs on, as far as they can be followed."""
    found: set[int] = set()
    link = mechanism.joints[number].parent
    while 0 <= link < len(mechanism.joints) and link not in found:
        found.add(link)
        link = mechanism.joints[link].parent
    return found


def _axes(mechanism: Mechanism) -> Iterator[Diagnostic]:
    if not mechanism.axes:
        yield kinds.NO_AXES.at(
            None,
            f"`{mechanism.name}` has no axis",
            hint="a mechanism needs a joint with one freedom that is driven",
        )
    first = first_coordinates(mechanism.joints)
    dependent = {coupling.dependent for coupling in mechanism.couplings}
    for place, number in enumerate(mechanism.axes):
        if not 0 <= number < len(mechanism.joints):
            why = f"joint {number + 1}, which does not exist"
        elif number in mechanism.axes[:place]:
            why = f"joint `{mechanism.joints[number].name}` a second time"
        elif mechanism.joints[number].type.freedoms != 1:
            joint = mechanism.joints[number]
            why = f"joint `{joint.name}`, which has {joint.type.freedoms} freedoms"
        elif first[number] in dependent:
            why = f"joint `{mechanism.joints[number].name}`, which follows others by a coupling"
        else:
            continue
        yield kinds.BAD_AXIS.at(
            None,
            f"axis {place + 1} of `{mechanism.name}` is {why}",
            hint="an axis drives a joint with one freedom that nothing else determines, each one once",
            data={"found": number},
        )


def _external(mechanism: Mechanism) -> Iterator[Diagnostic]:
    external: tuple[int, ...] = getattr(mechanism, "external", ())
    twice = len(set(external)) != len(external)
    if twice or not set(external) <= set(range(mechanism.n)) or (external and len(external) >= mechanism.n):
        yield kinds.BAD_EXTERNAL.at(
            None,
            f"`{mechanism.name}` has the external axes {list(external)} of {mechanism.n} axes",
            hint="name axes by their numbers from 0, each once, and leave one to the arm",
            data={"found": external, "allowed": mechanism.n},
        )


def _couplings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return what is wrong with couplings; only where that is nothing, which coordinates nobody moves."""
    wrong = (*_impossible_couplings(mechanism), *_coupling_circle(mechanism))
    return wrong or tuple(_free_coordinates(mechanism))


def _impossible_couplings(mechanism: Mechanism) -> Iterator[Diagnostic]:
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


def _coupling_circle(mechanism: Mechanism) -> Iterator[Diagnostic]:
    way = circle(mechanism.couplings)
    if way:
        names = " → ".join(coordinate_name(mechanism, number) for number in (*way, way[0]))
        yield kinds.COUPLING_CIRCLE.at(
            None,
            f"couplings of `{mechanism.name}` go in a circle: {names}",
            hint="let each coordinate follow axes, or coordinates that follow axes",
            data={"found": way},
        )


def _free_coordinates(mechanism: Mechanism) -> Iterator[Diagnostic]:
    held = _held_coordinates(mechanism)
    count = first_coordinates(mechanism.joints)[-1] if not mechanism.cuts else 0
    for number in range(count):
        if number not in held:
            yield kinds.FREE_COORDINATE.at(
                None,
                f"{coordinate_name(mechanism, number)} of `{mechanism.name}` is no axis and not coupled",
                hint="make it an axis, or give a coupling that it follows",
                data={"found": number},
            )


def _loops(mechanism: Mechanism) -> Iterator[Diagnostic]:
    cuts = mechanism.cuts
    known = _held_coordinates(mechanism)
    for place, cut in enumerate(cuts):
        ends = (cut.first, cut.second)
        if not all(BASE_LINK <= link < len(mechanism.joints) for link in ends) or cut.first == cut.second:
            yield kinds.BAD_CUT.at(
                None,
                f"cut {place + 1} of `{mechanism.name}` lies between links {ends[0] + 1} and {ends[1] + 1}",
                hint=f"allowed are two of the base (0) and the links 1 to {len(mechanism.joints)}",
            )
        elif any(_same(cut, other) for other in cuts[:place]):
            yield kinds.LOOP_TWICE.at(
                None,
                f"cut {place + 1} of `{mechanism.name}` holds what an earlier one holds already",
                hint="describe each loop by one cut",
            )
        elif _between(mechanism, cut) <= known:
            yield kinds.LOOP_TWICE.at(
                None,
                f"cut {place + 1} of `{mechanism.name}` closes a loop whose coordinates are axes or coupled",
                hint="leave out the cut or the couplings",
            )


def _held_coordinates(mechanism: Mechanism) -> set[int]:
    """Return the coordinates that axes and couplings determine."""
    first = first_coordinates(mechanism.joints)
    return {first[number] for number in mechanism.axes} | {one.dependent for one in mechanism.couplings}


def _between(mechanism: Mechanism, cut: LoopCut) -> set[int]:
    """Return the coordinates of the joints of a loop."""
    first = first_coordinates(mechanism.joints)
    ways = [
        {link, *_way_up(mechanism, link)} if link != BASE_LINK else set() for link in (cut.first, cut.second)
    ]
    return {
        number
        for link in ways[0] ^ ways[1]
        if link != BASE_LINK
        for number in range(first[link], first[link + 1])
    }


def _same(one: LoopCut, other: LoopCut) -> bool:
    """Return whether two cuts hold the same places of two links together, in a common direction."""
    ends = {(one.first, one.X_first), (one.second, one.X_second)}
    others = {(other.first, other.X_first), (other.second, other.X_second)}
    return ends == others and bool(set(one.held) & set(other.held))
