"""A program by its meaning and by compiler and machine: where the two differ."""

from dataclasses import replace

from ropsim.flow import MoveInstruction
from ropsim.spatial import Pose, quaternion
from ropsim.workbench.testing import dry_arm
from support.outcomes import Outcome, outcome
from support.programs.making import spoilt_program
from support.programs.meaning import Run, carried_out
from support.programs.nodes import PLACE, Program
from support.programs.places import STATION, Place
from support.programs.text import written
from support.programs.values import TooLongError
from support.tasks import CELL, compiled

MOVING = replace(
    CELL, frames={**CELL.frames, "plate": (0.5, 0.5, 0.5, 0.6, 0.0, 0.8, 0.0)}, moving=frozenset({"plate"})
)
"""The cell with a frame that an external axis moves: no program names it, so none may mean anything else."""

REFUSED = ", at most 1e+12 m is allowed"
"""How the compiler ends the finding on a length that no cell has."""

PLACES = 1e-9
"""What a dozen products of rotations lose of lengths of a metre, with a margin of 10⁵."""


def disagreement(seed: int) -> str | None:
    """Return how program number `seed` differs in its two readings; empty where it does not.

    None where the program goes on for longer, or farther away, than it can be followed.
    """
    made = spoilt_program(seed)
    text = written(made)
    inputs = {"part_ok": seed % 2 == 0}
    if made.wrong is not None:
        line, code = made.wrong
        errors = [one for one in compiled(text, CELL).diagnostics if one.is_error]
        refused = [one.code for one in errors if not one.message.endswith(REFUSED)]
        return "" if refused == [code] else f"program {seed}: {refused}, meant is {code} of `{line}`\n{text}"
    try:
        meant = carried_out(made, inputs)
    except TooLongError:
        return None
    try:
        found = outcome(text, inputs, CELL if seed % 3 else MOVING, dry_arm(STATION, STATION.first))
        difference = _difference(made, meant, found)
    except AssertionError as error:
        if REFUSED in str(error):
            return None
        difference = str(error)
    return f"program {seed}: {difference}\n{text}" if difference else ""


def _difference(made: Program, meant: Run, found: Outcome) -> str:
    if meant.trap != found.trap:
        return f"trap {found.trap}, meant is {meant.trap}"
    if tuple(meant.says) != found.says:
        return f"says {found.says}, meant is {meant.says}"
    if len(meant.moves) != len(found.moves):
        return f"{len(found.moves)} moves, meant are {len(meant.moves)}"
    for number, (sent, move) in enumerate(zip(meant.moves, found.moves, strict=True)):
        if not _is_there(sent.place, move):
            return f"move {number} goes to {move.target}, meant is {sent.place}"
        if (sent.speed, sent.zone) != (move.modal.path_speed, move.modal.zone):
            return f"move {number} has {move.modal.path_speed} m/s, zone {move.modal.zone} m, meant is {sent}"
    for name, value in meant.values.items():
        is_exact = made.kinds.get(name, PLACE) != PLACE
        if not _is_same(value, found.values[name], PLACES * (not is_exact)):
            return f"{name} is {found.values[name]}, meant is {value}"
    return ""


def _is_same(meant: object, found: object, tolerance: float) -> bool:
    if isinstance(meant, Place):
        return isinstance(found, tuple) and _is_pose(meant, found)
    if isinstance(meant, float) and isinstance(found, float) and tolerance:
        return abs(meant - found) <= tolerance * max(1.0, abs(meant))
    return repr(meant) == repr(found)  # the sign of zero counts, and 1 is not 1.0


def _is_there(place: Place | str, move: MoveInstruction) -> bool:
    if isinstance(place, str):
        return (move.target is None) is (place == "home") and not isinstance(move.target, Pose)
    assert isinstance(move.target, Pose)
    return _is_pose(place, (move.modal.X_BK @ move.target).as_tuple())


def _is_pose(place: Place, pose: tuple[float, ...]) -> bool:
    w, x, y, z = pose[3:7]
    columns = [
        quaternion.rotate((w, x, y, z), axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    ]
    turn = zip(*columns, strict=True)
    numbers = [*pose[:3], *(part for row in turn for part in row)]
    wanted = [*place.at, *(part for row in place.turn for part in row)]
    return all(abs(a - b) <= PLACES * max(1.0, abs(a)) for a, b in zip(numbers, wanted, strict=True))
