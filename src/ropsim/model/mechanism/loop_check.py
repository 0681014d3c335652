"""Errors in the closed chains of a mechanism."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.mechanism.coupling_check import held_coordinates
from ropsim.model.mechanism.links import BASE_LINK, LoopCut
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates
from ropsim.model.mechanism.tree_check import way_up


def loop_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X837 for each cut that is none, X838 for each loop that is described twice."""
    cuts = mechanism.cuts
    known = held_coordinates(mechanism)
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
        elif loop_coordinates(mechanism, cut) <= known:
            yield kinds.LOOP_TWICE.at(
                None,
                f"cut {place + 1} of `{mechanism.name}` closes a loop whose coordinates are axes or coupled",
                hint="leave out the cut or the couplings",
            )


def loop_coordinates(mechanism: Mechanism, cut: LoopCut) -> set[int]:
    """Return the coordinates of the joints of a loop."""
    first = first_coordinates(mechanism.joints)
    ways = [
        {link, *way_up(mechanism, link)} if link != BASE_LINK else set() for link in (cut.first, cut.second)
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
