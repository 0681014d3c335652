"""Meant contacts of one station: what the environment exerts on its tool and held part."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ropsim.collision import ContactLaw, ContactPairs, Convex, TouchingPair, convexes
from ropsim.core import frozen_dataclass
from ropsim.dynamics import compiled
from ropsim.kinematics import frame_and_jacobian, frames_batch, speed_bound
from ropsim.model import (
    FLOOR,
    WORLD,
    BodyTree,
    Cell,
    JointType,
    MeantContact,
    Payload,
    RobotModel,
    body_tree,
    pressing_bodies,
    resisting_bodies,
    tool_body,
)
from ropsim.simulation.parts.placements import Placements, Seat
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun
from ropsim.spatial import Array, Pose

OVERSPEED = 1.5
"""Until it is looked at again an arm becomes at most so many times as fast as its limits, or as it is."""
CLOSE = 1e-3
"""Bodies that are nearer are looked at in each control tick [m]."""
_AT_INTERFACE = Pose()


@frozen_dataclass
class Exerted:
    """What the environment exerts.

    Attributes:
        wrench: force [N] and moment [N·m] about the origin of the mechanical interface, in W, shape (6,).
        efforts: the same at the axes [N·m | N], shape (n,).
        depth: of the deepest point [m].
        quiet: control ticks over which surely nothing is touched.
    """

    wrench: Array
    efforts: Array
    depth: float
    quiet: int


@dataclass(slots=True)
class Touching:
    """Meant contacts of one station.

    Attributes:
        name: of the station.
        pressing: bodies of the station that are pressed on others, or parts that it may hold.
        resisting: bodies that others are pressed on.
        pairs: of them.
        extent: how far each body reaches from its origin [m], by name.
        run: the cell, once it runs.
    """

    name: str
    pressing: frozenset[str]
    resisting: frozenset[str]
    pairs: ContactPairs
    extent: dict[str, float]
    run: CellRun | None = None
    _masses: tuple[Payload, Callable[[Array, Array], object]] | None = None
    _fastest: dict[float, float] = field(default_factory=dict)
    _seats: tuple[Placements, dict[str, Array], list[tuple[str, Seat]]] | None = None

    def exerted(self, q: Array, qd: Array, tick: int, payload: Payload | None = None) -> Exerted:
        """Return what acts on the arm at coordinates and speeds of its axes.

        Args:
            q: [rad | m], shape (n,).
            qd: [rad/s | m/s], shape (n,).
            tick: control tick of the station, for which the environment is taken.
            payload: what the arm bears; None where forces do not move it.
        """
        assert self.run is not None, "a station moves only while it runs"
        at = self.run.stations[self.name]
        robot, X_WB = at.station.robot, at.station.X_WB.matrix()
        X_BM, J = frame_and_jacobian(robot, q, _AT_INTERFACE)
        X_WM = X_WB @ X_BM
        held = self._held(at, X_WM, tick / at.hz)
        nothing = np.zeros(6), np.zeros(robot.n)
        if not held:
            return Exerted(*nothing, 0.0, _STILL)
        poses = {**held, **self._standing(self.run, at, q, tick)}
        placed = self.pairs.placed(poses)
        gap = placed.gap
        if gap > CLOSE and self._is_carried(self.run, at, q):
            return Exerted(*nothing, 0.0, 0)
        velocity = J @ qd
        if gap > CLOSE:
            reach = max(self._reach(name, pose, X_WM) for name, pose in held.items())
            present = float(np.linalg.norm(velocity[:3]) + reach * np.linalg.norm(velocity[3:]))
            speed = OVERSPEED * max(self._speed(robot, reach), present)
            return Exerted(*nothing, 0.0, int(min((gap - CLOSE) * at.hz / speed, _STILL)))
        R = X_WB[:3, :3]
        motion = np.array([X_WM[:3, 3], R @ velocity[:3], R @ velocity[3:]])
        mobility = np.zeros((6, 6)) if payload is None else self._mobility(robot, q, payload, J, R) / at.hz
        found = self.pairs.pressed(placed, motion, mobility)
        in_base = np.concatenate((R.T @ found.wrench[:3], R.T @ found.wrench[3:]))
        return Exerted(found.wrench, J.T @ in_base, found.depth, 0)

    def _mobility(self, robot: RobotModel, q: Array, payload: Payload, J: Array, R: Array) -> Array:
        """Return the accelerations of the interface for wrenches at its origin, both in W, shape (6, 6)."""
        if self._masses is None or self._masses[0] is not payload:
            self._masses = payload, compiled(robot, payload).mass_matrix
        entries = np.empty(robot.n * robot.n)
        self._masses[1](q, entries)
        in_world = np.vstack((R @ J[:3], R @ J[3:]))
        return np.asarray(in_world @ np.linalg.solve(entries.reshape(robot.n, robot.n), in_world.T))

    def _held(self, at: StationRun, X_WM: Array, time: float) -> dict[str, Array]:
        """Return the poses of the tool in force, its fingers, and the parts that it holds, by name."""
        assert self.run is not None
        found: dict[str, Array] = {}
        hand = at.hand
        if hand in self.pressing:
            found[hand] = X_WM
            fingers = at.tool.fingers if at.tool else None
            if fingers:
                q = at.fingers[hand].at(time)[0]
                frames = frames_batch(fingers.mechanism, np.array([[q]]))[0]
                found |= {f"{hand}/finger{k + 1}": X_WM @ frame for k, frame in enumerate(frames)}
        found = {name: pose for name, pose in found.items() if name in self.extent}
        for name, seat in self.run.parts.seats.items():
            if name in self.pressing and seat.rides in at.hands:
                found[name] = X_WM @ seat.pose.matrix()
        return found

    def _standing(self, run: CellRun, at: StationRun, q: Array, tick: int) -> dict[str, Array]:
        """Return the poses of the bodies that resist, by name; what other robots hold or move does not."""
        if self._seats is None or self._seats[0] is not run.parts:
            self._seats = run.parts, *self._seated(run)
        _, still, riding = self._seats
        if not riding:
            return still
        moved: dict[str, Array] = at.external_frames(q)
        for device in run.devices.values():
            moved |= {name: pose.matrix() for name, pose in device.poses(tick / at.hz).items()}
        found = {name: moved[seat.rides] @ seat.pose.matrix() for name, seat in riding if seat.rides in moved}
        return still | found

    def _seated(self, run: CellRun) -> tuple[dict[str, Array], list[tuple[str, Seat]]]:
        """Return the poses of the bodies that rest, by name, and where the others ride."""
        still: dict[str, Array] = {}
        riding: list[tuple[str, Seat]] = []
        for name in sorted(self.resisting):
            seat = run.scenery.objects.get(name) or run.parts.seats.get(name)
            if any(name in device.bodies for device in run.devices.values()):
                riding.append((name, Seat(name, name, Pose())))
            elif seat is not None and seat.rides == WORLD:
                still[name] = seat.pose.matrix()
            elif seat is not None:
                riding.append((name, seat))
        return still, riding

    def _is_carried(self, run: CellRun, at: StationRun, q: Array) -> bool:
        """Return whether a device or external axis may move something that resists, at any time."""
        riding = self._seats[2] if self._seats else []
        moved = {body for one in run.devices.values() for body in one.bodies} | at.external_frames(q).keys()
        return any(seat.rides in moved for _, seat in riding)

    def _reach(self, name: str, X_WB: Array, X_WM: Array) -> float:
        """Return how far a body reaches from the mechanical interface [m]."""
        return float(np.linalg.norm(X_WB[:3, 3] - X_WM[:3, 3])) + self.extent[name]

    def _speed(self, robot: RobotModel, reach: float) -> float:
        """Return a speed that by the limits no point within reach of the interface exceeds [m/s]."""
        if reach not in self._fastest:
            turning = sum(one.max_speed for one in robot.axis_joints if one.measure is JointType.REVOLUTE)
            of_interface = speed_bound(robot, np.zeros(3))
            self._fastest[reach] = of_interface + turning * reach
        return self._fastest[reach]


_STILL = 1 << 30
"""Control ticks for which nothing can be touched at all."""


def touching_of(cell: Cell, station: str) -> Touching | None:
    """Return the meant contacts of a station; None where there are none.

    Args:
        cell: with its contacts.
        station: its name.
    """
    if not cell.contacts:
        return None
    tree = body_tree(cell)
    declared = [(one, own_bodies(cell, one, station)) for one in cell.contacts]
    pairs = [
        TouchingPair(moving, standing, ContactLaw(one.stiffness, one.damping, one.friction))
        for one, own in declared
        for moving in own
        for standing in resisting_bodies(cell, one)
        if moving != standing
    ]
    if not pairs:
        return None
    pressing = frozenset(one.moving for one in pairs)
    resisting = frozenset(one.standing for one in pairs)
    solids = solids_of(tree, pressing | resisting)
    pairs = [
        one for one in pairs if one.moving in solids and (one.standing in solids or one.standing == FLOOR)
    ]
    extent = {name: _extent(some) for name, some in solids.items()}
    floor = FLOOR if FLOOR in resisting and FLOOR not in solids else ""
    return Touching(station, pressing, resisting, ContactPairs(solids, pairs, floor), extent)


def own_bodies(cell: Cell, contact: MeantContact, station: str) -> tuple[str, ...]:
    """Return the bodies of a contact that a station may press on others: its tool, or any part.

    Args:
        cell: with its contacts.
        contact: one of them.
        station: its name.
    """
    body = tool_body(contact.moving, station)
    bodies = pressing_bodies(cell, contact)
    return tuple(one for one in bodies if one in (body, contact.moving) or one.startswith(f"{body}/"))


def solids_of(tree: BodyTree, names: frozenset[str]) -> dict[str, tuple[Convex, ...]]:
    """Return the convex bodies of bodies that have some, by name.

    Args:
        tree: with the bodies.
        names: of those that count.
    """
    found = {
        body.name: tuple(one for shape in body.shapes for one in convexes(shape))
        for body in tree.bodies
        if body.name in names
    }
    return {name: some for name, some in found.items() if some}


def _extent(solids: tuple[Convex, ...]) -> float:
    """Return how far convex bodies reach from the origin of their body [m]."""
    reach = 0.0
    for one in solids:
        low, high = one.bounds
        farthest = float(np.linalg.norm(np.maximum(np.abs(low), np.abs(high))))
        reach = max(reach, float(np.linalg.norm(one.X_BC.position)) + farthest)
    return reach if math.isfinite(reach) else 0.0
