"""Responses and margins of loops as text for a terminal, and as a document."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import fields
from typing import TypeAlias

from ropsim.model import LAW_WORDS, ControllerModel, JointType, Linkage, RobotModel
from ropsim.simulation import (
    FrequencyResponse,
    LinearLoop,
    Margins,
    OilSpring,
    SlowMotion,
    TimeResponse,
    lag_of,
    margin_utilisation,
    margins_of_all,
    step_figures,
)
from ropsim.spatial import Array, record
from ropsim.views import Style, TableCell, Tone, columns_text

_UNITS = {JointType.REVOLUTE: (math.degrees(1.0), "°"), JointType.PRISMATIC: (1e3, " mm")}
Table: TypeAlias = tuple[tuple[str, ...], list[tuple[TableCell, ...]]]
"""Titles and rows."""
_SLOWEST = 3
"""Modes that are shown."""
_LARGE = 1e3
"""Factors from here on count as infinite, and numbers have no exponent."""


@record
class Rest:
    """Where loops are tested, and how they swing there.

    Attributes:
        robot: the arm.
        controller: its controller.
        q: coordinates at rest [rad | m], shape (n,).
        place: that in words.
        load: mass of the tool [kg].
        modes: frequencies [Hz] and damping ratios of the closed loop, the slowest first.
        swings: of arm and drives without the law, likewise.
        oil: levers, masses and oil of hydraulic axes there.
        is_ramp: whether references go at a speed; else they step.
    """

    robot: RobotModel
    controller: ControllerModel
    q: Array
    place: str
    load: float
    modes: tuple[Array, Array]
    swings: tuple[Array, Array]
    oil: tuple[OilSpring, ...]
    is_ramp: bool


@record
class MovingAxis:
    """The slow motion in which the loop of an axis has the least margins.

    Attributes:
        motion: that motion; of an arm whose drives make none the rest.
        margins: of the axis in it.
    """

    motion: SlowMotion
    margins: Margins


@record
class TestedAxis:
    """An axis and the behaviour of its loop.

    Attributes:
        axis: its number, from 0.
        response: in time; None where the state diverged.
        margins: of its loop.
        bandwidth: of its loop [Hz]; NaN for none.
        sweep: response to the requested sines; None for none.
        sines: response to sines of many frequencies.
        slow: the slow motion in which its margins are the worst.
    """

    axis: int
    response: TimeResponse | None
    margins: Margins
    bandwidth: float
    sweep: FrequencyResponse | None
    sines: FrequencyResponse
    slow: MovingAxis


def response_text(rest: Rest, tested: Sequence[TestedAxis], style: Style) -> str:
    """Return tables of responses and margins; ends in a line feed.

    Args:
        rest: where the loops are tested.
        tested: at least one axis.
        style: whether it has colours.
    """
    lines = [f"{rest.robot.title or rest.robot.name}: {conditions(rest)}", ""]
    if any(one.response for one in tested):
        lines += [*columns_text(*in_time(rest, tested), style), ""]
    lines += [*columns_text(*margins_table(rest, tested), style), ""]
    lines += [*columns_text(*slow_table(rest, tested), style), ""]
    if tested[0].sweep is not None:
        lines += [*_sweeps(rest, tested, style), ""]
    if rest.oil:
        lines += [*columns_text(*oil_table(rest), style), ""]
    return "\n".join([*lines, *notes(rest)]) + "\n"


def conditions(rest: Rest) -> str:
    """Return law, rate, place and load in words."""
    law, hz = LAW_WORDS[rest.controller.kind], rest.controller.rates.control_hz
    load = f"{rest.load:.3g} kg at the flange" if rest.load else "no load"
    return f"{law} at {hz} Hz, {rest.place}, {load}"


def notes(rest: Rest) -> tuple[str, ...]:
    """Return the slowest modes, the sensors, and the effects that margins and modes leave out."""
    found, shown = list[str](), _modes(rest.modes)
    found.append(f"slowest modes: {shown}" if shown else "no mode of the loops oscillates")
    if rest.oil:
        found.append(f"without the law: {_modes(rest.swings)}")
    left_out = "dry friction, play, and limits of amplifiers"
    sensors = rest.controller.sensors.sensors
    if sensors:
        left_out += "; of sensors with delays and rates, without steps and noise"
        names = ", ".join(one.quantity for one in sensors)
        found.append(f"responses: with the sensors of the cell for {names}, their steps and noise")
    return (*found, f"margins and modes: about the rest and slow motions, without {left_out}")


def _modes(modes: tuple[Array, Array]) -> str:
    """Return the slowest modes in words; empty for none."""
    pairs = zip(*(one[:_SLOWEST].tolist() for one in modes), strict=True)
    return ", ".join(f"{hz:.3g} Hz (damping {ratio:.2g})" for hz, ratio in pairs)


def oil_table(rest: Rest) -> Table:
    """Return what hydraulic axes stand on."""
    header = (
        *("axis", "lever\nmm", "mass at\nrod kg", "oil spring\nMN/m", "alone\nHz"),
        *("full valve\nforward", "full valve\nback"),
    )
    rows = []
    for one in rest.oil:
        scale, unit = _unit(rest, one.axis)
        turns = rest.robot.axis_joints[one.axis].measure is JointType.REVOLUTE
        by_rod = turns and isinstance(rest.robot.drives[one.axis].transmission, Linkage)
        texts = (
            f"{1e3 * one.lever:.0f}" if by_rod else "-",
            f"{one.mass:.3g}" if by_rod else "-",
            f"{1e-6 * one.stiffness:.3g}" if by_rod else "-",
            f"{one.hz:.1f}",
            *(f"{speed * scale:.0f}{unit}/s" for speed in (one.forward, one.back)),
        )
        rows.append((TableCell(_name(rest, one.axis)), *map(TableCell, texts)))
    return header, rows


def in_time(rest: Rest, tested: Sequence[TestedAxis]) -> Table:
    """Return the figures of answers in time."""
    beside = ("others off\nby", "drive at\nlimit %")
    header: tuple[str, ...] = ("axis", "step", "rise\nms", "overshoot\n%", "settling\nms", "left", *beside)
    if rest.is_ramp:
        header = ("axis", "ramp", "behind at\nthe end", "behind\nat most", *beside)
    row = _ramp_row if rest.is_ramp else _step_row
    return header, [tuple(row(rest, one.axis, one.response)) for one in tested if one.response is not None]


def _ramp_row(rest: Rest, axis: int, response: TimeResponse) -> Iterator[TableCell]:
    scale, unit = _unit(rest, axis)
    speed = float(response.reference[-1] / response.time[-1])
    yield TableCell(_name(rest, axis))
    yield TableCell(f"{speed * scale:.3g}{unit}/s")
    yield from (TableCell(f"{behind * scale:.3g}{unit}") for behind in lag_of(response))
    yield from _beside(rest, response)


def _step_row(rest: Rest, axis: int, response: TimeResponse) -> Iterator[TableCell]:
    scale, unit = _unit(rest, axis)
    figures = step_figures(response)
    yield TableCell(_name(rest, axis))
    yield TableCell(f"{float(response.reference[-1]) * scale:.3g}{unit}")
    yield TableCell(number(1e3 * figures.rise, "never"))
    yield TableCell(f"{100.0 * figures.overshoot:.1f}")
    yield TableCell(number(1e3 * figures.settling, f"over {1e3 * float(response.time[-1]):.0f}"))
    yield TableCell(f"{figures.error * scale:.2g}{unit}")
    yield from _beside(rest, response)


def _beside(rest: Rest, response: TimeResponse) -> Iterator[TableCell]:
    """Yield how far other axes go, and how long the amplifier is at its limit."""
    most = dict.fromkeys((joint.measure for joint in rest.robot.axis_joints), 0.0)
    for joint, value in zip(rest.robot.axis_joints, response.others.tolist(), strict=True):
        most[joint.measure] = max(most[joint.measure], value)
    texts = (f"{value * _UNITS[kind][0]:.2g}{_UNITS[kind][1]}" for kind, value in most.items())
    yield TableCell(", ".join(texts))
    full = 100.0 * response.at_limit
    yield TableCell(f"{full:.3g}", Tone.WARNING if full else None)


def margins_table(rest: Rest, tested: Sequence[TestedAxis]) -> Table:
    """Return bandwidths and margins."""
    header = (
        *("axis", "bandwidth\nHz", "gain\nmargin", "at\nHz", "phase\nmargin °", "at\nHz"),
        *("delay\nmargin ms", "Ms"),
    )
    rows = list[tuple[TableCell, ...]]()
    for one in tested:
        name, margin = TableCell(_name(rest, one.axis)), one.margins
        if not margin.stable:
            rows.append((name, TableCell("unstable", Tone.ERROR), *(TableCell("-"),) * 6))
            continue
        rows.append((name, TableCell(number(one.bandwidth, "-")), *_margin_cells(margin)))
    return header, rows


def slow_table(rest: Rest, tested: Sequence[TestedAxis]) -> Table:
    """Return the margins of each axis in the slow motion in which they are the worst."""
    header = (
        *("axis", "worst in\nslow motion", "gain\nmargin", "at\nHz", "phase\nmargin °", "at\nHz"),
        *("delay\nmargin ms", "Ms"),
    )
    rows = list[tuple[TableCell, ...]]()
    for one in tested:
        name, going, margin = TableCell(_name(rest, one.axis)), one.slow.motion.words, one.slow.margins
        if not margin.stable:
            unstable = TableCell(f"{going}: unstable", Tone.ERROR)
            rows.append((name, unstable, *(TableCell("-"),) * 6))
            continue
        rows.append((name, TableCell(going), *_margin_cells(margin)))
    return header, rows


def worst_moving(motions: Sequence[SlowMotion], loops: Sequence[LinearLoop]) -> tuple[MovingAxis, ...]:
    """Return the worst motion of each axis.

    Args:
        motions: at least one.
        loops: about them.
    """
    found = [margins_of_all(loop) for loop in loops]
    rows = [tuple(map(MovingAxis, motions, axis)) for axis in zip(*found, strict=True)]
    return tuple(max(row, key=lambda one: margin_utilisation(one.margins)) for row in rows)


def _margin_cells(margin: Margins) -> Iterator[TableCell]:
    yield TableCell(f"{margin.gain:.3g}" if margin.gain < _LARGE else "large")
    yield TableCell(number(margin.gain_hz, "-"))
    yield TableCell(f"{math.degrees(margin.phase):.0f}" if math.isfinite(margin.phase) else "-")
    yield TableCell(number(margin.phase_hz, "-"))
    yield TableCell(number(1e3 * margin.delay, "-"))
    yield TableCell(f"{margin.sensitivity:.2f}")


def _sweeps(rest: Rest, tested: Sequence[TestedAxis], style: Style) -> list[str]:
    """Return gains and phases over frequencies, an axis in two columns."""
    names, sweeps = [_name(rest, one.axis) for one in tested], [one.sweep for one in tested if one.sweep]
    header = ("Hz", *(f"{name}\n{what}" for name in names for what in ("dB", "°")))
    rows = []
    for k, hz in enumerate(sweeps[0].hz.tolist()):
        pairs = [(one.gain[k], one.phase[k]) for one in sweeps]
        texts = [
            text
            for gain, phase in pairs
            for text in (f"{20.0 * math.log10(gain):.1f}", f"{math.degrees(phase):.0f}")
        ]
        rows.append((TableCell(f"{hz:.3g}"), *map(TableCell, texts)))
    return columns_text(header, rows, style)


def response_document(rest: Rest, tested: Sequence[TestedAxis]) -> dict[str, object]:
    """Return all of it in SI units, with the samples; NaN and infinities are null."""
    frequencies, ratios = rest.modes
    return {
        "robot": rest.robot.name,
        "law": rest.controller.kind.value,
        "control_hz": rest.controller.rates.control_hz,
        "q": rest.q.tolist(),
        "load": rest.load,
        "sensors": [one.quantity for one in rest.controller.sensors.sensors],
        "modes": {"hz": frequencies.tolist(), "damping": ratios.tolist()},
        "modes_without_law": {"hz": rest.swings[0].tolist(), "damping": rest.swings[1].tolist()},
        "oil": [
            {"axis": _name(rest, one.axis)}
            | {one_.name: getattr(one, one_.name) for one_ in fields(one) if one_.name != "axis"}
            for one in rest.oil
        ],
        "axes": [_axis_entry(rest, one) for one in tested],
    }


def _axis_entry(rest: Rest, one: TestedAxis) -> dict[str, object]:
    return {
        "axis": _name(rest, one.axis),
        **margins_entry(one.margins),
        "bandwidth_hz": plain(one.bandwidth),
        "in_motion": {
            "motion": one.slow.motion.words,
            "qd": one.slow.motion.qd.tolist(),
            **margins_entry(one.slow.margins),
        },
        "ramp" if rest.is_ramp else "step": one.response and _response_entry(rest, one.response),
        "sweep": one.sweep
        and {
            "hz": one.sweep.hz.tolist(),
            "gain": one.sweep.gain.tolist(),
            "phase": one.sweep.phase.tolist(),
        },
    }


def margins_entry(found: Margins) -> dict[str, object]:
    """Return whether a loop is stable, and its margins; NaN and infinities are null."""
    numbers = {field.name: plain(getattr(found, field.name)) for field in fields(found)}
    stable = numbers.pop("stable")
    return {"stable": stable, "margins": numbers}


def _response_entry(rest: Rest, response: TimeResponse) -> dict[str, object]:
    if rest.is_ramp:
        behind, most = lag_of(response)
        figures: dict[str, float | None] = {"behind": behind, "behind_at_most": most}
    else:
        found = step_figures(response)
        figures = {field.name: plain(getattr(found, field.name)) for field in fields(found)}
    return {
        **figures,
        "others": response.others.tolist(),
        "at_limit": response.at_limit,
        "time": response.time.tolist(),
        "reference": response.reference.tolist(),
        "moved": response.moved.tolist(),
        "effort": response.effort.tolist(),
    }


def _unit(rest: Rest, axis: int) -> tuple[float, str]:
    return _UNITS[rest.robot.axis_joints[axis].measure]


def _name(rest: Rest, axis: int) -> str:
    return rest.robot.axis_joints[axis].name


def number(value: float, otherwise: str) -> str:
    """Return a number with three digits and without exponent; another text for NaN and infinities."""
    if not math.isfinite(value):
        return otherwise
    return f"{value:.3g}" if value < _LARGE else f"{value:.0f}"


def plain(value: float) -> float | None:
    """Return a number for a document, null for NaN and infinities."""
    return value if math.isfinite(value) else None
