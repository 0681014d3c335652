"""What a task program comes to in the machine: what it says, how it ends, what its variables hold."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim import icr
from ropsim.flow import MessageInstruction, MoveInstruction
from ropsim.language import Environment
from support.tasks import CELL, compiled

BUDGET = 200_000


@dataclass(frozen=True, slots=True)
class Outcome:
    """The end of a run.

    Attributes:
        says: what `print` has shown, in order.
        moves: the moves, in order.
        trap: code and line of the trap, None where the program came to its end.
        values: the variables of the control statements by name, None where one has no value yet.
    """

    says: tuple[str, ...]
    moves: tuple[MoveInstruction, ...]
    trap: tuple[str, int] | None
    values: Mapping[str, object]


def outcome(
    text: str,
    inputs: Mapping[str, bool | int | float] | None = None,
    environment: Environment = CELL,
    arm: icr.Arm | None = None,
) -> Outcome:
    """Compile a program that has no errors, verify and run it."""
    result = compiled(text, environment)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    assert icr.verify(result.icr) == ()
    return of_code(result.icr, icr.StillWorld(inputs or {}, arm))


def of_code(code: icr.Program, world: icr.StillWorld) -> Outcome:
    """Run verified code."""
    machine = icr.Machine(code, world, icr.MachineOptions(BUDGET))
    says: list[str] = []
    moves: list[MoveInstruction] = []
    while not isinstance(step := machine.advance(), icr.Finished):
        world.carry_out(step)
        if isinstance(step, MessageInstruction):
            says.append(step.text)
        if isinstance(step, MoveInstruction):
            moves.append(step)
    names = [variable.name for variable in code.variables]
    values = dict(zip(names, machine.snapshot().shared, strict=True))
    trap = step.trap
    line = trap.span.line if trap is not None and trap.span is not None else 0
    return Outcome(tuple(says), tuple(moves), None if trap is None else (trap.code, line), values)
