"""The stack machine: carries out a verified program and hands out its robot instructions one by one."""

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import Instruction
from ropsim.icr import trap_kinds as kinds
from ropsim.icr.loader import load
from ropsim.icr.program import Program, source_place
from ropsim.icr.state import CodePlace, Finished, MachineState, Registers
from ropsim.icr.traps import TrapError, diagnostic
from ropsim.icr.world import World

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
    reads anything that depends on time (`IN`, `WAIT.IN`, `TIME`, `CURPOSE`) and before `STOP`, it returns a
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

        Between two jumps instructions are counted by their indices: whether there were too many is looked at
        behind the last of them. None of these has been told to anybody.
        """
        procedures, world, budget = self._procedures, self._world, self._options.budget
        code, values, stack = procedures[registers.procedure].code, registers.values, registers.stack
        pc, steps = registers.pc, registers.steps
        start = pc  # up to which `steps` counts
        try:
            while True:
                handler, operand = code[pc]
                pc += 1
                target = handler(stack, values, operand)
                if target is None:
                    continue
                if steps + pc - start > budget:
                    break
                steps += pc - start
                if target >= 0:
                    pc = start = target
                    continue
                registers.pc, registers.steps, start = pc, steps, pc
                outcome: Instruction | Finished | None = operand.run(registers, world, operand)
                if outcome is not None:
                    return outcome
                code, values = procedures[registers.procedure].code, registers.values
                pc = start = registers.pc
        except TrapError as trap:
            if (done := steps + pc - start) <= budget:
                return self._ended(registers, trap, pc - 1, done)
        message = f"{budget} instructions carried out, allowed are {budget}"
        spent = TrapError(kinds.BUDGET, message, "look for a loop without end near this line")
        return self._ended(registers, spent, start + budget - steps, budget)

    def _ended(self, registers: Registers, trap: TrapError, index: int, steps: int) -> Finished:
        registers.pc, registers.steps = index, steps
        place = registers.place(self._place(registers.procedure, index))
        return Finished(diagnostic(trap, place, registers.calls, registers.call_serials), steps)

    def _place(self, procedure: int, index: int) -> Span | None:
        return source_place(self._program, self._program.procedures[procedure], index)
