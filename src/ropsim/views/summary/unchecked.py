"""Omitted checks of a verdict, in the same words everywhere, and the time lost by manual slowing."""

from collections.abc import Iterable, Iterator, Sequence

from ropsim.core import Diagnostic, frozen_dataclass, plural
from ropsim.flow import SLOWEST, OverrideChange, RunFacts, in_time
from ropsim.views.words.characters import clean
from ropsim.views.words.figures import PERCENT, seconds


@frozen_dataclass
class ByHand:
    """How long a run was held and slowed by hand within its cycle time.

    Attributes:
        held: time at an override of 0 [s].
        slowed: time at an override between 0 and 1 [s].
        slowest: least override requested, except holds; 1 if never below.
        is_held: whether it was held at all, be it for no time or behind the end of the cycle.
        held_in_all: time at an override of 0 until the run ended, including time behind the end of the cycle
            [s].
    """

    held: float = 0.0
    slowed: float = 0.0
    slowest: float = 1.0
    is_held: bool = False
    held_in_all: float = 0.0

    @property
    def mark(self) -> str:
        """Return a few words to be shown next to the cycle time; empty without manual interventions.

        Both times follow the override as set: they include braking to a hold, not speeding up after it.
        """
        times = (("held", self.held), ("slowed", self.slowed))
        parts = [f"{word} for {seconds(time)} s" for word, time in times if shown(time)]
        return f"{' and '.join(parts)} by hand" if parts else ""


def by_hand(changes: Sequence[OverrideChange], cycle_time: float, duration: float) -> ByHand:
    """Return the effect of override changes on a run until the end of its cycle.

    Args:
        changes: of the override; before the first one it is 1.
        cycle_time: end of the last motion or instruction [s].
        duration: end of the run [s].
    """
    lasting = _lasting(changes, cycle_time)
    return ByHand(
        held=sum(time for value, time in lasting if value == 0.0),
        slowed=sum(time for value, time in lasting if 0.0 < value < 1.0),
        slowest=min((value for value, _ in lasting if value > 0.0), default=1.0),
        is_held=any(value == 0.0 for value, _ in lasting),
        held_in_all=sum(time for value, time in _lasting(changes, duration) if value == 0.0),
    )


def _lasting(changes: Sequence[OverrideChange], until: float) -> list[tuple[float, float]]:
    """Return each override, 0 where it holds, and how long it was in force until a time [s]."""
    ordered = in_time(changes)
    ends = [*(one.time for one in ordered[1:]), float("inf")]
    return [
        (0.0 if one.value < SLOWEST else one.value, max(min(end, until) - one.time, 0.0))
        for one, end in zip(ordered, ends, strict=False)
    ]


def percentage(override: float) -> str:
    """Return an override below 1, never as 100 %: something was slowed."""
    return f"{min(round(override * PERCENT.factor, 1), 99.9):g}\u00a0{PERCENT.unit}"


def shown(time: float) -> bool:
    """Return whether a time is shown: not if it would read 0.00 s."""
    return time >= 0.005


CHECKED_IF_SAID = ("collisions", "rated payload")
"""Checks that depend on the run: omitted unless its recording lists them."""

WITHOUT_DYNAMICS = ("torques", "drives", "servo")
"""Further omitted checks of a kinematic run."""

SHORT = 40
"""Greatest length of the names of groups of estimated parameters; of longer lists groups without a stated
accuracy, such as drawn shapes, are counted."""


@frozen_dataclass
class Unchecked:
    """Open points of the figures and the verdict of a run.

    Attributes:
        given: manual interventions, in words; with them the cycle time is not that of the program.
        aspects: not checked, such as `collisions`.
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
            parts.append(f"estimated: {_names([clean(name) for name in self.estimated])}")
        if self.fine_stops:
            parts.append(f"zones not flown (fine stop) on {plural(len(self.fine_stops), 'line')}")
        return " · ".join(parts)


def _names(estimated: Sequence[str]) -> str:
    """Return groups of estimates in a line: of many only those with an accuracy, as `friction (×3)`."""
    if len(", ".join(estimated)) <= SHORT:
        return ", ".join(estimated)
    named = [name for name in estimated if name.endswith(")")]
    others = len(estimated) - len(named)
    if not named:
        return f"{plural(others, 'group')} of parameters"
    return ", ".join([*named, f"{plural(others, 'other group')} of parameters"] if others else named)


def unchecked(facts: RunFacts, findings: Iterable[Diagnostic], hand: ByHand) -> Unchecked:
    """Return the omitted checks of a run.

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
    """Yield omissions of the collision check."""
    if facts.ways is None:
        return
    if unseen := facts.ways.unseen:
        which = clean(unseen[0]) if len(unseen) == 1 else f"{len(unseen)} bodies"
        yield f"collisions of {which} without a known shape"
    if met := facts.ways.met:
        yield f"collisions of {plural(len(met), 'pair')} in each other at the start"


def given_text(facts: RunFacts, hand: ByHand) -> str:
    """Return manual interventions, such as `by hand: 2 inputs, override down to 50 %, held 3.20 s`."""
    parts = [plural(len(facts.inputs), "input")] if facts.inputs else []
    if hand.slowest < 1.0:
        parts.append(f"override down to {percentage(hand.slowest)}")
    if hand.is_held:
        parts.append(f"held {seconds(hand.held_in_all)} s" if shown(hand.held_in_all) else "held")
    if facts.stopped is not None:
        parts.append(f"stopped at {facts.stopped:.2f} s")
    return f"by hand: {', '.join(parts)}" if parts else ""
