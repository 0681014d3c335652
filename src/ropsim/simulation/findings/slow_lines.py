"""The hint that a line, or a chain of lines, is flown slower than programmed, and what would help."""

import math
from collections.abc import Iterable, Sequence

from ropsim.core import Diagnostic, Span
from ropsim.flow import LimitQuantity, MoveEvent, ReachedSpeed, SpeedCause
from ropsim.motion import SINGULARITY_HINTS
from ropsim.simulation.diagnostics.limit_diagnostics import SLOWER_THAN_PROGRAMMED
from ropsim.simulation.findings.finished_station import FinishedStation

LEAST, SHARE = 0.1, 0.02
"""Time that a line loses at least to be reported [s], and its share of the time in motion."""
_SHOWN = 0.1
"""Share of the time of a line from which on its ramps at stops are worth saying."""
CHAIN = 6
"""Lines flown one after the other without a stop from which on they are reported together."""

_HINTS = {
    SpeedCause.ACCELERATION: "a longer move, or a larger zone at its ends",
    SpeedCause.JERK: "a longer move, or a larger zone at its ends",
    SpeedCause.TURN_SPEED: "turn the tool over a longer way, or with more `orientation_speed`",
    SpeedCause.TURN_ACCELERATION: "turn the tool over a longer way, or with more `orientation_acceleration`",
    SpeedCause.ZONE: "a larger zone, or a corner that is less sharp",
    SpeedCause.BEND: "a wider bend",
    SpeedCause.JOINT: "another posture or place may need less of the joint; a lower speed may be as quick",
    SpeedCause.EXTERNAL: "let the external axes go less far on this way, or move them before",
    SpeedCause.LOOK_AHEAD: "give the controller a larger `look_ahead`, if the real one has it",
}
_KEYS = {LimitQuantity.ACCELERATION: "`path_acceleration`", LimitQuantity.JERK: "`path_jerk`"}
"""Keys of the cell file for the limits that may help."""
_MANY, _SLOW = 20, 0.5
"""Points of a curve from which on it is asked whether it needs them, if it is slower than this share."""
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
    worst, reached = _speaking(passes)
    point = worst.origin.point if worst.origin else None
    to = f" to {point}" if point else ""
    several = f"{len(passes)} moves of this line take" if point else f"in {len(passes)} passes it takes"
    some = several if len(passes) > 1 else "it takes"
    words = f"this move of {_millimetres(reached.length)}{to} {_speed(worst, reached)}: {_why(reached)}"
    if len(passes) >= CHAIN:
        way = math.fsum(one.length for _, one in passes)
        time = math.fsum(one.travel for one, _ in passes)
        at = f" at {point}" if point else ""
        some = "they take"
        words = (
            f"{len(passes)} moves of this line, {_millimetres(way / len(passes))} long on average, are flown "
            f"at {way / time * 1e3:.0f} of {(worst.path_speed or 0.0) * 1e3:.0f} mm/s: {_why(reached)}{at}"
        )
    return SLOWER_THAN_PROGRAMMED.at(
        worst.span,
        f"{words}; {_times(passes, some)}",
        label=f"pass {worst.visit}" if worst.visit > 1 and not point else "",
        hint=_hint(worst, reached),
        data=_data(worst, reached, passes),
    )


def _times(moves: Sequence[_Slow], some: str) -> str:
    """Return how long moves take, how long they would at their speed, and what of that ramps at stops are."""
    taken = math.fsum(one.travel for one, _ in moves)
    least = math.fsum(reached.length / one.path_speed for one, reached in moves if one.path_speed)
    ramps = max(taken - least - _lost(moves), 0.0)
    stops = f", {ramps:.2f} s of it for ramps at stops" if ramps >= _SHOWN * taken else ""
    return f"{some} {taken:.2f} s{stops}, at full speed all the way {least:.2f} s"


def _hint(move: MoveEvent, reached: ReachedSpeed) -> str:
    """Return what helps: of the limits of the path only those that were found to."""
    given = move.path_speed or 0.0
    if reached.points >= _MANY and move.travel > 0.0 and reached.length / move.travel < _SLOW * given:
        many = "a smooth curve bends anew at each of its many points"
        return f"{many}: take fewer of them; a chain, `lin along … blend …`, is often quicker"
    hint = SINGULARITY_HINTS.get(reached.singularity, _HINTS[reached.cause])
    if not reached.helps:
        return hint
    keys = " and ".join(_KEYS[one] for one in reached.helps)
    return f"{hint}; or more {keys}, if the real controller has it"


def _of_chains(chains: Sequence[Sequence[_Slow]]) -> Diagnostic:
    longest = max(chains, key=_lost)
    first = longest[0][0]
    worst, reached = _speaking(longest)
    way = math.fsum(reached.length for _, reached in longest)
    time = math.fsum(one.travel for one, _ in longest)
    lines, given = len({one.span for one, _ in longest}), worst.path_speed or 0.0
    all_moves = [one for chain in chains for one in chain]
    others = f"with {len(chains) - 1} more chains like this " if len(chains) > 1 else ""
    return SLOWER_THAN_PROGRAMMED.at(
        first.span,
        f"a chain of {lines} lines begins here that is flown at {way / time * 1e3:.0f} of "
        f"{given * 1e3:.0f} mm/s, in moves of {_millimetres(way / len(longest))}: {_why(reached)}; "
        f"{others}{_times(all_moves, 'it takes')}",
        hint=_hint(worst, reached),
        data={**_data(worst, reached, all_moves), "lines": lines, "chains": len(chains)},
    )


def _speaking(moves: Sequence[_Slow]) -> _Slow:
    """Return the move that speaks for others: it has the cause that costs most, and loses most of those."""
    causes: dict[SpeedCause, float] = {}
    for _, reached in moves:
        causes[reached.cause] = causes.get(reached.cause, 0.0) + reached.lost
    cause = max(causes, key=causes.__getitem__)
    alike = (one for one in moves if one[1].cause is cause)
    return max(alike, key=lambda one: (one[1].helps is not None, one[1].lost))


def _data(worst: MoveEvent, reached: ReachedSpeed, moves: Sequence[_Slow]) -> dict[str, object]:
    given = worst.path_speed or 0.0
    return {
        **(worst.origin.data if worst.origin else {}),
        "top_m_s": reached.top,
        "given_m_s": given,
        "cause": reached.cause.value,
        "joint": reached.joint,
        "singularity": reached.singularity,
        "helps": tuple(one.value for one in reached.helps or ()),
        "lost_s": _lost(moves),
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
    corner = f"{math.degrees(reached.corner):.3g}"
    radius = f"radius {_millimetres(value)}" if math.isfinite(value) else "its ends"
    alone = ", more of it alone would not help" if reached.helps == () else ""
    words = {
        SpeedCause.ACCELERATION: f"path acceleration {value:.3g} m/s²{alone}",
        SpeedCause.JERK: f"path jerk {value:.3g} m/s³{alone}",
        SpeedCause.TURN_SPEED: f"{turn}, rotation speed {math.degrees(value):.3g}°/s",
        SpeedCause.TURN_ACCELERATION: f"{turn}, rotation acceleration {math.degrees(value):.3g}°/s²",
        SpeedCause.ZONE: f"a zone of {_millimetres(value)} at a corner of {corner}°",
        SpeedCause.BEND: f"the way is bent, {radius}",
        SpeedCause.JOINT: f"joint `{reached.joint}` is at its {quantity} limit{near}",
        SpeedCause.EXTERNAL: "an external axis that goes along is at its limit",
        SpeedCause.LOOK_AHEAD: "the controller does not look further ahead",
    }
    return words[reached.cause]


def _millimetres(length: float) -> str:
    return f"{length * 1e3:.3g} mm"
