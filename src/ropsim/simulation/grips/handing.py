"""Hand-overs: two grippers are closed on one part, until one opens or pulls."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic, Span
from ropsim.icr import Program
from ropsim.model import WORLD, Tool, tool_body
from ropsim.simulation.diagnostics.part_diagnostics import PULLED_APART
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.placements import Placements
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.clasp import Clasp
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Array, Pose

CHECKS = 250
"""Rate of the check whether a part is pulled [Hz]."""


def let_go(run: CellRun, at: StationRun, tool: Tool) -> None:
    """Take notice that a gripper opens, or has closed on something else."""
    run.clasps.pop(tool_body(tool.name, at.station.name), None)


def take_over(run: CellRun, at: StationRun, tool: Tool, taken: Placements) -> None:
    """Take notice that a gripper has closed: who held the part before is still closed on it.

    Args:
        run: the cell, before.
        at: the station.
        tool: the gripper.
        taken: where the parts are from now on.
    """
    let_go(run, at, tool)
    name = taken.held({tool_body(tool.name, at.station.name)})
    before = run.parts.seats.get(name)
    if before is None or before.parent in at.hands:
        return
    for other in run.stations.values():
        for one in other.station.tools.values():
            hand = tool_body(one.name, other.station.name)
            if hand == before.parent:
                point = _point(before.pose.inverse(), one.X_MT.position)
                run.clasps[hand] = Clasp(other, one, name, point, at.due)


def kept(run: CellRun, name: str, moment: Moment) -> Placements | None:
    """Return the placements after one of two grippers on a part has opened; None where there is no other.

    Args:
        run: the cell, before.
        name: of the part.
        moment: where everything is now.
    """
    hand = next((hand for hand, one in run.clasps.items() if one.part == name), "")
    if not hand:
        return None
    del run.clasps[hand]
    seats = {one: run.parts.seats[one] for one in run.parts.family(name)}
    moved = {
        one: replace(seat, rides=hand, pose=moment.on(hand, moment.pose(seat))) for one, seat in seats.items()
    }
    moved[name] = replace(moved[name], parent=hand)
    return run.parts.with_seats(moved)


def find_pulls(run: CellRun, until: int, programs: Mapping[str, Program]) -> None:
    """Find parts that are pulled by two grippers up to a tick of the cell's clock (S743)."""
    if not run.clasps:
        return
    step = max(1, run.hz // CHECKS)
    for hand, clasp in tuple(run.clasps.items()):
        for tick in range(clasp.seen + step, until + 1, step):
            clasp.seen = tick
            distance = _distance(run, clasp, tick)
            if clasp.tool.gripper is not None and distance > clasp.tool.gripper.capture:
                run.findings.append(_finding(run, clasp, distance, tick, programs))
                del run.clasps[hand]
                break


def _distance(run: CellRun, clasp: Clasp, tick: int) -> float:
    """Return how far the gripper is from where it holds the part [m]."""
    seat = run.parts.seats.get(clasp.part)
    if seat is None:
        return 0.0
    holder = _holder(run, clasp.part)
    if holder is not None:
        X_WO = holder.carriers(tick)[seat.rides] @ seat.pose
    else:
        X_WO = seat.pose if seat.rides == WORLD else run.moment(tick).pose(seat)
    hand = tool_body(clasp.tool.name, clasp.at.station.name)
    tcp = (clasp.at.carriers(tick)[hand] @ clasp.tool.X_MT).position
    return float(np.linalg.norm(_point(X_WO, clasp.point) - tcp))


def _holder(run: CellRun, part: str) -> StationRun | None:
    rides = run.parts.seats[part].rides
    return next((one for one in run.stations.values() if rides in one.hands), None)


def _point(pose: Pose, p: Array) -> Array:
    return np.asarray(pose.position + pose.rotation() @ p)


def _finding(
    run: CellRun, clasp: Clasp, distance: float, tick: int, programs: Mapping[str, Program]
) -> Diagnostic:
    giver, time = clasp.at, tick / run.hz
    holder = _holder(run, clasp.part)
    moving = giver if holder is None or _moves(giver, tick) else holder
    name = moving.station.name
    line = int(moving.tracks["line"].value(tick / moving.cell_ticks))
    capture = clasp.tool.gripper.capture if clasp.tool.gripper else 0.0
    by = f"`{holder.station.name}`" if holder else "nothing"
    return PULLED_APART.at(
        Span.whole_line(programs[name].source, line) if line and name in programs else None,
        f"`{giver.station.name}` is still closed on part `{clasp.part}`, which {by} holds, and is "
        f"{distance * 1e3:.1f} mm away from where it grips it, allowed are {capture * 1e3:g} mm",
        label=f"at t = {time:.2f} s",
        hint=f"let `{giver.station.name}` open before one of the two moves: let them wait for each other",
        data={"part": clasp.part, "station": giver.station.name, "distance_m": distance, "time_s": time},
    )


def _moves(at: StationRun, tick: int) -> bool:
    return at.tracks["move"].value(tick / at.cell_ticks) >= 0.0
