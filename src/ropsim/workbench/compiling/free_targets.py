"""Targets whose orientation an arm with fewer than six axes cannot take, known without a run."""

from collections.abc import Mapping

import numpy as np

from ropsim import icr
from ropsim.core import Diagnostic, Severity, define
from ropsim.flow import MoveInstruction
from ropsim.kinematics import IkOptions, chooses_points_only, inverse, point_answers
from ropsim.model import Cell, Station
from ropsim.spatial import Pose
from ropsim.workbench.compiling.compiled_project import CompiledProgram, found_at
from ropsim.workbench.compiling.dry_arm import program_arm
from ropsim.workbench.compiling.environment import environment_of
from ropsim.workbench.compiling.line_moves import dry_runs
from ropsim.workbench.compiling.sensed_thresholds import thresholds

NEEDS_FREE = define(
    "X931",
    "target-needs-free",
    Severity.WARNING,
    "an arm with fewer than six axes reaches the position of a target, but not with this orientation",
    """
Such an arm chooses fewer than six coordinates of a pose: the orientation of a planar arm of two links follows
from the position. A run refuses the target ([M530](M530.md)) and skips the move. `ropsim check` and the
editor say so where the target has the same numbers each time that its line is reached, whatever the inputs
are; the others are left to the run.

**How to mend it.** Where only the position counts, write `free` behind the target. Else give it the
orientation that the arm has there (`ropsim robot fk` prints it), or joint coordinates.

```task
lin (850, 0, 700)        # X931 for two links: the flange turns with the position
lin (850, 0, 700) free   # reached
```
""",
)
_SIX = 6


def may_need_free(station: Station) -> bool:
    """Return whether the arm of a station has fewer than six axes."""
    return station.robot.has_arm and station.robot.n - len(station.robot.external) < _SIX


def targets_found_in(
    cell: Cell | None, programs: Mapping[str, Mapping[str, CompiledProgram]]
) -> tuple[Diagnostic, ...]:
    """Return the findings of `free_targets` and `thresholds` in programs without errors."""
    found = list[Diagnostic]()
    for stations in programs.values() if cell is not None else ():
        each = {
            name: (
                *free_targets(one.icr, cell, cell.stations[name]),
                *thresholds(one.icr, cell, cell.stations[name]),
            )
            for name, one in stations.items()
            if cell is not None
            and name in cell.stations
            and one.icr is not None
            and not any(finding.is_error for finding in one.diagnostics)
        }
        found += found_at(each) if each else ()
    return tuple(found)


def free_targets(code: icr.Program, cell: Cell, station: Station) -> tuple[Diagnostic, ...]:
    """Return a finding for each such target of a program, once, in order of place.

    Args:
        code: of the program.
        cell: in which it runs.
        station: that runs it.
    """
    if not may_need_free(station) or not chooses_points_only(station.robot):
        return ()
    if any(channel.kind == "AI" for channel in code.channels):  # numbers may follow from one
        return ()
    moving, found = environment_of(cell, station).moving, dict[object, set[MoveKey]]()
    moves = dict[object, MoveInstruction]()
    arm = program_arm(code, cell, station)

    def world(inputs: Mapping[str, bool | int | float]) -> icr.StillWorld:
        return icr.StillWorld(inputs, arm=arm)

    for run in dry_runs(code, world):
        for move in run:
            if not isinstance(move.target, Pose) or move.external or move.modal.frame in moving:
                continue
            found.setdefault(move.origin.span, set()).add(_key(move))
            moves[move.origin.span] = move
    constant = [moves[span] for span, keys in found.items() if len(keys) == 1 and span is not None]
    findings = [one for move in constant for one in _finding(move, station)]
    return tuple(sorted(findings, key=lambda one: (one.span.line, one.span.column) if one.span else (0, 0)))


MoveKey = tuple[object, ...]
"""Numbers of a target."""


def _key(move: MoveInstruction) -> MoveKey:
    assert isinstance(move.target, Pose)
    poses = (move.target, move.modal.X_BK, move.modal.X_MT or Pose())
    return (*(one.as_tuple() for one in poses), move.has_free_orientation)


def _finding(move: MoveInstruction, station: Station) -> tuple[Diagnostic, ...]:
    """Return the finding of a move, or none."""
    assert isinstance(move.target, Pose)
    if move.has_free_orientation:
        return ()
    robot, X_MT = station.robot, move.modal.X_MT or Pose()
    X_BT, q = move.modal.X_BK @ move.target, np.asarray(station.q_start)
    if len(inverse(robot, X_BT @ X_MT.inverse(), IkOptions(near=q)).solutions):
        return ()
    if not len(point_answers(robot, X_MT, X_BT.position, q).branches):
        return ()
    message = f"`{robot.name}` reaches the position of this target, but not with this orientation"
    hint = "where only the position counts, write `free` behind the target: its orientation follows then"
    return (NEEDS_FREE.at(move.origin.span, message, hint=hint),)
