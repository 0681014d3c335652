"""How an instruction signals the machine that the program cannot go on."""

from collections.abc import Sequence

from ropsim.core import Diagnostic, Kind, Span
from ropsim.icr.machine import trap_kinds as kinds


class TrapError(Exception):
    """Internal to the machine: becomes the diagnostic of the trap, never leaves it."""

    def __init__(self, kind: Kind, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.kind = kind
        self.message = message
        self.hint = hint


def division_by_zero() -> TrapError:
    """Return the trap of a divisor 0."""
    return TrapError(kinds.DIV0, "division by zero", "test the divisor before")


def out_of_range(message: str, hint: str = "") -> TrapError:
    """Return the trap of a value outside its domain."""
    return TrapError(kinds.RANGE, message, hint)


def by_number(number: int) -> TrapError:
    """Return the trap of `TRAP number`."""
    if number == kinds.TRAP_TIMED_OUT:
        return TrapError(
            kinds.IO_TIMEOUT, "the condition did not hold in time", "say what to do then (`else`)"
        )
    if number == kinds.TRAP_NOT_WHOLE:
        return out_of_range("the repeat count is not a whole number", "round it")
    return TrapError(kinds.USER, f"the program ended itself by `TRAP {number}`")


def diagnostic(
    trap: TrapError, place: Span | None, calls: Sequence[str], serials: Sequence[int]
) -> Diagnostic:
    """Return the diagnostic of a trap: place in the source and chain of active procedures."""
    notes = (f"active procedures: {' -> '.join(calls)}",) if len(calls) > 1 else ()
    data = {"calls": tuple(calls), "call_serials": tuple(serials)}
    return trap.kind.at(place, trap.message, hint=trap.hint, notes=notes, data=data)
