"""`ropsim controller response`: responses and stability margins of the loops of a cell."""

import argparse
import math
from pathlib import Path

import numpy as np

from ropsim import kinematics
from ropsim.cli.terminal.coordinates import check_coordinates, joint_coordinates
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.cli.terminal.response_report import response_records
from ropsim.cli.terminal.response_text import (
    Rest,
    TestedAxis,
    response_document,
    response_text,
    worst_moving,
)
from ropsim.core import Category, Diagnostic, RopsimError, Severity, define, did_you_mean, replace_file
from ropsim.model import Cell, JointType, Payload, RobotModel, Station
from ropsim.records import diagnostic_document
from ropsim.simulation import (
    DivergedError,
    ServoLoop,
    frequency_response,
    margins,
    mounted_load,
    natural_modes,
    oil_springs,
    plant_modes,
    ramp_response,
    rest_of,
    slow_motions,
    step_response,
)
from ropsim.spatial import Array, Pose
from ropsim.views import response_page
from ropsim.workbench import Project, environment_of, open_project

NOT_TESTED = define(
    "U905",
    "controller-not-tested",
    Severity.ERROR,
    "a station, axis or place of `ropsim controller` is not there",
    """
`--station` names a station of the cell, `--axis` an axis of its robot by number from 1 or by name, `--at` a
location of the cell that the tool of the station reaches, `--joints` has a number for each axis. Steps stay
within the range of the joint, ramps below its speed, both in the unit of the axis; sweeps end at half of the
control rate. A robot whose model has no drives follows its reference exactly: it has no
loop to test.

`ropsim controller tune` has gains for the built-in laws: one bandwidth for all axes or one for each, up to a
quarter of the control rate; computed torque and loops of fixed gains also have a damping ratio. A law of a
file is judged as it is.

A page (`--report`) replaces neither a folder nor a text of the project.
""",
    Category.USAGE,
)
SMALL = {JointType.REVOLUTE: 0.5, JointType.PRISMATIC: 0.5}
"""Step where none is stated [deg | mm]: so small that amplifiers of most arms stay below their limits."""
_FREQUENCIES = 13
"""Of a sweep that are printed."""


class NotTestedError(RopsimError):
    """There is nothing to test under this name."""


def response(options: argparse.Namespace, output: Output) -> int:
    """Print responses and margins of the axes of a station; return the exit code, 1 for an unstable loop."""
    project = open_project(options.path)
    cell = project.cell
    if cell is None:
        code = output.findings(project.diagnostics, project.texts)
        output.document({"ok": False, **diagnostic_document(project.diagnostics)})
        return code or 1
    _check_place(options.report, project)
    output.engine_note()
    station = tested_station(cell, options.station)
    robot, load = station.robot, _load(station)
    q, place = _rest(cell, station, options)
    axes = range(robot.n) if options.axis is None else (_axis(robot, options.axis),)
    motions = slow_motions(robot, q, load) or (rest_of(robot),)
    loop, *moving = ServoLoop.of(robot, station.controller).about(q, load, (rest_of(robot), *motions))
    hz = None
    if options.sweep:
        half = 0.5 * station.controller.rates.control_hz
        if options.sweep[1] > half:
            raise not_tested(f"sines go up to half of the control rate, {half:g} Hz", "lower the sweep")
        hz = np.geomspace(float(options.sweep[0]), float(options.sweep[1]), _FREQUENCIES)
    tested, findings, slow = list[TestedAxis](), list[Diagnostic](), worst_moving(motions, moving)
    for axis in axes:
        change = _change(robot, q, axis, options)
        answer = None
        try:
            excited = ramp_response if options.ramp else step_response
            answer = excited(robot, station.controller, q, load, (axis, change))
        except DivergedError as error:
            findings.append(error.diagnostic)
        sines = frequency_response(loop, axis)
        swept = frequency_response(loop, axis, hz) if hz is not None else None
        tested.append(
            TestedAxis(axis, answer, margins(loop, axis), sines.bandwidth, swept, sines, slow[axis])
        )
    code = output.findings(findings, project.texts)
    rest = Rest(
        robot,
        station.controller,
        q,
        place,
        load.mass,
        natural_modes(loop),
        plant_modes(loop),
        oil_springs(robot, q, load),
        is_ramp=bool(options.ramp),
    )
    output.text(response_text(rest, tested, output.style))
    written = _written(options.report, rest, tested)
    for path in written:
        output.text(f"wrote {path}")
    ok = code == 0 and all(one.margins.stable and one.slow.margins.stable for one in tested)
    output.document(
        {"ok": ok, **response_document(rest, tested), "written": written, **diagnostic_document(findings)}
    )
    return 0 if ok else 1


def _check_place(path: str | None, project: Project) -> None:
    """Require that a page replaces neither a folder nor a text of the project."""
    if path and Path(path).is_dir():
        raise not_tested(f"`{path}` is a folder, needed is the name of a file", "such as `loops.html`")
    if path and Path(path).resolve() in {Path(name).resolve() for name in project.texts}:
        raise not_tested(f"`{path}` is a text of the project", "choose another place for the page")


def _written(path: str | None, rest: Rest, tested: list[TestedAxis]) -> list[str]:
    """Write the HTML page where a path is given, and return that path."""
    if not path:
        return []
    page = response_page(response_records(rest, tested))
    try:
        replace_file(Path(path), page.encode("utf-8"))
    except OSError as error:
        raise NotTestedError(cannot_write(path, error)) from error
    return [path]


def _change(robot: RobotModel, q: Array, axis: int, options: argparse.Namespace) -> float:
    """Return the step or the speed of the reference of an axis, in SI units."""
    joint = robot.axis_joints[axis]
    turns = joint.measure is JointType.REVOLUTE
    value, unit = options.ramp or options.step or (SMALL[joint.measure], "")
    if options.ramp is None and options.step is None and q[axis] > 0.5 * (joint.lower + joint.upper):
        value = -value  # away from the nearer limit
    if unit and unit != ("deg" if turns else "mm"):
        moves = "turns, its unit is deg" if turns else "slides, its unit is mm"
        raise not_tested(f"`{unit}` for joint `{joint.name}`, which {moves}", "give the unit of this axis")
    change = math.radians(value) if turns else 1e-3 * value
    if options.ramp is not None and abs(change) > joint.max_speed:
        raise not_tested(f"joint `{joint.name}` is not as quick as this ramp", "give a slower ramp")
    if options.ramp is None and not joint.lower <= q[axis] + change <= joint.upper:
        raise not_tested(f"this step takes joint `{joint.name}` beyond its range", "give a smaller step")
    return change


def _load(station: Station) -> Payload:
    return mounted_load(station.tools.get(station.default_tool))


def tested_station(cell: Cell, name: str | None) -> Station:
    """Return the station of a name, the first one for None; it has drives.

    Raises:
        NotTestedError: U905, there is none, or it has no drives.
    """
    if name is not None and name not in cell.stations:
        raise not_tested(f"the cell has no station `{name}`", did_you_mean(name, cell.stations))
    station = cell.stations[name] if name is not None else cell.first
    if not station.robot.drives:
        message = f"`{station.robot.name}` has no drives: it follows its reference exactly, there is no loop"
        raise not_tested(message, "`ropsim robot estimate` adds drives by stated rules")
    return station


def _axis(robot: RobotModel, name: str) -> int:
    """Return the number of an axis, from 0, by its number from 1 or its name."""
    names = [joint.name for joint in robot.axis_joints]
    if name in names:
        return names.index(name)
    if name.isdecimal() and 1 <= int(name) <= robot.n:
        return int(name) - 1
    hint = did_you_mean(name, names) or f"there are 1 to {robot.n}: {', '.join(f'`{one}`' for one in names)}"
    raise not_tested(f"`{robot.name}` has no axis `{name}`", hint)


def _rest(cell: Cell, station: Station, options: argparse.Namespace) -> tuple[Array, str]:
    """Return where the arm rests [rad | m], and that in words."""
    robot = station.robot
    if options.joints:
        if len(options.joints) != robot.n:
            raise not_tested(f"--joints has {len(options.joints)} numbers, the robot has {robot.n} axes", "")
        given = joint_coordinates(robot, options.joints)
        check_coordinates(given)
        units = [math.radians(1.0) if one.kind is JointType.REVOLUTE else 1e-3 for one in given]
        q = np.array([one.value * unit for one, unit in zip(given, units, strict=True)])
        beyond = np.flatnonzero((q < robot.lower_limits) | (q > robot.upper_limits))
        if len(beyond):
            name = robot.axis_joints[int(beyond[0])].name
            raise not_tested(f"--joints has joint `{name}` beyond its range", "see `ropsim robot show`")
        return q, "given joint coordinates"
    if options.at is None:
        return station.q_start, "start of the cell"
    if options.at not in cell.locations:
        hint = did_you_mean(options.at, cell.locations)
        raise not_tested(f"the cell has no location `{options.at}`", hint)
    if options.at in cell.located:
        frame = cell.located[options.at]
        raise not_tested(f"`{options.at}` is on `{frame}`, which moves", "give --joints instead")
    tool = station.tools.get(station.default_tool)
    X_BT = Pose.from_tuple(environment_of(cell, station).locations[options.at][:7])
    found = kinematics.inverse(robot, X_BT @ tool.X_MT.inverse() if tool else X_BT)
    if not len(found.solutions):
        raise not_tested(
            f"the arm does not reach `{options.at}`", "`ropsim robot ik` says what is in the way"
        )
    away = np.abs(found.solutions - station.q_start).max(axis=1)
    return found.solutions[int(away.argmin())], f"location `{options.at}`"


def not_tested(message: str, hint: str) -> NotTestedError:
    """Return the error that loops cannot be tested as requested."""
    return NotTestedError(NOT_TESTED.at(None, message, hint=hint))
