"""Result of an arithmetic instruction for given operands, for constant folding."""

from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.handlers import HANDLERS
from ropsim.icr.machine.traps import TrapError
from ropsim.icr.types import Value


def computed(mnemonic: str, *operands: Value) -> Value:
    """Return the value that the instruction pushes: the result of the machine, bit for bit.

    Args:
        mnemonic: of an instruction that uses only the stack, such as `ADD.R`.
        operands: as they lie on the stack, the uppermost last, of the types that it takes.

    Raises:
        ZeroDivisionError: the machine would end the program by the trap DIV0.
        ArithmeticError: the instruction would trap, as the message says.
    """
    stack = list(operands)
    try:
        HANDLERS[mnemonic](stack, [], None)
    except TrapError as trap:
        kind = ZeroDivisionError if trap.kind is kinds.DIV0 else ArithmeticError
        raise kind(trap.message) from None
    return stack[0]
