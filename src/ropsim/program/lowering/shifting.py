"""Code that is moved: its jumps lead to where their targets stand then."""

from typing import cast

from ropsim.icr import Step

_new = tuple.__new__
"""Makes an instruction in half of the time of its class."""
_JUMPS = frozenset(("JMP", "JF", "JT"))


def jumps_in(code: tuple[Step, ...]) -> tuple[int, ...]:
    """Return which instructions of some code are jumps to others of it."""
    jumps = [index for index, step in enumerate(code) if step[0] in _JUMPS]
    return tuple(index for index in jumps if isinstance(code[index].operands[0], int))


def shifted(code: tuple[Step, ...], by: int, jumps: tuple[int, ...] | None = None) -> tuple[Step, ...]:
    """Return code moved back by a number of instructions.

    Args:
        code: the instructions.
        by: how many further back they stand.
        jumps: which of them are jumps, where that is known.
    """
    jumps = jumps_in(code) if jumps is None else jumps
    if not by or not jumps:
        return code
    moved = list(code)
    for index in jumps:
        mnemonic, (target, *_) = code[index]
        moved[index] = _new(Step, (mnemonic, (cast(int, target) + by,)))
    return tuple(moved)
