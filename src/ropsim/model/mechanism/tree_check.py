"""Errors in the joints of a mechanism as a tree, and in its axes."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.mechanism.links import BASE_LINK
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates


def name_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X830 for each name that several joints have."""
    names = [joint.name for joint in mechanism.joints]
    for name in dict.fromkeys(name for name in names if names.count(name) > 1):
        yield kinds.SAME_NAME.at(
            None,
            f"`{mechanism.name}` has {names.count(name)} joints called `{name}`",
            hint="give each joint its own name",
            data={"found": name},
        )


def parent_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X831 for each joint, and an interface, on a link that cannot carry it."""
    for number, joint in enumerate(mechanism.joints):
        if BASE_LINK <= joint.parent < number:
            continue
        if not BASE_LINK <= joint.parent < len(mechanism.joints):
            found = f"link {joint.parent + 1}, which does not exist"
        elif number in way_up(mechanism, number):
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


def way_up(mechanism: Mechanism, number: int) -> set[int]:
    """Return the links above a joint, up to the first error."""
    found: set[int] = set()
    link = mechanism.joints[number].parent
    while 0 <= link < len(mechanism.joints) and link not in found:
        found.add(link)
        link = mechanism.joints[link].parent
    return found


def axis_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X832 where nothing is driven, X833 for each axis that cannot be."""
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


def external_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X828 where external axes are no axes."""
    external: tuple[int, ...] = getattr(mechanism, "external", ())
    twice = len(set(external)) != len(external)
    if twice or not set(external) <= set(range(mechanism.n)):
        yield kinds.BAD_EXTERNAL.at(
            None,
            f"`{mechanism.name}` has the external axes {list(external)} of {mechanism.n} axes",
            hint="name axes by their numbers from 0, each once",
            data={"found": external, "allowed": mechanism.n},
        )
