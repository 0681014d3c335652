"""One place in loaded code where the machine reaches beyond the stack."""

from collections.abc import Callable
from typing import NamedTuple

from ropsim.core import Span
from ropsim.flow import Instruction, SyncInstruction
from ropsim.icr.machine.handlers import Datum
from ropsim.icr.machine.state import Finished, Registers
from ropsim.icr.machine.world import World


class Site(NamedTuple):
    """One instruction of this family in loaded code.

    Attributes:
        run: the operation.
        mnemonic: word of the instruction.
        operand: prepared operand.
        key: (procedure, instruction).
        span: source line.
    """

    run: "Operation"
    mnemonic: str
    operand: Datum
    key: tuple[int, int]
    span: Span | None


Operation = Callable[[Registers, World, Site], Instruction | Finished | None]
"""Returns the instruction that the machine hands to its consumer, or None if the machine continues."""


def barrier(registers: Registers, site: Site) -> SyncInstruction | None:
    """Return a SyncInstruction the first time; the second time return None: the instruction may run."""
    if registers.is_synced:
        registers.is_synced = False
        return None
    registers.is_synced = True
    registers.pc -= 1
    registers.steps -= 1
    return SyncInstruction(registers.modal, registers.origin(site.key, site.span), before=site.mnemonic)
