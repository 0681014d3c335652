"""A dry run: without a robot, all instructions that a program would hand to one."""

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.flow import (
    GripInstruction,
    Instruction,
    MessageInstruction,
    MoveInstruction,
    OutputInstruction,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr.errors import UnverifiedError
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.machine import BUDGET, Machine, MachineOptions
from ropsim.icr.machine.state import Finished
from ropsim.icr.machine.world import StillWorld, World
from ropsim.icr.program import Program
from ropsim.icr.rules.verifier import verify

MAX_INSTRUCTIONS = 100_000
"""Robot instructions and synchronisations after which a dry run ends (about 100 MB)."""


@frozen_dataclass
class DryRun:
    """Result of a run without a robot.

    Attributes:
        instructions: robot instructions in program order, without synchronisations.
        trap: why it ended early, or None.
        steps: ICR instructions carried out.
        stop: category of the STOP that ended it, or None.
    """

    instructions: tuple[Instruction, ...]
    trap: Diagnostic | None
    steps: int
    stop: int | None = None

    @property
    def moves(self) -> tuple[MoveInstruction, ...]:
        """Return the moves."""
        return tuple(one for one in self.instructions if isinstance(one, MoveInstruction))

    @property
    def grips(self) -> tuple[GripInstruction, ...]:
        """Return the gripper actions."""
        return tuple(one for one in self.instructions if isinstance(one, GripInstruction))

    @property
    def io(self) -> tuple[OutputInstruction | WaitInstruction, ...]:
        """Return outputs and waits."""
        return tuple(one for one in self.instructions if isinstance(one, OutputInstruction | WaitInstruction))

    @property
    def messages(self) -> tuple[str, ...]:
        """Return the texts shown to the operator."""
        return tuple(one.text for one in self.instructions if isinstance(one, MessageInstruction))


def run(program: Program, world: World | None = None, budget: int = BUDGET) -> DryRun:
    """Verify a program and run it to its end.

    Args:
        program: any program.
        world: inputs and time; a `StillWorld` whose inputs are all FALSE or 0 where it is None.
        budget: ICR instructions after which trap BUDGET ends the run; it also ends after
            `MAX_INSTRUCTIONS` robot instructions.

    Raises:
        UnverifiedError: the verifier refuses the program; carries all diagnostics.
    """
    found = verify(program)
    if found:
        raise UnverifiedError(found)
    return run_verified(program, world, budget)


def run_verified(program: Program, world: World | None = None, budget: int = BUDGET) -> DryRun:
    """Run a program without findings of the verifier, such as a compiled one; see `run`."""
    world = world or StillWorld()
    machine = Machine(program, world, MachineOptions(budget))
    instructions: list[Instruction] = []
    place: Span | None = None
    for _ in range(MAX_INSTRUCTIONS):
        outcome = machine.advance()
        if isinstance(outcome, Finished):
            return DryRun(tuple(instructions), outcome.trap, outcome.steps, outcome.stop)
        place = outcome.origin.span
        if isinstance(world, StillWorld):
            world.carry_out(outcome)
        if not isinstance(outcome, SyncInstruction):
            instructions.append(outcome)
    message = f"more than {MAX_INSTRUCTIONS} robot instructions and synchronisations"
    trap = kinds.BUDGET.at(place, message, hint="look for a loop without end near this line")
    return DryRun(tuple(instructions), trap, machine.snapshot().steps)
