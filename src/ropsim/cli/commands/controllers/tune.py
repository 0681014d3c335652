"""`ropsim controller tune`: gains of a station from bandwidths, and margins over the places of its arm."""

import argparse
import math
from functools import partial

import numpy as np

from ropsim import robots
from ropsim.cli.commands.controllers.response import not_tested, tested_station
from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.progress import Progress
from ropsim.cli.terminal.tuning_text import Tuned, tuning_document, tuning_text
from ropsim.model import (
    LAW_WORDS,
    ControllerKind,
    ControllerModel,
    Payload,
    RobotModel,
    Station,
    cube_of_water,
)
from ropsim.records import diagnostic_document
from ropsim.simulation import (
    check_places,
    held_cases,
    largest_bandwidths,
    mounted_load,
    place_grid,
)
from ropsim.spatial import Array
from ropsim.workbench import open_project

_TURN = 2.0 * math.pi


def tune(options: argparse.Namespace, output: Output) -> int:
    """Print gains and margins of a station; return the exit code, 1 for an unstable loop."""
    project = open_project(options.path)
    cell = project.cell
    if cell is None:
        code = output.findings(project.diagnostics, project.texts)
        output.document({"ok": False, **diagnostic_document(project.diagnostics)})
        return code or 1
    output.engine_note()
    station = tested_station(cell, options.station)
    robot, controller = station.robot, station.controller
    can_be_tuned = robots.can_be_tuned(controller)
    if not can_be_tuned and (options.bandwidth or options.damping is not None):
        law = LAW_WORDS.get(controller.kind, controller.kind.value)
        message = f"the law `{law}` has no gains that follow from bandwidth and damping"
        raise not_tested(message, "without --bandwidth and --damping its present gains are judged")
    if options.damping is not None and not robots.has_damping(controller):
        message = "loops of hydraulic axes have no damping ratio: leaks and the law damp them"
        raise not_tested(message, "give --bandwidth alone")
    damping = robots.STANDARD_DAMPING if options.damping is None else options.damping
    shown_damping = damping if robots.has_damping(controller) else math.nan
    built = partial(_built, robot, controller, damping)
    grid, loads = place_grid(robot), _loads(station)
    bodies = [load for _, load in loads]
    with Progress(f"tuning {robot.name}") as progress:
        if not held_cases(robot, grid, bodies[:1]):
            raise not_tested("the drives do not hold the arm at any place", "`ropsim check` says why")
        if not can_be_tuned:
            bandwidths = np.full(robot.n, np.nan)
        elif options.bandwidth:
            bandwidths = _given(robot, controller, options.bandwidth)
        else:
            start = robots.loop_bandwidths(robot, _standard(robot, controller))
            alone = range(robot.n) if robots.has_damping(controller) else ()
            bandwidths = largest_bandwidths(robot, built, start, grid, bodies, progress, alone)
        tuned = built(bandwidths) if can_be_tuned else controller
        checks = check_places(robot, tuned, grid, bodies, progress)
    shown = Tuned(
        station.name,
        robot,
        tuned,
        bandwidths / _TURN,
        shown_damping,
        grid,
        tuple(name for name, _ in loads),
        checks,
    )
    ok = all(one.stable for check in checks for one in check.margins)
    output.text(tuning_text(shown, output.style))
    output.document({"ok": ok, **tuning_document(shown), **diagnostic_document(())})
    return 0 if ok else 1


def _built(
    robot: RobotModel, controller: ControllerModel, damping: float, bandwidths: Array
) -> ControllerModel:
    return robots.tuned_controller(robot, controller, bandwidths, damping)


def _standard(robot: RobotModel, controller: ControllerModel) -> ControllerModel:
    """Return the controller with the standard gains of its law."""
    if controller.kind is ControllerKind.CASCADED_P_PI:
        return robots.cascaded_controller(robot, controller.rates)
    if not robots.has_damping(controller):
        return robots.controller_under(robot, controller.rates, controller.kind)
    return robots.default_controller(robot, controller.rates)


def _given(robot: RobotModel, controller: ControllerModel, given: list[float]) -> Array:
    """Return bandwidths that people state in Hz [rad/s], shape (n,)."""
    if len(given) not in (1, robot.n):
        count = f"--bandwidth has {len(given)} numbers"
        raise not_tested(f"{count}, the robot has {robot.n} axes", "give one for all, or one for each")
    most = 0.25 * controller.rates.control_hz
    if not all(0.0 < one <= most for one in given):
        raise not_tested(f"bandwidths are above 0 and up to {most:g} Hz", "a quarter of the control rate")
    return _TURN * np.broadcast_to(np.array(given), (robot.n,))


def _loads(station: Station) -> list[tuple[str, Payload]]:
    """Return nothing, and the rated payload; of an arm for which none is known its tool."""
    none, rated = ("no load", Payload()), station.robot.rated_payload
    if math.isfinite(rated):
        return [none, (f"{rated:.3g} kg", cube_of_water(rated))]
    tool = mounted_load(station.tools.get(station.default_tool))
    return [none, (f"tool, {tool.mass:.3g} kg", tool)] if tool.mass else [none]
