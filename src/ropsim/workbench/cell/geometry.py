"""Conditions of tasks decided by the geometry of a cell: reach of its arms, and obstacles there."""

from collections.abc import Hashable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ropsim import icr, language
from ropsim.flow import MoveInstruction
from ropsim.kinematics import (
    IkOptions,
    chooses_points_only,
    inverse,
    limit_violations,
    point_answers,
    turned_to_limits,
)
from ropsim.model import Cell, Part, Station
from ropsim.spatial import Array, Pose
from ropsim.workbench.compiling.environment import environment_of

if TYPE_CHECKING:  # callers of knowledge bases load them and their engine
    from ropsim.tasks import InTheAir, Missing, Obstruction, Overlap, Point
    from ropsim.workbench.cell.collisions import CellCollisions
    from ropsim.workbench.cell.part_supports import PartSupports

ARM = "arm"
"""How tasks call the first robot of a cell; others have the names of their stations."""


class CellGeometry:
    """Answers by inverse kinematics and distances, for the tool that a robot has at the start.

    Args:
        cell: with its bodies as at the start.
        folder: of the project, whose meshes are read for collision checks; None for none.
    """

    def __init__(self, cell: Cell, folder: Path | None = None) -> None:
        self._cell = cell
        self._folder = folder
        self._made: CellCollisions | None = None
        self._supports: PartSupports | None = None
        self._moves: dict[tuple[str, Point], MoveInstruction | None] = {}
        self._environments: dict[str, language.Environment] = {}
        self.revision: Hashable = id(cell)

    def missing(self, robot: str, location: "Point") -> "Missing | None":
        """Return the robot, location or frame that is named and that the cell does not have; None for none.

        Args:
            robot: as with `reachable`.
            location: as with `reachable`.
        """
        from ropsim.tasks import FramedPoint, Missing

        station = self._station(robot)
        if station is None:
            return Missing("robot", robot, (ARM, *self._cell.stations))
        if self._move(station, location) is not None:
            return None
        environment = self._environment(station)
        match location:
            case str() if location not in environment.locations:
                return Missing("location", location, tuple(environment.locations))
            case FramedPoint(_, frame) if frame not in environment.frames:
                return Missing("frame", frame, tuple(environment.frames))
        return None

    def reachable(self, robot: str, location: "Point") -> bool:
        """Return whether a robot has joint coordinates inside its limits for a location.

        Args:
            robot: `arm`, or the name of a station; no other is there.
            location: name of the cell, or numbers in millimetres and degrees, read as task text reads
                them. One that has joint values, or lies in a frame that moves, is taken to be in reach.
        """
        station = self._station(robot)
        if station is None:
            return False
        move = self._move(station, location)
        if move is None:
            return False
        found = self._postures(station, move)
        return found is None or len(found) > 0

    def obstruction(self, robot: str, part: str, location: "Point") -> "Obstruction | None":
        """Return the obstacle of a robot that holds a part at a location; None if free.

        One posture within the limits that is free is enough. Of a location out of reach, or in a frame that
        moves, nothing is said.

        Args:
            robot: as with `reachable`.
            part: the held part, grasped as at its start place.
            location: as with `reachable`.
        """
        from ropsim.tasks import Obstruction

        station = self._station(robot)
        move = self._move(station, location) if station is not None else None
        if station is None or move is None:
            return None
        looked = self._collisions()
        found = looked.first_meeting(station, part, location, self._postures(station, move) or ())
        if found is None:
            return None
        names = found.pair
        if not looked.is_moved(station, names[0], part):
            names = names[1], names[0]
        one, other = map(looked.words, names)
        return Obstruction(one, other, -found.distance)

    def overlap(self, robot: str, part: str, x: float, y: float) -> "Overlap | None":
        """Return the overlap of a part and an equal one left next to it; None if they do not overlap.

        So deep as the cell allows for parts that are set down they may be in each other.

        Args:
            robot: as with `reachable`.
            part: the released part, grasped as at its start place.
            x: distance to it along X of the tool [m].
            y: how far against Y of the tool [m].
        """
        from ropsim.tasks import Overlap

        if self._station(robot) is None:
            return None
        found = self._collisions().beside(part, np.array([x, -y, 0.0]))
        return None if found is None else Overlap(*found)

    def in_the_air(
        self, robot: str, part: str, location: "Point", lying: "Mapping[str, Point]"
    ) -> "InTheAir | None":
        """Return how high a part that a robot leaves is above the body below it; None if it is supported.

        The result is None for a part or a location that is not in the cell, in a frame that moves, or with
        joint values, and in a cell without fixed objects, or with a mesh; also for the start location of the
        part, which the cell file defines.

        Args:
            robot: as with `reachable`.
            part: the released part, grasped as at its start place.
            location: as with `reachable`.
            lying: where other parts lie, by their names.
        """
        from ropsim.tasks import InTheAir

        station, looked = self._station(robot), self._collisions()
        X_WO = None if station is None else self._lying_at(station, part, location)
        if station is None or X_WO is None or location == looked.place_of(part):
            return None
        supports, own = self._carriers(), looked.parts[part]
        still = [(one, one.X_WO) for one in looked.parts.values() if self._lies_still(one, part, lying)]
        if supports.carries(own, X_WO, still):
            return None
        moved = ((name, self._lying_at(station, name, at)) for name, at in lying.items() if name != part)
        others = [*still, *((looked.parts[name], X) for name, X in moved if X is not None)]
        if supports.carries(own, X_WO, others):
            return None
        height, below = supports.below(own, X_WO, others)
        return InTheAir(below, height, supports.words)

    def prepare(self) -> None:
        """Read meshes, and make distances ready."""
        self._collisions()

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Return the omitted checks."""
        return tuple(self._collisions().unchecked)

    def pose(self, location: "Point") -> Pose | None:
        """Return X_BT of a location for the first robot of the cell.

        Args:
            location: as for `reachable`.

        Returns:
            None if the location is unknown, has joint values, or lies in a frame that moves.
        """
        move = self._move(self._cell.first, location)
        return None if move is None else self._pose(self._cell.first, move)

    def _lies_still(self, one: Part, left: str, lying: "Mapping[str, Point]") -> bool:
        """Return whether a part lies where it lay at the start."""
        if one.name == left or one.turn > 0:
            return False
        place = self._collisions().places.get(one.name)
        return place is None or lying.get(one.name) == place

    def _lying_at(self, station: Station, part: str, location: "Point") -> Pose | None:
        """Return X_WO of a part that an arm leaves at a location, None if unknown."""
        looked = self._collisions()
        move = self._move(station, location) if part in looked.parts else None
        X_BT = None if move is None else self._pose(station, move)
        return None if X_BT is None else station.X_WB @ X_BT @ looked.hanging(part)

    def _carriers(self) -> "PartSupports":
        if self._supports is None:
            from ropsim.workbench.cell.part_supports import PartSupports

            self._supports = PartSupports.of(self._cell)
        return self._supports

    def _move(self, station: Station, location: "Point") -> MoveInstruction | None:
        """Return the move to a location, as a program of this station would make it."""
        asked = station.name, location
        if asked not in self._moves:
            self._moves[asked] = self._compiled_move(station, location)
        return self._moves[asked]

    def _compiled_move(self, station: Station, location: "Point") -> MoveInstruction | None:
        from ropsim.tasks import TaskCall

        text = f"program reach\nunits mm, deg, s\nmov {TaskCall('', (location,))}\n"
        code = language.compile(text, self._environment(station)).icr
        moves = icr.run(code).moves if code is not None else ()
        return moves[0] if moves else None

    def _pose(self, station: Station, move: MoveInstruction) -> Pose | None:
        """Return X_BT of the target of a move, None where it is not known before the program runs."""
        if not isinstance(move.target, Pose) or move.modal.frame in self._environment(station).moving:
            return None
        return move.modal.X_BK @ move.target

    def _environment(self, station: Station) -> language.Environment:
        if station.name not in self._environments:
            self._environments[station.name] = environment_of(self._cell, station)
        return self._environments[station.name]

    def _collisions(self) -> "CellCollisions":
        if self._made is None:
            from ropsim.collision import NO_MESHES
            from ropsim.meshes import mesh_points
            from ropsim.workbench.cell.collisions import CellCollisions

            meshes = NO_MESHES if self._folder is None else mesh_points(self._folder, self._cell)
            self._made = CellCollisions(self._cell, meshes)
        return self._made

    def _station(self, robot: str) -> Station | None:
        return self._cell.first if robot == ARM else self._cell.stations.get(robot)

    def _postures(self, station: Station, move: MoveInstruction) -> tuple[Array, ...] | None:
        """Return joint coordinates within limits with which a move can end; None where it is not known."""
        if move.target is None:
            return None
        if not isinstance(move.target, Pose):
            return (np.asarray(move.target, dtype=np.float64),)
        X_BT = self._pose(station, move)
        if X_BT is None:
            return None
        X_MT, options = move.modal.X_MT or Pose(), _near(station, move.external)
        if not move.has_free_orientation:
            return tuple(inverse(station.robot, X_BT @ X_MT.inverse(), options).solutions)
        if not chooses_points_only(station.robot):
            return None  # the orientation is that of the move before
        assert options.near is not None
        found = point_answers(station.robot, X_MT, X_BT.position, options.near).branches
        return tuple(
            turned_to_limits(station.robot, q) for q in found if not limit_violations(station.robot, q)
        )


def _near(station: Station, external: tuple[float, ...]) -> IkOptions:
    """Return that the arm is near its start, with external axes [rad | m] where a location has them."""
    q = station.q_start.copy()
    if external:
        q[list(station.robot.external)] = external
    return IkOptions(near=q)
