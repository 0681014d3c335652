"""`ropsim calibrate`: limits and look-ahead of a controller from a logged trace."""

import argparse
import itertools
import math
from collections.abc import Sequence
from pathlib import Path

from ropsim.calibration import Calibration, Knowledge, SequenceTimes
from ropsim.cli.terminal.calibration_text import calibration_text
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.cli.terminal.progress import Progress
from ropsim.core import replace_inside
from ropsim.records import diagnostic_document
from ropsim.workbench import CalibratedProject, ProjectError, found_in, open_project

_ORDERS = ("speed", "acceleration", "jerk")


def calibrate(options: argparse.Namespace, output: Output) -> int:
    """Fit the limits of a project to a trace and return the exit code."""
    project = open_project(options.path)
    sources = project.texts
    programs = {} if project.is_broken else project.programs(options.program)
    before = (*project.diagnostics, *found_in(programs))
    if not programs or any(one.is_error for one in before):
        output.document({"ok": False, **diagnostic_document(before)})
        return output.findings(before, sources)
    output.engine_note()
    with Progress(f"calibrating {project.folder.resolve().name}") as progress:
        count = itertools.count(1)

        def planning() -> None:
            progress(math.nan, f"planning under other limits, motion {next(count)}")

        found, findings = project.calibrate(options.trace, options.program, planning)
    findings = (*before, *findings)
    code = output.findings(findings, sources)
    if found is None:
        output.document({"ok": False, **diagnostic_document(findings)})
        return code or 1
    written = _write(found) if options.write and not found.calibration.left_out else []
    output.text(calibration_text(found.calibration, found.axes, output.style))
    output.text(_ending(found, written))
    output.document(
        {
            "ok": code == 0,
            "calibration": calibration_entry(found.calibration),
            "section": found.section,
            "values": dict(found.values),
            "written": written,
            **diagnostic_document(findings),
        }
    )
    return code


def calibration_entry(calibration: Calibration) -> dict[str, object]:
    """Return a calibration as a mapping, all in SI units."""
    n = len(calibration.axes)
    named = [
        (f"joint {name}", [order * n + k for order in range(3)]) for k, name in enumerate(calibration.axes)
    ]
    named += [
        (name, [3 * n + 2 * order + part for order in range(3)])
        for part, name in enumerate(("path", "orientation"))
    ]
    return {
        "station": calibration.station,
        "time": {
            "logged": calibration.logged,
            "before": calibration.time_before,
            "after": calibration.time_after,
        },
        "trace": {
            "whole": calibration.trace_time.whole,
            "compared": calibration.trace_time.compared,
            "at_rest": calibration.trace_time.at_rest,
            "not_compared": calibration.trace_time.not_compared,
        },
        "remaining": {
            "rms": calibration.remaining,
            "worst": calibration.worst.remaining,
            "in_all": calibration.in_all,
        },
        "joint_error": calibration.error,
        "look_ahead": {
            "before": calibration.before.look_ahead.moves,
            "after": calibration.after.look_ahead.moves,
            "known": calibration.look_ahead.value,
        },
        "limits": {
            name: {
                order: _limit_entry(calibration, number)
                for order, number in zip(_ORDERS, numbers, strict=True)
            }
            for name, numbers in named
        },
        "motions": [_motion_entry(one) for one in calibration.sequences],
        "not_compared": [{**_motion_entry(one), "reason": one.reason} for one in calibration.left_out],
        "compared": len(calibration.sequences),
        "made": calibration.made,
    }


def _motion_entry(one: SequenceTimes) -> dict[str, object]:
    """Return a motion between two stops; times that are not known are null."""
    times = {"logged": one.logged, "before": one.before, "after": one.after, "joint_error": one.error}
    return {
        "source": one.last.source if one.last else "",
        "first_line": one.first.line if one.first else 0,
        "last_line": one.last.line if one.last else 0,
        "pass": one.visit,
        **{name: value if math.isfinite(value) else None for name, value in times.items()},
    }


def _limit_entry(calibration: Calibration, number: int) -> dict[str, object]:
    kind = calibration.known.kinds[number]
    entry: dict[str, object] = {
        "known": kind.value,
        "before": float(calibration.before.all[number]),
        "after": float(calibration.after.all[number]),
    }
    if kind is Knowledge.AT_LEAST:
        entry["at_least"] = float(calibration.known.values[number])
    if kind is Knowledge.UNCERTAIN:
        spread = float(calibration.known.spreads[number])
        entry["deviation"] = spread if math.isfinite(spread) else None
    return entry


def _write(found: CalibratedProject) -> list[str]:
    """Write the cell file if possible; return lines on the written data.

    Raises:
        ProjectError: X847, it cannot be written.
    """
    if found.cell_text is None:
        return []
    try:
        cell_file = Path(found.cell_text.name)
        replace_inside(cell_file.parent, cell_file.name, found.cell_text.text.encode())
    except OSError as error:
        raise ProjectError(cannot_write(found.cell_text.name, error)) from error
    return [found.cell_text.name]


def _ending(found: CalibratedProject, written: Sequence[str]) -> str:
    """Return the written changes, or the lines to be changed."""
    if not found.values:
        return "the limits of the cell are those of the trace: nothing to write"
    if written:
        return f"wrote {written[0]}"
    lines = "\n".join(f"{key} = {value}" for key, value in found.values.items())
    where = "put this into cell.toml" if found.cell_text is None else "for cell.toml, as --write writes it"
    if found.calibration.left_out:
        where = "nothing is written; the compared motions alone tell"
    return f"{where}:\n\n[{found.section}]\n{lines}"
