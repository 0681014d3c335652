"""A device at work: it reads its signals, moves, carries parts and reports its position by inputs."""

import math
from bisect import bisect_right

import numpy as np

from ropsim.core import Diagnostic
from ropsim.simulation.devices.device_run import NEVER, Carried, DeviceRun, Now
from ropsim.simulation.diagnostics.part_diagnostics import RUN_OFF
from ropsim.simulation.grips.feeding import along, feed, free_from
from ropsim.simulation.parts.placements import Exit, Placements
from ropsim.simulation.records.track import tick_at
from ropsim.simulation.state.cell_run import CellRun
from ropsim.spatial import Pose


def act(run: CellRun, device: DeviceRun) -> None:
    """Let a device act at the tick at which it is due."""
    tick = device.acted = device.due
    time = tick / run.hz
    carried = tuple(_carried(name, run) for name in _riders(run.parts, device))
    response = device.driving.act(device.profile, Now(time, lambda name: run.is_on(name, time), carried))
    place = bisect_right(device.scripted, tick)
    nexts = list(device.scripted[place : place + 1])
    due = min(response.due, free_from(run, device, time))
    if due < math.inf:
        nexts.append(max(tick_at(due, run.hz), tick + 1))
    device.due = min(nexts, default=NEVER)
    for name, level in device.heard(response.levels):
        run.set_input(name, tick, float(level))
    if response.lost:
        _lose(run, device, response.lost, tick)
    feed(run, tick)


def _riders(parts: Placements, device: DeviceRun) -> list[str]:
    """Return the names of the parts that move with a device."""
    return [name for name, seat in parts.seats.items() if seat.rides in device.bodies]


def _carried(name: str, run: CellRun) -> Carried:
    seat, part = run.parts.seats[name], run.scenery.parts[name]
    centre, half = along(part, seat.pose)
    return Carried(name, centre + half, 2.0 * half)


def _lose(run: CellRun, device: DeviceRun, names: tuple[str, ...], tick: int) -> None:
    """Let parts leave the cell at the end of a belt; that is as it should be where there is a sink."""
    moment = run.moment(tick)
    gone: dict[str, Exit] = {}
    for name in names:
        sink = _sink(run, moment.pose(run.parts.seats[name]))
        if not sink:
            run.findings.append(_run_off(name, device.device.name, tick / run.hz))
        for one in run.parts.family(name):
            gone[one] = Exit(moment.pose(run.parts.seats[one]), sink, device.device.name)
    run.place(run.parts.without(gone), tick)


def _sink(run: CellRun, X_WO: Pose) -> str:
    """Return the name of the sink that takes a part at a pose, empty for none."""
    for sink in run.cell.sinks:
        if np.linalg.norm(X_WO.position - np.array(sink.position)) <= sink.radius:
            return sink.name
    return ""


def _run_off(part: str, device: str, time: float) -> Diagnostic:
    return RUN_OFF.at(
        None,
        f"part `{part}` has run off the end of `{device}` at t = {time:.2f} s",
        hint="stop the belt earlier, by its `run` signal or a `stop`, or put a sink at its end",
        data={"part": part, "device": device, "time_s": time},
    )
