"""The stack machine: carries out a verified program and hands out its robot instructions one by one."""

from collections.abc import Iterator
from operator import length_hint
from typing import Protocol, cast

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import Instruction
from ropsim.icr.errors import UnverifiedError
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.handlers import Datum, Handler
from ropsim.icr.machine.loader import load
from ropsim.icr.machine.state import CodePlace, Finished, MachineState, Registers
from ropsim.icr.machine.traps import TrapError, diagnostic
from ropsim.icr.machine.world import World
from ropsim.icr.program import Program, source_place
from ropsim.icr.rules.verifier import verify

BUDGET = 10_000_000


@frozen_dataclass
class MachineOptions:
    """How a program is run.

    Attributes:
        budget: number of ICR instructions after which trap BUDGET ends the run.
    """

    budget: int = BUDGET


class Machine:
    """A run of one program.

    `advance` returns robot instructions in program order, running ahead of the robot. Before the machine
    reads anything that depends on time (`IN`, `WAIT.IN`, `TIME`, `ATTAINED`) and before `STOP`, it returns a
    SyncInstruction; by the next call of `advance` the consumer promises that everything before has been
    carried out.

    Args:
        program: verified; see `verify`.
        world: inputs and time.
        options: limits.
    """

    def __init__(self, program: Program, world: World, options: MachineOptions | None = None) -> None:
        self._program = program
        self._world = world
        self._options = options or MachineOptions()
        shared: list[object] = [None] * len(program.variables)
        self._procedures = load(program, shared)
        start = next(k for k, one in enumerate(self._procedures) if one.name == "main")
        self._registers = Registers(start, [None] * self._procedures[start].variables, shared)

    @classmethod
    def resume(
        cls, program: Program, world: World, state: MachineState, options: MachineOptions | None = None
    ) -> "Machine":
        """Return a machine that goes on from a snapshot of a run of the same program."""
        machine = cls(program, world, options)
        machine._registers.restore(state)
        return machine

    def snapshot(self) -> MachineState:
        """Return the state between two calls of `advance`."""
        return self._registers.snapshot()

    @property
    def code_place(self) -> CodePlace:
        """Return where the program is between two calls of `advance`."""
        registers = self._registers
        callers = tuple((one.procedure, one.pc) for one in registers.callers)
        return CodePlace(callers, registers.procedure, registers.pc)

    def advance(self) -> Instruction | Finished:
        """Return the next robot instruction, or how the program ended (then always the same)."""
        registers = self._registers
        if registers.finished is not None:
            return registers.finished
        outcome = self._run(registers)
        if isinstance(outcome, Finished):
            registers.finished = outcome
        return outcome

    def _run(self, registers: Registers) -> Instruction | Finished:
        """Carry out instructions to the next one that the robot or the world has to do with.

        Between two jumps instructions are counted by their indices: their number is checked behind the last
        of them. None of these has an effect outside. A jump sets the iterator of the code to its target,
        which takes half the time of counting the index of every instruction.
        """
        procedures, world, budget = self._procedures, self._world, self._options.budget
        code, values, stack = procedures[registers.procedure].code, registers.values, registers.stack
        start, steps = registers.pc, registers.steps  # `steps` counts up to `start`
        following = _following(code, start)
        try:
            while True:
                for handler, operand in following:
                    target = handler(stack, values, operand)
                    if target is None:
                        continue
                    done = steps - start + (operand[1] if target >= 0 else operand.key[1] + 1)
                    if done > budget:
                        return self._spent(registers, start + budget - steps)
                    if target >= 0:
                        following.__setstate__(target)
                        start, steps = target, done
                        continue
                    registers.pc = start = operand.key[1] + 1
                    registers.steps = steps = done
                    outcome: Instruction | Finished | None = operand.run(registers, world, operand)
                    if outcome is not None:
                        return outcome
                    break
                else:  # as only a program that the verifier refuses can
                    raise UnverifiedError(verify(self._program))
                code, values = procedures[registers.procedure].code, registers.values
                start = registers.pc
                following = _following(code, start)
        except TrapError as trap:
            index = len(code) - length_hint(following) - 1
            if (done := steps + index + 1 - start) <= budget:
                return self._ended(registers, trap, index, done)
        return self._spent(registers, start + budget - steps)

    def _spent(self, registers: Registers, index: int) -> Finished:
        budget = self._options.budget
        message = f"{budget} instructions carried out, allowed are {budget}"
        spent = TrapError(kinds.BUDGET, message, "look for a loop without end near this line")
        return self._ended(registers, spent, index, budget)

    def _ended(self, registers: Registers, trap: TrapError, index: int, steps: int) -> Finished:
        registers.pc, registers.steps = index, steps
        place = registers.place(self._place(registers.procedure, index))
        return Finished(diagnostic(trap, place, registers.calls, registers.call_serials), steps)

    def _place(self, procedure: int, index: int) -> Span | None:
        return source_place(self._program, self._program.procedures[procedure], index)


class _Following(Iterator[tuple[Handler, Datum]], Protocol):
    """An iterator of a list, which can be set to an index of it."""

    def __setstate__(self, index: int, /) -> None:
        """Go on at an index."""

    def __length_hint__(self) -> int:
        """Return how many instructions follow."""
        ...


def _following(code: list[tuple[Handler, Datum]], index: int) -> _Following:
    """Return the instructions from an index on."""
    found = cast(_Following, iter(code))
    found.__setstate__(index)
    return found
