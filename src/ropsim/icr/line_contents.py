"""Content on which the result of each line of a program depends, and reached instructions."""

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from hashlib import sha256
from typing import Any

from ropsim.flow import (
    AwaitInstruction,
    GripInstruction,
    Instruction,
    MessageInstruction,
    MotionKind,
    MoveInstruction,
    Origin,
    OutputInstruction,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr.identity import program_id
from ropsim.icr.machine.machine import Machine, MachineOptions
from ropsim.icr.machine.state import Finished
from ropsim.icr.machine.world import PassingWorld, StillWorld
from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import Program
from ropsim.spatial import bits_without
from ropsim.version import __version__

Place = tuple[int, int]
"""Procedure and instruction of a code."""


def reached(program: Program, places: Iterable[Place]) -> set[Place]:
    """Return the instructions that can come from some places on, without instructions behind a return."""
    waiting = list(places)
    seen: set[Place] = set()
    while waiting:
        place = waiting.pop()
        if place in seen:
            continue
        seen.add(place)
        procedure, index = place
        step = program.procedures[procedure].code[index]
        opcode = OPCODES[step.mnemonic]
        if opcode.operands == (OperandKind.LABEL,):
            waiting.append((procedure, int(str(step.operands[0]))))
        if opcode.operands == (OperandKind.PROCEDURE,):
            waiting.append((program.procedure_numbers[str(step.operands[0])], 0))
        if not opcode.ends_flow and index + 1 < len(program.procedures[procedure].code):
            waiting.append((procedure, index + 1))
    return seen


MOST = 5_000
"""Robot instructions that are compared one by one; later ones depend on the whole code."""

_BUDGET = 200_000
_DIGITS = 16
_TAKING_TIME = (MoveInstruction, GripInstruction, WaitInstruction, AwaitInstruction)
_KINDS = (*_TAKING_TIME, OutputInstruction, MessageInstruction, SyncInstruction)
_BITS: Mapping[type, Callable[[Any], Hashable]] = {kind: bits_without(kind, "origin") for kind in _KINDS}
_UNSEEN = frozenset({"", "HALT", "STOP"})  # the robot stands before these, and the program learns nothing


def line_contents_of_all(
    programs: Mapping[str, Program], *around: str, channels: str = ""
) -> Mapping[str, Mapping[int, str]]:
    """Return the keys of lines of concurrent programs, each including the other programs as a whole.

    Args:
        programs: by station, in the order of the cell.
        around: other dependencies.
        channels: values of inputs in the run.
    """
    ids = {station: program_id(program) for station, program in programs.items()}
    return {
        station: line_contents(program, *around, *_others(ids, station), channels=channels)
        for station, program in programs.items()
    }


def _others(ids: Mapping[str, str], station: str) -> Iterator[str]:
    return (one for name, one in ids.items() if name != station)


def line_contents(
    program: Program, *around: str, channels: str = "", world: StillWorld | None = None
) -> Mapping[int, str]:
    """Return the content on which the result of each line with a move, grip or wait depends.

    Two programs in which a line has the same key act identically up to the end of the motion sequence of the
    last pass of that line, and on to the next move of the joints, whose posture may look ahead. This is known
    without a run up to the first read of an input, of the time or of the pose of the arm; later instructions
    depend on the whole code, and so do instructions after the first `MOST`, each line with a separate key.
    From the first instruction on that reads a channel, the values of the channel also count. Another version
    of ropsim has other results.

    Args:
        program: in which the verifier finds nothing.
        around: other dependencies, such as the cell and the programs of other stations.
        channels: known values of inputs in the run.
        world: of the dry run; a `PassingWorld` where it is None.

    Returns:
        By line (from 1) of the source, in the order in which they are passed first; lines behind the first
        read, and lines that are never passed, follow in the order of the text.
    """
    around = (__version__, *around)
    run = _Run(program, around, channels, world or PassingWorld())
    found = {line: run.key_behind(end) for line, end in run.ends().items() if run.is_known(end)}
    later = {program.procedures[procedure].lines[index] for procedure, index in run.later}
    others = sorted(line for line in _acting_lines(program) if line in later or line not in found)
    rest = (*around, channels, program_id(program)) if others else ()
    return {
        **{line: key for line, key in found.items() if line not in later},
        **{line: _key((*rest, place)) for place, line in enumerate(others)},
    }


class _Run:
    """A dry run up to the first look of the program.

    Attributes:
        steps: instructions handed out.
        later: instructions of the code (procedure, index) that can come behind the look.
    """

    def __init__(self, program: Program, around: tuple[str, ...], channels: str, world: StillWorld) -> None:
        self._program = program
        self._around = around
        self._channels = channels
        self._is_cut = False
        self.steps: list[Instruction] = []
        self.later: frozenset[tuple[int, int]] = frozenset()
        self._keys: list[str] = []
        self._carry_out(world)

    def _carry_out(self, world: StillWorld) -> None:
        key = _key(self._around)
        machine = Machine(self._program, world, MachineOptions(_BUDGET))
        while True:
            step = machine.advance()
            if isinstance(step, Finished) and step.steps < _BUDGET:
                return
            if isinstance(step, Finished) or _is_look(step) or len(self.steps) >= MOST:
                callers, procedure, index = machine.code_place
                self.later = frozenset(reached(self._program, (*callers, (procedure, index))))
                self._is_cut = isinstance(step, Finished) or not _is_look(step)
                return
            world.carry_out(step)
            read = self._channels if _reads(step) else ""
            key = _key((key, type(step).__name__, _BITS[type(step)](step), *_pass(step.origin), read))
            self.steps.append(step)
            self._keys.append(key)

    def is_known(self, number: int) -> bool:
        """Return whether the continuation after the steps up to this one is known."""
        return not self._is_cut or number + 1 < len(self.steps)

    def key_behind(self, number: int) -> str:
        """Return the key of the steps up to this one and of the known effect of the next one."""
        behind = self.steps[number + 1] if number + 1 < len(self.steps) else None
        return _key((self._keys[number], type(behind).__name__, getattr(behind, "before", "")))

    def ends(self) -> Mapping[int, int]:
        """Return by line the last step that is known when the last instruction of the line is planned."""
        found: dict[int, int] = {}
        end = horizon = -1
        for number, step in enumerate(self.steps):
            if number > end:
                end = self._end_of_sequence(number)
                horizon = max(horizon, self._horizon(number, end))
            place = step.origin.span
            if isinstance(step, _TAKING_TIME) and place is not None and place.source == self._program.source:
                found[place.line] = horizon
        return found

    def _end_of_sequence(self, number: int) -> int:
        """Return the last step of the sequence that begins with a step."""
        while _flows(self.steps[number]) and number + 1 < len(self.steps):
            behind = self.steps[number + 1]
            if not isinstance(behind, MoveInstruction | MessageInstruction):
                break
            number += 1
        return number

    def _horizon(self, first: int, end: int) -> int:
        """Return the last tool path behind the stop of a sequence that affects the choice of posture."""
        if not any(isinstance(one, MoveInstruction) and _is_ptp(one) for one in self.steps[first : end + 1]):
            return end
        while end + 1 < len(self.steps) and isinstance(self.steps[end], MoveInstruction | MessageInstruction):
            behind = self.steps[end + 1]
            is_path = isinstance(behind, MoveInstruction) and not _is_ptp(behind)
            if not (is_path or isinstance(behind, MessageInstruction)):
                break
            end += 1
        return end


def _pass(origin: Origin) -> tuple[object, ...]:
    """Return what findings say of the origin of a step besides its line."""
    point = origin.point
    return (origin.visit, point.list, point.number, point.source, point.line) if point else (origin.visit,)


def _is_look(step: Instruction) -> bool:
    """Return whether the program may branch on a value read at a step."""
    if isinstance(step, AwaitInstruction):
        return step.timeout is not None
    return isinstance(step, SyncInstruction) and step.before not in _UNSEEN


def _reads(step: Instruction) -> bool:
    """Return whether the value of a channel affects a step."""
    if isinstance(step, MoveInstruction):
        return step.guard is not None or step.tracking is not None
    return isinstance(step, AwaitInstruction)


def _flows(step: Instruction) -> bool:
    """Return whether more may be known of later steps before the arm begins with a step."""
    if isinstance(step, MessageInstruction):
        return True
    return isinstance(step, MoveInstruction) and (step.modal.zone > 0.0 or step.modal.passes)


def _is_ptp(move: MoveInstruction) -> bool:
    return move.kind == MotionKind.PTP


def _acting_lines(program: Program) -> set[int]:
    """Return the lines of the source at which the robot moves, grips or waits."""
    moving = _libraries_that_act(program)
    return {
        line
        for procedure in program.procedures
        for step, line in zip(procedure.code, procedure.lines, strict=True)
        if line and (_acts(step.mnemonic) or (step.mnemonic == "CALL" and str(step.operands[0]) in moving))
    }


def _libraries_that_act(program: Program) -> frozenset[str]:
    """Return the procedures without lines of the source that act, themselves or through callees."""
    callers: dict[str, list[str]] = {}
    waiting = []
    for one in program.procedures:
        if any(one.lines):
            continue
        for step in one.code:
            if step.mnemonic == "CALL":
                callers.setdefault(str(step.operands[0]), []).append(one.name)
        if any(_acts(step.mnemonic) for step in one.code):
            waiting.append(one.name)
    found = set(waiting)
    while waiting:
        new = set(callers.get(waiting.pop(), ())) - found
        found |= new
        waiting.extend(new)
    return frozenset(found)


def _acts(mnemonic: str) -> bool:
    return OPCODES[mnemonic].is_move or mnemonic in {"GRIP", "WAIT.T", "WAIT.IN"}


def _key(content: object) -> str:
    return sha256(repr(content).encode("utf-8", "surrogatepass")).hexdigest()[:_DIGITS]
