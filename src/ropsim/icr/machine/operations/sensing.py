"""Operations of moves that a signal ends or corrects, and of the pose that the arm has."""

from ropsim.flow import Comparison, Guard, Instruction, PathTracking, ToolDirection
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.site import Operation, Site, barrier
from ropsim.icr.machine.state import Registers
from ropsim.icr.machine.traps import TrapError, out_of_range
from ropsim.icr.machine.world import World
from ropsim.icr.rules.operands import setting_fault


def _guard(registers: Registers, _world: World, site: Site) -> None:
    comparison, channel = site.operand
    timeout = registers.stack.pop()
    value = registers.stack.pop()
    compared = Comparison(comparison)
    wanted = value if compared is Comparison.IS else float(value)
    registers.guard = Guard(channel, compared, wanted, timeout if timeout > 0.0 else None)


def _track(registers: Registers, _world: World, site: Site) -> None:
    direction, channel = site.operand
    gain = registers.stack.pop()
    value = registers.stack.pop()
    if fault := setting_fault(site.mnemonic, gain):
        raise out_of_range(fault)
    registers.tracking = PathTracking(channel, value, ToolDirection(direction), gain)


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


SENSING: dict[str, Operation] = {"GUARD": _guard, "TRACK": _track, "MET": _met, "ATTAINED": _attained}
"""Mnemonic -> operation."""
