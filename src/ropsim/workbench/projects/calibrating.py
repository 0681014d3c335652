"""Calibrating a project: its program is planned, compared with a trace, and its cell file gets the limits."""

from collections.abc import Callable, Mapping
from pathlib import Path

from ropsim.calibration import (
    LARGEST,
    Calibration,
    CalibrationError,
    MotionSettings,
    calibrate,
    read_trace,
    settings_of,
)
from ropsim.cellfile import Limits, limits_section, read_cell, with_limits, written_limits
from ropsim.core import Diagnostic, SourceText, read_bytes
from ropsim.flow import Fidelity
from ropsim.icr import Program
from ropsim.model import Cell, ReadRobot, RobotSource, Station
from ropsim.planning import MotionSequence
from ropsim.simulation import RunOptions, run
from ropsim.userfiles import UNREADABLE, missing_file
from ropsim.workbench.projects.calibrated_project import CalibratedProject

_CHANGED = 1e-3
"""Share by which a limit must differ to be written."""
_TABLES = (
    ("joint_speed", "joint_acceleration", "joint_jerk"),
    ("path_speed", "path_acceleration", "path_jerk"),
    ("orientation_speed", "orientation_acceleration", "orientation_jerk"),
)


def calibrate_project(
    cell: Cell,
    codes: Mapping[str, Program],
    station: Station,
    cell_text: SourceText,
    robots: Mapping[RobotSource, ReadRobot],
    trace: str | Path,
    planning: Callable[[], None],
) -> tuple[CalibratedProject | None, tuple[Diagnostic, ...]]:
    """Return the limits under which programs last as long as in a trace, and the findings.

    Args:
        cell: of the project.
        codes: verified programs by station.
        station: whose trace it is.
        cell_text: the cell file.
        robots: robots read from the files that it names.
        trace: a table of times and joint coordinates: see `read_trace`.
        planning: called before each sequence that is planned again.

    Returns:
        The calibration, None where there is none; and the findings.

    Raises:
        CalibrationError: X840 or X841, the trace cannot be opened.
    """
    content = _opened(Path(trace), str(trace))
    found, findings = read_trace(content, station.robot.axis_joints, str(trace))
    if found is None:
        return None, findings
    orders: list[MotionSequence] = []

    def ordered(name: str, order: MotionSequence) -> None:
        if name == station.name:
            orders.append(order)

    recording = run(cell, codes, RunOptions(Fidelity.KINEMATIC, ordered=ordered))
    findings += tuple(one for one in recording.findings if one.is_error)
    calibration, more = calibrate(cell, station, orders, found, planning)
    findings += more
    return (_with_cell(calibration, cell_text, robots, station) if calibration else None), findings


def changed_limits(before: MotionSettings, after: MotionSettings) -> Limits:
    """Return the limits that differ, by the keys of `[controller]` [SI]."""
    found: dict[str, float | list[float]] = {}
    for order in range(3):
        old, new = before.joints[order], after.joints[order]
        if bool((abs(new / old - 1.0) > _CHANGED).any()):
            found[_TABLES[0][order]] = new.tolist()
        for part in range(2):
            value = float(after.tool[order, part])
            if abs(value / float(before.tool[order, part]) - 1.0) > _CHANGED:
                found[_TABLES[1 + part][order]] = value
    if after.look_ahead != before.look_ahead:
        found["look_ahead"] = after.look_ahead.moves
    return found


def _with_cell(
    calibration: Calibration, text: SourceText, robots: Mapping[RobotSource, ReadRobot], station: Station
) -> CalibratedProject:
    limits = changed_limits(calibration.before, calibration.after)
    axes = tuple(joint.measure for joint in station.robot.axis_joints)
    values = written_limits(text, axes, limits)
    section = ".".join(limits_section(text, station.name))
    made = with_limits(text, station.name, values) if values else None
    if made is not None:
        cell, _ = read_cell(made, "cell", robots)
        if cell is None or _differs(cell.stations[station.name], calibration.after):
            made = None
    return CalibratedProject(calibration, section, values, axes, made)


def _differs(station: Station, wanted: MotionSettings) -> bool:
    return bool(changed_limits(settings_of(station), wanted))


def _opened(path: Path, name: str) -> bytes:
    """Return the content of a trace.

    Raises:
        CalibrationError: X840 or X841, it is not there or cannot be opened.
    """
    try:
        return read_bytes(path, LARGEST)
    except FileNotFoundError:
        raise CalibrationError(missing_file(path, name)) from None
    except OSError as error:
        message = f"`{name}` cannot be opened: {error.strerror or error}"
        raise CalibrationError(
            UNREADABLE.at(None, message, hint="give a table of times and joints")
        ) from error
