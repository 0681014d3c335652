"""What an arithmetic instruction makes of given operands, for whoever computes ahead of the machine."""

from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.handlers import HANDLERS
from ropsim.icr.machine.traps import TrapError
from ropsim.icr.types import Value


def computed(mnemonic: str, *operands: Value) -> Value:
    """Return what the instruction leaves on the stack: the machine's own answer, bit for bit.

    Args:
        mnemonic: of an instruction that touches nothing but the stack, such as `ADD.R`.
        operands: as they lie on the stack, the uppermost last, of the types that it takes.

    Raises:
        ZeroDivisionError: the machine would end the program by the trap DIV0.
        ArithmeticError: it would end it by another trap, which the message tells.
    """
    stack = list(operands)
    try:
        HANDLERS[mnemonic](stack, [], None)
    except TrapError as trap:
        kind = ZeroDivisionError if trap.kind is kinds.DIV0 else ArithmeticError
        raise kind(trap.message) from None
    return stack[0]
