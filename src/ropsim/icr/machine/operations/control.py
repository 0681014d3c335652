"""Operations of control and flow: HALT, TRAP, CALL, RET."""

from ropsim.icr.machine.site import Operation, Site
from ropsim.icr.machine.state import Caller, Finished, Registers
from ropsim.icr.machine.traps import by_number
from ropsim.icr.machine.world import World


def _halt(registers: Registers, _world: World, _site: Site) -> Finished:
    return Finished(None, registers.steps)


def _trap(_registers: Registers, _world: World, site: Site) -> None:
    raise by_number(site.operand)


def _call(registers: Registers, _world: World, site: Site) -> None:
    """The operand is (index, name, number of parameters, number of other locals)."""
    index, name, parameters, others = site.operand
    stack = registers.stack
    cut = len(stack) - parameters
    place = registers.place(site.span)
    registers.callers.append(Caller(registers.procedure, registers.pc, tuple(registers.values), place))
    registers.values = [*stack[cut:], *[None] * others]
    del stack[cut:]
    registers.procedure, registers.pc = index, 0
    registers.activations += 1
    registers.calls = (*registers.calls, name)
    registers.call_serials = (*registers.call_serials, registers.activations)


def _return(registers: Registers, _world: World, _site: Site) -> Finished | None:
    if not registers.callers:
        return Finished(None, registers.steps)
    caller = registers.callers.pop()
    registers.procedure, registers.pc, registers.values = caller.procedure, caller.pc, list(caller.values)
    registers.calls, registers.call_serials = registers.calls[:-1], registers.call_serials[:-1]
    return None


CONTROL: dict[str, Operation] = {"HALT": _halt, "TRAP": _trap, "CALL": _call, "RET": _return}
"""Mnemonic -> operation."""
