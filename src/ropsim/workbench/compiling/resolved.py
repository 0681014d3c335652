"""Where the locations of a text are, by compiler and dry run: declared ones, and targets of moves."""

import re
from collections.abc import Iterator
from dataclasses import replace

from ropsim import icr, language
from ropsim.core import frozen_dataclass
from ropsim.flow import MoveInstruction
from ropsim.language import Environment, Role
from ropsim.spatial import Pose

#: ICR instructions after which the dry run of a text ends: a fraction of a second.
BUDGET = 100_000

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
        frame: name of the frame of its coordinates in the program, empty for the base frame.
        X_FT: the same pose in that frame.
        moving: name of a frame that external axes move, in which alone the pose is known; empty for none.
    """

    X_BT: Pose
    frame: str
    X_FT: Pose
    moving: str = ""


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


def places_of(move: MoveInstruction, environment: Environment) -> tuple[Resolved | None, ...]:
    """Return the places that a move leads to, via points first; None for other targets than poses."""
    through = (replace(move, target=pose) for pose in move.via)
    return tuple(_resolved(one, environment, one.modal.frame, None) for one in (*through, move))


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
) -> Resolved | None:
    if not isinstance(move.target, Pose):
        return None
    modal = move.modal
    if modal.frame in environment.moving:
        return Resolved(move.target, modal.frame, move.target, modal.frame)
    X_BT = modal.X_BK @ move.target
    if origin is not None and isinstance(origin.target, Pose):
        X_BF = origin.modal.X_BK @ origin.target
        return Resolved(X_BT, frame, X_BF.inverse() @ X_BT)
    return Resolved(X_BT, modal.frame, move.target)
