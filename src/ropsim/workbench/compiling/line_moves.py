"""The moves that lines of a program make first, by dry runs."""

from collections.abc import Callable, Iterator, Mapping

from ropsim import icr
from ropsim.core import frozen_dataclass
from ropsim.flow import MoveInstruction
from ropsim.workbench.compiling.resolved import BUDGET

#: Makes the world of a dry run from the values of inputs.
Worlds = Callable[[Mapping[str, bool | int | float]], icr.StillWorld]


@frozen_dataclass
class LineMoves:
    """Motions of a line.

    Attributes:
        first: the moves of the first time that a dry run comes to the line, one for each instruction.
        count: moves of all times.
    """

    first: tuple[MoveInstruction, ...]
    count: int

    @property
    def times(self) -> int:
        """Return how often the dry run comes to the line."""
        return -(-self.count // len(self.first))


def moves_by_line(code: icr.Program, world: Worlds = icr.PassingWorld) -> Mapping[int, LineMoves]:
    """Return the motions of lines (from 1).

    Waits end at once. Lines not reached with all inputs off are reached with all of them on: the run then
    passes a wait for several, and takes the branch of an `if` on an input.

    Args:
        code: of the program.
        world: makes the world of a dry run from the values of inputs.
    """
    found: dict[int, LineMoves] = {}
    for moves in dry_runs(code, world):
        found = {**_of_run(moves), **found}
    return found


def _of_run(moves: tuple[MoveInstruction, ...]) -> dict[int, LineMoves]:
    first: dict[int, list[MoveInstruction]] = {}
    count: dict[int, int] = {}
    for move in moves:
        line = move.origin.span.line if move.origin.span is not None else 0
        known = first.setdefault(line, [])
        if not known or _time(move) == _time(known[0]):
            known.append(move)
        count[line] = count.get(line, 0) + 1
    return {line: LineMoves(tuple(known), count[line]) for line, known in first.items()}


def _time(move: MoveInstruction) -> tuple[int, tuple[int, ...]]:
    """Return the common properties of the moves of a line at one time."""
    return move.origin.visit, move.origin.call_serials


def dry_runs(code: icr.Program, world: Worlds) -> Iterator[tuple[MoveInstruction, ...]]:
    """Yield the moves of dry runs, with all on/off inputs off, and on where there are some."""
    yield icr.run_verified(code, world({}), BUDGET).moves
    inputs = {one.name: True for one in code.channels if one.kind == "DI"}
    if inputs:
        yield icr.run_verified(code, world(inputs), BUDGET).moves
