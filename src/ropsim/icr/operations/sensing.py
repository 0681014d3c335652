"""Operations of moves that end by a condition, and of the pose that the arm has."""

from ropsim.flow import Comparison, Guard, Instruction
from ropsim.icr import trap_kinds as kinds
from ropsim.icr.site import Operation, Site, barrier
from ropsim.icr.state import Registers
from ropsim.icr.traps import TrapError
from ropsim.icr.world import World


def _guard(registers: Registers, _world: World, site: Site) -> None:
    comparison, channel = site.operand
    timeout = registers.stack.pop()
    value = registers.stack.pop()
    compared = Comparison(comparison)
    wanted = value if compared is Comparison.IS else float(value)
    registers.guard = Guard(channel, compared, wanted, timeout if timeout > 0.0 else None)


def _met(registers: Registers, world: World, site: Site) -> Instruction | None:
    if (sync := barrier(registers, site)) is not None:
        return sync
    registers.stack.append(bool(world.met()))
    return None


def _attained(registers: Registers, world: World, site: Site) -> Instruction | None:
    if (sync := barrier(registers, site)) is not None:
        return sync
    X_KT = world.attained(registers.modal)
    if X_KT is None:
        raise TrapError(kinds.POSE_UNKNOWN, "where the arm is now is not known", "move to a pose before")
    registers.stack.append(X_KT.as_tuple())
    return None


SENSING: dict[str, Operation] = {"GUARD": _guard, "MET": _met, "ATTAINED": _attained}
"""Mnemonic -> operation."""
