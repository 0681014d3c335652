"""Gains from bandwidths, and the margins of their loops over the places of an arm, as text and document."""

import math
import textwrap
from collections.abc import Iterator

import numpy as np

from ropsim.cli.terminal.response_text import margins_entry, number, plain
from ropsim.core import plural
from ropsim.model import LAW_WORDS, ROBOT, ControllerModel, JointType, RobotModel, gain_names
from ropsim.simulation import PlaceCheck, PlaceGrid, margin_utilisation, worst_of
from ropsim.spatial import Array, record
from ropsim.views import Style, TableCell, Tone, columns_text

_KEYS = ("kp", "kd", "kv", "ki", "corner", "lead", "swing")
"""Gains that follow from bandwidths; the others stay as in the standard controller."""
_LARGE = 1e3
_COLUMNS = 80


@record
class Tuned:
    """A tuned controller and the check of its loops.

    Attributes:
        station: its name.
        robot: the arm.
        controller: with the gains.
        bandwidths: of the axes [Hz], shape (n,); NaN for a law whose gains do not follow from bandwidths.
        damping: of the axes; NaN for a law whose gains do not follow from one.
        grid: the places.
        loads: in words.
        checks: at all places with all loads, at rest and in slow motion.
    """

    station: str
    robot: RobotModel
    controller: ControllerModel
    bandwidths: Array
    damping: float
    grid: PlaceGrid
    loads: tuple[str, ...]
    checks: tuple[PlaceCheck, ...]


def tuning_text(tuned: Tuned, style: Style) -> str:
    """Return margins at the worst places, a map of the slowest oscillation, and the lines of the gains."""
    robot, law = tuned.robot, LAW_WORDS[tuned.controller.kind]
    hz, has_rule = tuned.controller.rates.control_hz, _has_rule(tuned)
    damping = "gains of its rule, by bandwidth" if has_rule else "present gains"
    if math.isfinite(tuned.damping) and has_rule:
        damping = f"gains by the rule for a damping of {tuned.damping:.3g}"
    title = f"{robot.title or robot.name}: {law} at {hz} Hz, {damping}"
    sections = [
        [
            title,
            *_wrapped(_grid_words(tuned)),
            *_left_out(tuned),
        ],
        [*_margins(tuned, style), *_beyond(tuned)],
        _slowest(tuned, style),
        ["to be put into cell.toml:"] if has_rule else [],
        toml_lines(tuned) if has_rule else [],
    ]
    return "\n\n".join("\n".join(lines) for lines in sections if lines) + "\n"


def _has_rule(tuned: Tuned) -> bool:
    """Return whether the gains follow from bandwidths."""
    return math.isfinite(tuned.bandwidths[0])


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, _COLUMNS, subsequent_indent="  ")


def toml_lines(tuned: Tuned) -> list[str]:
    """Return the section of `cell.toml` with these gains."""
    section = "controller" if tuned.station == ROBOT else f"stations.{tuned.station}.controller"
    names = [name for name in _KEYS if name in gain_names(tuned.controller.gains)]
    rows = [(name, getattr(tuned.controller.gains, name).tolist()) for name in names]
    return [
        f"[{section}]",
        f'law = "{LAW_WORDS[tuned.controller.kind]}"',
        *(f"{name} = [{', '.join(map(repr, values))}]" for name, values in rows),
    ]


def tuning_document(tuned: Tuned) -> dict[str, object]:
    """Return all of it in SI units; NaN and infinities are null."""
    names, gains = _names(tuned), tuned.controller.gains
    return {
        "robot": tuned.robot.name,
        "station": tuned.station,
        "law": tuned.controller.kind.value,
        "control_hz": tuned.controller.rates.control_hz,
        "damping": plain(tuned.damping) if _has_rule(tuned) else None,
        "loads": list(tuned.loads),
        "counts": list(tuned.grid.counts),
        "gains": {name: getattr(gains, name).tolist() for name in gain_names(gains)},
        "toml": "\n".join(toml_lines(tuned)) + "\n" if _has_rule(tuned) else None,
        "axes": [_axis_entry(tuned, axis, name) for axis, name in enumerate(names)],
        "places": [_place_entry(tuned, one) for one in tuned.checks],
    }


def _axis_entry(tuned: Tuned, axis: int, name: str) -> dict[str, object]:
    worst = worst_of(tuned.checks, axis)
    return {
        "axis": name,
        "bandwidth_hz": plain(float(tuned.bandwidths[axis])),
        "worst": _worst_entry(tuned, axis, worst),
        "at_rest": _worst_entry(tuned, axis, _worst(tuned, axis)[0]),
    }


def _worst_entry(tuned: Tuned, axis: int, worst: PlaceCheck) -> dict[str, object]:
    return {
        "q": tuned.grid.Q[worst.place].tolist(),
        "load": tuned.loads[worst.load],
        "motion": worst.motion.words,
        **margins_entry(worst.margins[axis]),
    }


def _worst(tuned: Tuned, axis: int) -> tuple[PlaceCheck, ...]:
    """Return the worst check of an axis at rest, and in slow motion if there is any."""
    groups = ([one for one in tuned.checks if one.motion.is_rest is still] for still in (True, False))
    return tuple(worst_of(group, axis) for group in groups if group)


def _place_entry(tuned: Tuned, one: PlaceCheck) -> dict[str, object]:
    return {
        "q": tuned.grid.Q[one.place].tolist(),
        "load": tuned.loads[one.load],
        "motion": one.motion.words,
        "slowest_hz": plain(one.slowest_hz),
        "damping": plain(one.damping),
        "gain": [plain(axis.gain) for axis in one.margins],
        "sensitivity": [plain(axis.sensitivity) for axis in one.margins],
    }


def _grid_words(tuned: Tuned) -> str:
    names, loads = _names(tuned), " and ".join(tuned.loads)
    pairs = zip(names, tuned.grid.counts, strict=True)
    spread = [f"joint {name}: {count}" for name, count in pairs if count > 1]
    if not spread:
        return f"one place, with {loads}"
    others = "; the others in the middle" if len(spread) < len(names) else ""
    return f"{len(tuned.grid.Q)} places over the ranges ({', '.join(spread)}{others}), with {loads}"


def _left_out(tuned: Tuned) -> list[str]:
    count = len(tuned.grid.Q) * len(tuned.loads) - len(_rests(tuned))
    return [f"left out: {plural(count, 'place')} at which the drives do not hold the load"] if count else []


def _margins(tuned: Tuned, style: Style) -> list[str]:
    header = ("axis", "bandwidth\nHz", "gain\nmargin", "phase\nmargin °", "Ms", "worst", "with", "at")
    rows = []
    for axis, joint in enumerate(tuned.robot.axis_joints):
        first = TableCell(joint.name), TableCell(number(float(tuned.bandwidths[axis]), "-"))
        for worst in _worst(tuned, axis):
            rows.append((*first, *_worst_row(tuned, worst, axis)))
            first = TableCell(""), TableCell("")
    return columns_text(header, rows, style)


def _worst_row(tuned: Tuned, worst: PlaceCheck, axis: int) -> Iterator[TableCell]:
    """Yield the margins of an axis, and where it has them."""
    margins = worst.margins[axis]
    if margins.stable:
        tone = Tone.WARNING if margin_utilisation(margins) > 1.0 else None
        yield TableCell(f"{margins.gain:.3g}" if margins.gain < _LARGE else "large", tone)
        yield TableCell(f"{math.degrees(margins.phase):.0f}" if math.isfinite(margins.phase) else "-")
        yield TableCell(f"{margins.sensitivity:.2f}", tone)
    else:
        yield TableCell("unstable", Tone.ERROR)
        yield TableCell("-")
        yield TableCell("-")
    yield TableCell(worst.motion.words)
    yield TableCell(tuned.loads[worst.load])
    yield TableCell(_place_words(tuned, worst.place))


def _beyond(tuned: Tuned) -> list[str]:
    """Return which axes have less margin than a loop should have."""
    names = [
        joint.name
        for axis, joint in enumerate(tuned.robot.axis_joints)
        if margin_utilisation(worst_of(tuned.checks, axis).margins[axis]) > 1.0
    ]
    if not names:
        return []
    joints = ", ".join(f"joint {one}" for one in names)
    return [f"not within Ms 2 and a gain margin of 2 at the worst place: {joints}"]


def _slowest(tuned: Tuned, style: Style) -> list[str]:
    """Return the least and the greatest frequency of the slowest oscillation, and a table over two axes."""
    known = [one for one in _rests(tuned) if math.isfinite(one.slowest_hz)]
    if not known:
        return ["no loop oscillates at any place"]
    ends = [pick(known, key=lambda one: one.slowest_hz) for pick in (min, max)]
    lines = [
        f"slowest oscillation, {word}: {number(one.slowest_hz, '-')} Hz (damping {one.damping:.2g}), "
        f"{tuned.loads[one.load]}, {_place_words(tuned, one.place)}"
        for word, one in zip(("least", "most"), ends, strict=True)
    ]
    if math.isfinite(tuned.damping) and _has_rule(tuned):
        lines.append("its damping is that of arm, drives, sensors and law together, not the one of the rule")
    return [*lines, *_map(tuned, style)]


def _map(tuned: Tuned, style: Style) -> list[str]:
    """Return the slowest oscillation over the two axes with the most places, the least of all others."""
    counts = tuned.grid.counts
    spread = sorted((k for k in range(len(counts)) if counts[k] > 1), key=lambda k: -counts[k])[:2]
    if not spread:
        return []
    down = spread[0]
    across = spread[1] if len(spread) > 1 else None
    table: dict[tuple[float, float], float] = {}
    for one in _rests(tuned):
        q = tuned.grid.Q[one.place]
        key = float(q[down]), 0.0 if across is None else float(q[across])
        table[key] = float(np.fmin(table.get(key, math.nan), one.slowest_hz))
    rows = sorted({key[0] for key in table})
    columns = sorted({key[1] for key in table})
    names = _names(tuned)
    beside = "" if across is None else f" (down) and joint {names[across]} (across)"
    what = f"over joint {names[down]}{beside}"
    heads = ("Hz",) if across is None else tuple(_coordinate(tuned, across, one) for one in columns)
    lines = columns_text(
        (f"joint {names[down]}", *heads),
        [
            (
                TableCell(_coordinate(tuned, down, row)),
                *(TableCell(number(table[row, column], "-")) for column in columns),
            )
            for row in rows
        ],
        style,
    )
    return ["", f"slowest oscillation in Hz {what}, the least of all loads", *lines]


def _rests(tuned: Tuned) -> list[PlaceCheck]:
    return [one for one in tuned.checks if one.motion.is_rest]


def _place_words(tuned: Tuned, place: int) -> str:
    """Return the coordinates of the axes that have several places."""
    spread = [k for k, count in enumerate(tuned.grid.counts) if count > 1]
    names, q = _names(tuned), tuned.grid.Q[place]
    return ", ".join(f"{names[k]}: {_coordinate(tuned, k, q[k])}" for k in spread) or "-"


def _names(tuned: Tuned) -> list[str]:
    return [joint.name for joint in tuned.robot.axis_joints]


def _coordinate(tuned: Tuned, axis: int, value: float) -> str:
    if tuned.robot.axis_joints[axis].measure is JointType.REVOLUTE:
        return f"{math.degrees(value):.0f}°"
    return f"{1e3 * value:.0f} mm"
