"""Supplies in a cell: the next part comes when a device has carried the one before off its place."""

import math
from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from ropsim.kinematics import Blocks, part_blocks
from ropsim.model import WORLD, Cell, Part
from ropsim.simulation.devices.device_run import DeviceRun
from ropsim.simulation.parts.placements import Seat
from ropsim.simulation.parts.standing import stood
from ropsim.simulation.state.cell_run import CellRun
from ropsim.spatial import Pose

CLEAR = 1e-6
"""Boxes that reach no deeper into each other than this only touch [m]."""


def feed(run: CellRun, tick: int) -> None:
    """Let the next part of each supply come whose place is free at a tick of the cell's clock.

    The one before has been carried away by a device, or has left the cell at the end of one; one that a
    gripper takes makes room at once (`parts.close_on`). The new part needs a support: a belt, or a body at
    rest.
    """
    time = tick / run.hz
    for part in _expected(run):
        poses = _poses(run, time)
        if any(_meet(part, part.X_WO, run.scenery.parts[name], pose) for name, pose in poses.items()):
            continue
        come = run.parts.with_seats({part.name: Seat(WORLD, WORLD, part.X_WO)})
        come = replace(come, queued=come.queued - {part.name})
        come, found = stood(come, (part.name,), run.scenery, run.cell.supports, run.moment(tick))
        if found[part.name].on is not None and not _turns(run, come.seats[part.name].rides, time):
            run.place(come, tick)


def free_from(run: CellRun, device: DeviceRun, time: float) -> float:
    """Return when a belt carries the next part off the place of a supply [s]; inf for never.

    Args:
        run: the cell.
        device: that has its profile now; other devices than belts are checked at their place.
        time: from which on [s].
    """
    found = math.inf
    if not device.device.is_belt:
        return found
    for part in _expected(run):
        poses, (q, _) = device.poses(time), device.profile.at(time)
        for name, seat in run.parts.seats.items():
            body = poses.get(seat.rides)
            if body is None:
                continue
            rider, X_CO = run.scenery.parts[name], body.inverse() @ part.X_WO
            if _meet(part, X_CO, rider, seat.pose):
                place, half = along(part, X_CO)
                centre, half_rider = along(rider, seat.pose)
                way = place + half + half_rider - centre
                found = min(found, device.profile.time_of(q + way, time))
    return found


def supplies_of(cell: Cell) -> dict[str, deque[Part]]:
    """Return the parts of each supply in order; the first one is that which has come last."""
    found: dict[str, deque[Part]] = {}
    for part in sorted((one for one in cell.parts if one.supply), key=lambda one: one.turn):
        found.setdefault(part.supply, deque()).append(part)
    return found


def along(part: Part, pose: Pose) -> tuple[float, float]:
    """Return the middle of a part along z of the body that it moves with, and half its length [m]."""
    R = pose.rotation()
    centre = pose.position[2] - R[2, 2] * part.size[2] / 2.0
    return float(centre), float(np.abs(R[2]) @ part.size / 2.0)


def _expected(run: CellRun) -> Iterator[Part]:
    """Yield the next part of each supply where the one before has left its place, or is on its way."""
    for parts in run.supplies.values():
        while len(parts) > 1 and parts[1].name not in run.parts.queued:
            parts.popleft()
        if len(parts) > 1:
            seat = run.parts.seats.get(parts[0].name)
            if seat is None or seat.rides != WORLD:
                yield parts[1]


def _poses(run: CellRun, time: float) -> Mapping[str, Pose]:
    """Return X_WO of each part that rests or moves with a device, by name; held parts are excluded."""
    bodies = {name: pose for device in run.devices.values() for name, pose in device.poses(time).items()}
    found = {}
    for name, seat in run.parts.seats.items():
        if seat.rides == WORLD:
            found[name] = seat.pose
        elif seat.rides in bodies:
            found[name] = bodies[seat.rides] @ seat.pose
    return found


def _turns(run: CellRun, body: str, time: float) -> bool:
    """Return whether a body is one of a device that moves and is not made to be loaded then."""
    return any(
        body in device.bodies and not device.device.is_belt and device.profile.at(time)[1] != 0.0
        for device in run.devices.values()
    )


def _meet(one: Part, pose: Pose, other: Part, other_pose: Pose) -> bool:
    """Return whether the boxes of two parts reach into each other.

    They do not where a face of one of them separates them; separation by edges alone is not checked.
    """
    blocks: Blocks = part_blocks([(one, pose), (other, other_pose)])
    between = blocks.centres[1] - blocks.centres[0]
    axes = np.concatenate([blocks.rotations[0].T, blocks.rotations[1].T])
    reach = sum(np.abs(axes @ blocks.rotations[k]) @ blocks.halves[k] for k in (0, 1))
    return bool((np.abs(axes @ between) < reach - CLEAR).all())
