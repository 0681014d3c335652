"""Where the locations of a text are, by compiler and dry run: declared ones, and those that lines move to."""

import re
from collections.abc import Callable, Iterator, Mapping

from ropsim import icr, language
from ropsim.core import frozen_dataclass
from ropsim.flow import MoveInstruction
from ropsim.language import Environment, Role
from ropsim.spatial import Pose

#: ICR instructions after which the dry run of a text ends: a fraction of a second.
BUDGET = 100_000

#: Makes the world of a dry run from the values of inputs.
Worlds = Callable[[Mapping[str, bool | int | float]], icr.StillWorld]

_HEADS = re.compile(r"\s*(?:program|units|classic|strict)\b", re.IGNORECASE)
_SET_FRAME = re.compile(r"\s*set\s+frame\s+\w+\s*$", re.IGNORECASE)
_BEFORE = re.compile(
    r"\s*(?:(?:program|units|classic|strict|frame|loc|tool|signal|const|var|pattern|set)\b|#|//|$)",
    re.IGNORECASE,
)
_DECLARED = (Role.FRAME, Role.LOCATION, Role.CONSTANT, Role.TOOL)


@frozen_dataclass
class Resolved:
    """A location with its numbers.

    Attributes:
        X_BT: tool frame in the base frame; in the frame `moving` where that is not empty.
        frame: name of the frame in which the program gives it, empty for the base frame.
        X_FT: the same pose in that frame.
        moving: name of a frame that external axes move, in which alone the pose is known; empty for none.
        visits: how often a dry run comes to the line.
    """

    X_BT: Pose
    frame: str
    X_FT: Pose
    moving: str = ""
    visits: int = 1


def location_of(text: str, outline: language.Outline, name: str, environment: Environment) -> Resolved | None:
    """Return where a location that a text declares is; None where lines are wrong, or it has joint values."""
    declared = [
        one.line for one in outline.definitions if not one.task and one.role in _DECLARED and one.name != name
    ]
    own = next((one.line for one in outline.definitions if not one.task and one.name == name), None)
    if own is None:
        return None
    frame = re.search(r"(?:\bin|@)\s+([A-Za-z_]\w*)\s*(?:(?:#|//).*)?$", own)
    probes = [f"mov {name}", *([f"mov (0, 0, 0; rpy 0 0 0) in {frame[1]}"] if frame else [])]
    order = sorted({*declared, own}, key=text.find)
    moves = _moves("\n".join((*_heads(text), *order, *probes, "")), environment)
    if len(moves) != len(probes):
        return None
    return _resolved(moves[0], environment, frame[1] if frame else "", moves[1] if frame else None)


def targets_by_line(
    code: icr.Program, environment: Environment, world: Worlds = icr.PassingWorld
) -> Mapping[int, Resolved]:
    """Return where the moves of each line (from 1) go first.

    What is waited for comes. Lines to which the program does not come with all inputs off are looked for with
    all of them on: so it passes a wait for several, and goes the way of an `if` that needs one.

    Args:
        code: of the program.
        environment: what it can name.
        world: makes the world of a dry run from the values of inputs.
    """
    found: dict[int, MoveInstruction] = {}
    visits: dict[int, int] = {}
    for moves in _runs(code, world):
        known = frozenset(found)
        for move in moves:
            line = move.origin.span.line if move.origin.span is not None else 0
            if line not in known:
                found.setdefault(line, move)
                visits[line] = visits.get(line, 0) + 1
    made = {
        line: _resolved(move, environment, move.modal.frame, None, visits[line])
        for line, move in found.items()
    }
    return {line: one for line, one in made.items() if one is not None}


def _runs(code: icr.Program, world: Worlds) -> Iterator[tuple[MoveInstruction, ...]]:
    """Yield the moves of dry runs, with all on/off inputs off, and on where there are some."""
    yield icr.run_verified(code, world({}), BUDGET).moves
    inputs = {one.name: True for one in code.channels if one.kind == "DI"}
    if inputs:
        yield icr.run_verified(code, world(inputs), BUDGET).moves


def _heads(text: str) -> Iterator[str]:
    """Yield the lines that say how literals of the text are to be read."""
    lines = text.splitlines()
    yield from (line for line in lines if _HEADS.match(line))
    for line in lines:
        if _SET_FRAME.match(line):
            yield line
        if not _BEFORE.match(line):
            return


def _moves(text: str, environment: Environment) -> tuple[MoveInstruction, ...]:
    compiled = language.compile(text, environment)
    return _run(compiled.icr) if compiled.icr is not None else ()


def _run(program: icr.Program) -> tuple[MoveInstruction, ...]:
    return icr.run_verified(program, budget=BUDGET).moves


def _resolved(
    move: MoveInstruction,
    environment: Environment,
    frame: str,
    origin: MoveInstruction | None,
    visits: int = 1,
) -> Resolved | None:
    if not isinstance(move.target, Pose):
        return None
    modal = move.modal
    if modal.frame in environment.moving:
        return Resolved(move.target, modal.frame, move.target, modal.frame, visits)
    X_BT = modal.X_BK @ move.target
    if origin is not None and isinstance(origin.target, Pose):
        X_BF = origin.modal.X_BK @ origin.target
        return Resolved(X_BT, frame, X_BF.inverse() @ X_BT, visits=visits)
    return Resolved(X_BT, modal.frame, move.target, visits=visits)
