"""A calibration as text for a terminal."""

import math
from collections.abc import Iterable, Sequence
from itertools import groupby
from textwrap import wrap

from ropsim.calibration import Calibration, Knowledge, SequenceTimes, TraceTime
from ropsim.core import plural
from ropsim.model import JointType
from ropsim.views import Style, TableCell, Tone, columns_text

_SHOWN_LINES = 20
_COLUMNS = 80
_WORTH_MARKING = 0.02
_DEVIATIONS = 2.0
"""Standard deviations by which an uncertain limit may be another one."""
_WORTH_SAYING = 0.1
"""Share from which on that is said."""
_OPEN = 1.0
"""Share of a limit from which on it may have any value."""
_POWERS = ("/s", "/s²", "/s³")
_TURN, _SLIDE = (math.degrees(1.0), "°"), (1e3, "mm")
_OF_TOOL = (("path", _SLIDE), ("orientation", _TURN))


def calibration_text(calibration: Calibration, axes: Sequence[JointType], style: Style) -> str:
    """Return times by line, residuals, and the limits, for a terminal of 80 columns; ends in a line feed.

    Args:
        calibration: the result.
        axes: whether each axis turns or slides, n of them.
        style: whether it has colours.
    """
    lines = [*_times(calibration.sequences, style), *_left_out(calibration), "", *_totals(calibration, axes)]
    lines.append("")
    return "\n".join([*lines, *_limits(calibration, axes, style)]) + "\n"


def _times(sequences: Sequence[SequenceTimes], style: Style) -> list[str]:
    rows = [_row(name, list(some)) for name, some in _by_lines(sequences)]
    title = ("motion", "times", "logged s", "before s", "after s", "left %", "worst %")
    more = len(rows) - _SHOWN_LINES
    found = columns_text(title, rows[:_SHOWN_LINES], style)
    return [*found, f"  … {more} more"] if more > 0 else found


def _left_out(calibration: Calibration) -> list[str]:
    """Return the motions that are not compared, each with its reason."""
    lines_of_limits = [
        line
        for one in calibration.left_out[:_SHOWN_LINES]
        for line in wrap(f"not compared: {_name(one)} pass {one.visit} {one.reason}", _COLUMNS)
    ]
    more = len(calibration.left_out) - _SHOWN_LINES
    return ["", *lines_of_limits, *([f"  … {more} more"] if more > 0 else [])] if lines_of_limits else []


def _by_lines(sequences: Sequence[SequenceTimes]) -> Iterable[tuple[str, Iterable[SequenceTimes]]]:
    names = list(dict.fromkeys(_name(one) for one in sequences))
    ordered = sorted(sequences, key=lambda one: names.index(_name(one)))
    return groupby(ordered, key=_name)


def _name(one: SequenceTimes) -> str:
    if one.first is None or one.last is None:
        return "motion"
    same = one.first.line == one.last.line
    return f"line {one.last.line}" if same else f"line {one.first.line} to {one.last.line}"


def _row(name: str, some: Sequence[SequenceTimes]) -> tuple[TableCell, ...]:
    logged, before, after = (
        sum(getattr(one, field) for one in some) for field in ("logged", "before", "after")
    )
    worst = max((one.remaining for one in some), key=abs)
    tone = Tone.WARNING if abs(worst) > _WORTH_MARKING else None
    times = (TableCell(f"{value:.3f}") for value in (logged, before, after))
    left = TableCell(_percent(after / logged - 1.0))
    return (
        TableCell(name),
        TableCell(str(len(some))),
        *times,
        left,
        TableCell(_percent(worst), tone),
    )


def _totals(calibration: Calibration, axes: Sequence[JointType]) -> list[str]:
    factor, unit = _TURN if JointType.REVOLUTE in axes else _SLIDE
    worst = calibration.worst
    count = len(calibration.sequences)
    compared = (
        f"{count} of {calibration.made} motions" if count < calibration.made else f"all {count} motions"
    )
    alone = sum(not math.isfinite(one.error) for one in calibration.in_trace)
    without = f"; without {plural(alone, 'motion')} of which it is not known" if alone else ""
    return [
        f"in motion    logged {calibration.logged:.3f} s, before {calibration.time_before:.3f} s, "
        f"after {calibration.time_after:.3f} s; {compared} compared",
        f"error left   {calibration.remaining * 100.0:.2f} % of the time of a motion (RMS), "
        f"largest {_percent(worst.remaining)} % ({_name(worst)} pass {worst.visit}), "
        f"in all {_percent(calibration.in_all)} %",
        _trace_line(calibration.trace_time),
        f"joints       {calibration.error * factor:.2g} {unit} from the trace at equal times (RMS){without}",
    ]


def _trace_line(time: TraceTime) -> str:
    """Return the division of the time of the trace, with the share that is not compared."""
    parts = (
        ("motions compared", time.compared),
        ("at rest", time.at_rest),
        ("not compared", time.not_compared),
    )
    shares = ", ".join(f"{100.0 * part / time.whole:.1f} % {name}" for name, part in parts)
    return f"trace        {time.whole:.3f} s: {shares}"


def _limits(calibration: Calibration, axes: Sequence[JointType], style: Style) -> list[str]:
    known, n = calibration.known, len(axes)
    rows = []
    for k, (name, kind) in enumerate(zip(calibration.axes, axes, strict=True)):
        factor, unit = _TURN if kind is JointType.REVOLUTE else _SLIDE
        numbers = [order * n + k for order in range(3)]
        rows.append(_limit_row(calibration, f"joint {name} {unit}", numbers, factor))
    for part, (name, (factor, unit)) in enumerate(_OF_TOOL):
        numbers = [3 * n + 2 * order + part for order in range(3)]
        if any(known.kinds[number] is not Knowledge.NOT_SEEN for number in numbers):
            rows.append(_limit_row(calibration, f"{name} {unit}", numbers, factor))
    title = ("limit", *(f"{word}\n{power}" for word, power in zip(_WORDS, _POWERS, strict=True)))
    look = {
        Knowledge.FITTED: f"{calibration.after.look_ahead.moves}",
        Knowledge.AT_LEAST: f"{calibration.after.look_ahead.moves} (the trace would be the same with more)",
        Knowledge.NOT_SEEN: f"{calibration.after.look_ahead.moves} (the trace does not tell)",
    }[calibration.look_ahead]
    return [*columns_text(title, rows, style), f"look-ahead   {look}", *_not_told(calibration)]


def _not_told(calibration: Calibration) -> list[str]:
    """Return the limits that act in the trace and have no certain value, and what would tell them."""
    known, n = calibration.known, len(calibration.axes)
    names = [f"{word} of joint {name}" for word in _WORDS for name in calibration.axes]
    names += [f"{word} of the {name}" for word in _WORDS for name in ("path", "orientation")]
    open_ones = [
        number
        for number, kind in enumerate(known.kinds)
        if kind is Knowledge.UNCERTAIN and _DEVIATIONS * known.spreads[number] > _WORTH_SAYING
    ]
    if not open_ones:
        return []
    advice = [
        text
        for is_asked, text in (
            (any(one < 3 * n for one in open_ones), "long and short moves of these joints"),
            (any(one >= 3 * n and (one - 3 * n) % 2 == 0 for one in open_ones), "lines of all lengths"),
            (
                any(one >= 3 * n and (one - 3 * n) % 2 == 1 for one in open_ones),
                "lines on which the tool turns",
            ),
        )
        if is_asked
    ]
    said = ", ".join(names[number] for number in open_ones)
    text = f"not told     {said}: log {' and '.join(advice)} to know them; other programs may need them"
    return wrap(text, _COLUMNS, subsequent_indent=" " * 13)


_WORDS = ("speed", "acceleration", "jerk")


def _limit_row(
    calibration: Calibration, name: str, numbers: Sequence[int], factor: float
) -> tuple[TableCell, ...]:
    before, after, known = calibration.before.all, calibration.after.all, calibration.known
    cells = [TableCell(name)]
    for number in numbers:
        old, new, value = (float(one[number]) * factor for one in (before, after, known.values))
        match known.kinds[number]:
            case Knowledge.FITTED:
                cells.append(TableCell(f"{_figure(old)} → {_figure(new)}"))
            case Knowledge.UNCERTAIN:
                share = _about(float(known.spreads[number]))
                cells.append(TableCell(f"{_figure(old)} → ~{_figure(new)}{share}", Tone.WARNING))
            case Knowledge.AT_LEAST:
                changed = f"{_figure(old)} → {_figure(new)}" if new > old * 1.001 else _figure(old)
                cells.append(TableCell(f"{changed} (≥ {_figure(value)})"))
            case Knowledge.NOT_SEEN:
                cells.append(TableCell("not seen", Tone.QUIET))
    return tuple(cells)


def _about(spread: float) -> str:
    """Return two standard deviations in per cent; nothing where a limit may have any value."""
    return f" ±{max(round(100.0 * _DEVIATIONS * spread), 1)} %" if _DEVIATIONS * spread < _OPEN else ""


def _figure(value: float) -> str:
    """Return a limit with three figures: it is not known better."""
    rounded = float(f"{value:.3g}")
    return f"{rounded:.0f}" if rounded >= 100.0 else f"{rounded:g}"


def _percent(share: float) -> str:
    """Return a share with its sign in per cent."""
    return f"{round(share * 100.0, 1) + 0.0:+.1f}"
