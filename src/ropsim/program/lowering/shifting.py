"""Code that is moved: its jumps lead to where their targets stand then."""

from ropsim.icr import Step

_JUMPS = frozenset(("JMP", "JF", "JT"))


def shifted(code: tuple[Step, ...], by: int) -> tuple[Step, ...]:
    """Return code that stands so many instructions further back than it was made for."""
    if not by:
        return code
    moved = list(code)
    for index, step in enumerate(code):
        target = step.operands[0] if step.mnemonic in _JUMPS else None
        if isinstance(target, int):
            moved[index] = Step(step.mnemonic, (target + by,))
    return tuple(moved)
