"""What a verdict leaves unchecked: one line next to it, the same in terminal, page and studio."""

from collections.abc import Iterable, Iterator

from ropsim.core import Diagnostic, frozen_dataclass, plural
from ropsim.flow import RunFacts
from ropsim.views.by_hand import ByHand, percentage, shown
from ropsim.views.characters import clean
from ropsim.views.figures import seconds

CHECKED_IF_SAID = ("collisions", "rated payload")
"""What a run has checked only where its recording says so."""

WITHOUT_DYNAMICS = ("torques", "drives", "servo")
"""What a kinematic run does not look at, beside that."""

SHORT = 40
"""Groups of estimated parameters are named if their names take at most so many characters, else counted."""


@frozen_dataclass
class Unchecked:
    """What the figures and the verdict of a run leave open.

    Attributes:
        given: what was done to the run by hand, in words; the cycle time is that of the program only without.
        aspects: not looked at, such as `collisions`.
        estimated: groups of parameters that are estimates, as the model names them.
        fine_stops: source lines with a finding that a zone is not flown (a fine stop), text after text.
    """

    given: str = ""
    aspects: tuple[str, ...] = ()
    estimated: tuple[str, ...] = ()
    fine_stops: tuple[int, ...] = ()

    @property
    def text(self) -> str:
        """Return all of it as one line; empty where nothing is left open."""
        parts = [self.given] if self.given else []
        if self.aspects:
            parts.append(f"not checked: {', '.join(self.aspects)}")
        if self.estimated:
            names = ", ".join(clean(name) for name in self.estimated)
            count = plural(len(self.estimated), "group")
            parts.append(f"estimated: {names if len(names) <= SHORT else f'{count} of parameters'}")
        if self.fine_stops:
            parts.append(f"zones not flown (fine stop) on {plural(len(self.fine_stops), 'line')}")
        return " · ".join(parts)


def unchecked(facts: RunFacts, findings: Iterable[Diagnostic], hand: ByHand) -> Unchecked:
    """Return what a run did not look at.

    Args:
        facts: of the run.
        findings: of the run.
        hand: how long it was held and slowed.
    """
    aspects = CHECKED_IF_SAID + (WITHOUT_DYNAMICS if facts.is_kinematic else ())
    stops = {(one.span.source, one.span.line) for one in findings if one.span and _is_fine_stop(one)}
    return Unchecked(
        given_text(facts, hand),
        (*_on_ways(facts), *(one for one in aspects if one not in facts.checked)),
        tuple(dict.fromkeys(name for station in facts.stations for name in station.estimated)),
        tuple(line for _, line in sorted(stops)),
    )


def _is_fine_stop(finding: Diagnostic) -> bool:
    """Return whether a finding says that the arm stops where a zone is in force."""
    zone = finding.data.get("zone_m")
    return isinstance(zone, float) and zone > 0.0 and "flown_m" not in finding.data


def _on_ways(facts: RunFacts) -> Iterator[str]:
    """Yield what a look for collisions did not see."""
    if facts.ways is None:
        return
    if unseen := facts.ways.unseen:
        which = clean(unseen[0]) if len(unseen) == 1 else f"{len(unseen)} bodies"
        yield f"collisions of {which} without a known shape"
    if met := facts.ways.met:
        yield f"collisions of {plural(len(met), 'pair')} in each other at the start"


def given_text(facts: RunFacts, hand: ByHand) -> str:
    """Return what was done to a run, such as `by hand: 2 inputs, override down to 50 %, held 3.20 s`."""
    parts = [plural(len(facts.inputs), "input")] if facts.inputs else []
    if hand.slowest < 1.0:
        parts.append(f"override down to {percentage(hand.slowest)}")
    if hand.is_held:
        parts.append(f"held {seconds(hand.held_in_all)} s" if shown(hand.held_in_all) else "held")
    if facts.stopped is not None:
        parts.append(f"stopped at {facts.stopped:.2f} s")
    return f"by hand: {', '.join(parts)}" if parts else ""
