"""The hint that a line, or a chain of lines, is flown slower than programmed, and what would help."""

import math
from collections.abc import Iterable, Sequence

from ropsim.core import Diagnostic, Span
from ropsim.flow import MoveEvent, ReachedSpeed, SpeedCause
from ropsim.motion import SINGULARITY_HINTS
from ropsim.simulation.diagnostics.limit_diagnostics import SLOWER_THAN_PROGRAMMED
from ropsim.simulation.findings.finished_station import FinishedStation

LEAST, SHARE = 0.1, 0.02
"""Time that a line loses at least to be reported [s], and its share of the time in motion."""
CHAIN = 6
"""Lines flown one after the other without a stop from which on they are reported together."""

_HINTS = {
    SpeedCause.ACCELERATION: "a longer move, a larger zone at its ends, or more `path_acceleration` helps",
    SpeedCause.JERK: "a longer move, a larger zone at its ends, or more `path_jerk` helps",
    SpeedCause.TURN_SPEED: "turn the tool over a longer way, or with more `orientation_speed`",
    SpeedCause.TURN_ACCELERATION: "turn the tool over a longer way, or with more `orientation_acceleration`",
    SpeedCause.ZONE: "a larger zone, a corner that is less sharp, or more path acceleration helps",
    SpeedCause.BEND: "a wider bend, more path acceleration or jerk; a lower speed costs nothing here",
    SpeedCause.JOINT: "another posture or place may need less of the joint; a lower speed may be as quick",
    SpeedCause.EXTERNAL: "let the external axes go less far on this way, or move them before",
    SpeedCause.LOOK_AHEAD: "give the controller a larger `look_ahead`, if the real one has it",
}
_Slow = tuple[MoveEvent, ReachedSpeed]


def slow_lines(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S727 for lines that lose much time against their programmed speed, worst pass shown.

    Lines that are slowed by a joint and reported for that (M563) are left out. Of chains of many lines the
    one that loses most is reported, for all of them.
    """
    moves = [one for one in station.events if isinstance(one, MoveEvent)]
    worth = max(LEAST, SHARE * sum(one.travel for one in moves))
    slow = [(one, one.reached) for one in moves if one.reached and one.span and one.path_speed]
    chains = [chain for chain in _chains(slow) if len({one.span for one, _ in chain}) >= CHAIN]
    in_chains = {one.span for chain in chains for one, _ in chain}
    lines: dict[Span, list[_Slow]] = {}
    for one, reached in slow:
        if one.span and one.span not in in_chains and one.span.line not in station.slowed:
            lines.setdefault(one.span, []).append((one, reached))
    found = [_of_line(passes) for passes in lines.values() if _lost(passes) >= worth]
    if chains and sum(map(_lost, chains)) >= worth:
        found.insert(0, _of_chains(chains))
    return tuple(found)


def _chains(slow: Sequence[_Slow]) -> list[list[_Slow]]:
    """Return the moves that are slow, those together that follow each other through zones."""
    found: list[list[_Slow]] = []
    for one in slow:
        before = found[-1][-1][0] if found else None
        if before and before.flown > 0.0 and one[0].ordinal == before.ordinal + 1:
            found[-1].append(one)
        else:
            found.append([one])
    return found


def _lost(passes: Iterable[_Slow]) -> float:
    return math.fsum(reached.lost for _, reached in passes)


def _of_line(passes: Sequence[_Slow]) -> Diagnostic:
    worst, reached = max(passes, key=lambda one: one[1].lost)
    given, total = worst.path_speed or 0.0, _lost(passes)
    times = f" in {len(passes)} passes" if len(passes) > 1 else ""
    return SLOWER_THAN_PROGRAMMED.at(
        worst.span,
        f"this move of {_millimetres(reached.length)} {_speed(worst, reached)}: {_why(reached)}; "
        f"that costs {total:.2f} s{times}",
        label=f"pass {worst.visit}" if worst.visit > 1 else "",
        hint=SINGULARITY_HINTS.get(reached.singularity, _HINTS[reached.cause]),
        data=_data(worst, reached, given, total),
    )


def _of_chains(chains: Sequence[Sequence[_Slow]]) -> Diagnostic:
    longest = max(chains, key=_lost)
    causes: dict[SpeedCause, float] = {}
    for _, reached in longest:
        causes[reached.cause] = causes.get(reached.cause, 0.0) + reached.lost
    cause = max(causes, key=causes.__getitem__)
    first, total = longest[0][0], math.fsum(map(_lost, chains))
    worst, reached = max((one for one in longest if one[1].cause is cause), key=lambda one: one[1].lost)
    way = math.fsum(reached.length for _, reached in longest)
    time = math.fsum(one.travel for one, _ in longest)
    lines = len({one.span for one, _ in longest})
    given = worst.path_speed or 0.0
    others = f"; {len(chains) - 1} more chains like this" if len(chains) > 1 else ""
    return SLOWER_THAN_PROGRAMMED.at(
        first.span,
        f"a chain of {lines} lines begins here that is flown at {way / time * 1e3:.0f} of "
        f"{given * 1e3:.0f} mm/s, in moves of {_millimetres(way / len(longest))}: {_why(reached)}; "
        f"that costs {total:.2f} s{others}",
        hint=SINGULARITY_HINTS.get(reached.singularity, _HINTS[cause]),
        data={**_data(worst, reached, given, total), "lines": lines, "chains": len(chains)},
    )


def _data(worst: MoveEvent, reached: ReachedSpeed, given: float, total: float) -> dict[str, object]:
    return {
        "pass": worst.visit,
        "top_m_s": reached.top,
        "given_m_s": given,
        "cause": reached.cause.value,
        "joint": reached.joint,
        "singularity": reached.singularity,
        "lost_s": total,
    }


def _speed(move: MoveEvent, reached: ReachedSpeed) -> str:
    """Return how much of its speed a move reaches: at most, or on average where it reaches all of it."""
    given = move.path_speed or 0.0
    if reached.top < 0.9 * given:
        return f"reaches {reached.top * 1e3:.0f} of {given * 1e3:.0f} mm/s"
    mean = reached.length / move.travel if move.travel > 0.0 else 0.0
    return f"is flown at {mean * 1e3:.0f} of {given * 1e3:.0f} mm/s on average"


def _why(reached: ReachedSpeed) -> str:
    """Return what limits the speed, with the value that counts."""
    value, turn = reached.value, f"the tool turns {math.degrees(reached.turn):.3g}° on it"
    near = f", near the singularity of the {reached.singularity}" if reached.singularity else ""
    quantity = reached.quantity.value if reached.quantity else "limit"
    corner = math.degrees(reached.corner)
    radius = f"radius {_millimetres(value)}" if math.isfinite(value) else "its ends"
    words = {
        SpeedCause.ACCELERATION: f"path acceleration {value:.3g} m/s²",
        SpeedCause.JERK: f"path jerk {value:.3g} m/s³",
        SpeedCause.TURN_SPEED: f"{turn}, rotation speed {math.degrees(value):.3g}°/s",
        SpeedCause.TURN_ACCELERATION: f"{turn}, rotation acceleration {math.degrees(value):.3g}°/s²",
        SpeedCause.ZONE: f"a zone of {_millimetres(value)} at a corner of {corner:.2g}°",
        SpeedCause.BEND: f"it is bent, {radius}",
        SpeedCause.JOINT: f"joint `{reached.joint}` is at its {quantity} limit{near}",
        SpeedCause.EXTERNAL: "an external axis that goes along is at its limit",
        SpeedCause.LOOK_AHEAD: "the controller does not look further ahead",
    }
    return words[reached.cause]


def _millimetres(length: float) -> str:
    return f"{length * 1e3:.3g} mm"
