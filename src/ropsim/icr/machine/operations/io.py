"""Operations of inputs, outputs, time and messages."""

from ropsim.flow import AwaitInstruction, Instruction, MessageInstruction, OutputInstruction, WaitInstruction
from ropsim.icr.machine import trap_kinds as kinds
from ropsim.icr.machine.site import Operation, Site, barrier
from ropsim.icr.machine.state import Registers
from ropsim.icr.machine.traps import TrapError, out_of_range
from ropsim.icr.machine.world import World
from ropsim.icr.rules.operands import setting_fault
from ropsim.icr.types import Type


def _input(registers: Registers, world: World, site: Site) -> Instruction | None:
    if (sync := barrier(registers, site)) is not None:
        return sync
    name, kind = site.operand
    value = world.read(name)
    try:
        number = float(value)
    except OverflowError:
        number = float("inf")
    if number - number != 0.0:
        raise out_of_range(f"channel `{name}` reads {value!r}, only finite numbers are allowed")
    registers.stack.append(bool(value) if kind is Type.BOOL else int(value) if kind is Type.INT else number)
    return None


def _output(registers: Registers, _world: World, site: Site) -> Instruction:
    value = registers.stack.pop()
    return OutputInstruction(site.operand, value, registers.modal, registers.origin(site.key, site.span))


def _wait_time(registers: Registers, _world: World, site: Site) -> Instruction:
    duration = registers.stack.pop()
    if fault := setting_fault(site.mnemonic, duration):
        raise out_of_range(fault)
    return WaitInstruction(duration, registers.modal, registers.origin(site.key, site.span))


def _wait_input(registers: Registers, world: World, site: Site) -> Instruction | None:
    value, timeout = registers.stack[-2:]
    limit = timeout if timeout > 0.0 else None
    if (sync := barrier(registers, site)) is not None:
        return AwaitInstruction(sync.modal, sync.origin, site.operand, value, limit)
    del registers.stack[-2:]
    came = world.wait(site.operand, value, limit)
    if not came and timeout <= 0.0:
        level = "TRUE" if value else "FALSE"
        message = f"channel `{site.operand}` never became {level}, and the wait has no timeout"
        raise TrapError(
            kinds.IO_TIMEOUT, message, "give the wait a timeout, or set the input in the scenario"
        )
    registers.stack.append(bool(came))
    return None


def _time(registers: Registers, world: World, site: Site) -> Instruction | None:
    if (sync := barrier(registers, site)) is not None:
        return sync
    registers.stack.append(float(world.time()))
    return None


def _message(registers: Registers, _world: World, site: Site) -> Instruction:
    text = registers.stack.pop()
    return MessageInstruction(text, registers.modal, registers.origin(site.key, site.span))


IO: dict[str, Operation] = {
    "IN": _input,
    "OUT": _output,
    "WAIT.T": _wait_time,
    "WAIT.IN": _wait_input,
    "TIME": _time,
    "MSG": _message,
}
"""Mnemonic -> operation."""
