"""Stack effects: the effect of each instruction on the types on the stack (rule V4)."""

from typing import NamedTuple

from ropsim.core import Kind
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import OPCODES
from ropsim.icr.program import Procedure, Program, Step
from ropsim.icr.types import Constant, Type

Stack = tuple[Type, ...]


class Fault(NamedTuple):
    """Why an instruction cannot follow: a kind of diagnostic and its words."""

    kind: Kind
    message: str
    hint: str = ""


def variable_type(program: Program, procedure: Procedure, name: str) -> Type:
    """Return the type of a declared variable; a local one hides a global one."""
    number = procedure.numbers.get(name)
    return (program.variables[program.numbers[name]] if number is None else procedure.variables[number]).type


def effect(program: Program, procedure: Procedure, step: Step, stack: Stack) -> Stack | Fault:
    """Return the stack after an instruction whose operands are in order (rules V2, V3), or a fault."""
    opcode = OPCODES[step.mnemonic]
    if opcode.mnemonic in {"DUP", "POP", "SWAP"}:
        return _shuffle(step.mnemonic, stack)
    if opcode.mnemonic in {"GETC", "SETC"}:
        return _component(program, step, stack)
    if opcode.mnemonic == "FMT":
        rest = _take(step, stack, stack[-1:] or (Type.STR,))
        return rest if isinstance(rest, Fault) else (*rest, Type.STR)
    if opcode.mnemonic == "RET":
        return _return(procedure, stack)
    pops, pushes = opcode.pops, opcode.pushes
    if pops is None or pushes is None:
        pops, pushes = _by_operand(program, procedure, step)
    rest = _take(step, stack, pops)
    return rest if isinstance(rest, Fault) else rest + pushes


def _by_operand(program: Program, procedure: Procedure, step: Step) -> tuple[Stack, Stack]:
    """Return pops and pushes of the instructions whose effect follows from the operand."""
    operand = step.operands[0]
    if isinstance(operand, Constant):
        return (), (operand.type,)
    if step.mnemonic == "MKJ":
        return (Type.REAL,) * int(operand), (Type.JOINTS,)
    if step.mnemonic == "MKEXT":
        return (Type.POSE, *(Type.REAL,) * int(operand)), (Type.POSE,)
    if step.mnemonic == "TURNS":
        return (Type.POSE, *(Type.INT,) * int(operand)), (Type.POSE,)
    if step.mnemonic == "MOVE.SPL":
        return (Type.POSE,) * int(operand), ()
    name = str(operand)
    if step.mnemonic in {"LOAD", "STORE"}:
        found: Stack = (variable_type(program, procedure, name),)
        return ((), found) if step.mnemonic == "LOAD" else (found, ())
    if step.mnemonic == "CALL":
        callee = program.procedure(name)
        return (tuple(one.type for one in callee.parameters), callee.results) if callee else ((), ())
    channel = program.channel(str(step.operands[-1]))
    found = (channel.type,) if channel else ()
    if step.mnemonic in {"TRIG.DIST", "TRIG.TIME", "GUARD"}:
        return (*found, Type.REAL), ()
    return ((), found) if step.mnemonic == "IN" else (found, ())


def _take(step: Step, stack: Stack, wanted: Stack) -> Stack | Fault:
    if len(stack) < len(wanted):
        message = f"`{step.mnemonic}` takes {len(wanted)} values, the stack holds {len(stack)}"
        return Fault(kinds.STACK_TOO_SHORT, message)
    rest = stack[: len(stack) - len(wanted)]
    found = stack[len(rest) :]
    if found != wanted:
        message = f"`{step.mnemonic}` found [{_shown(found)}], allowed is [{_shown(wanted)}]"
        hint = "convert with `I2R`" if _differ_by_number(found, wanted) else ""
        return Fault(kinds.STACK_TYPE_WRONG, message, hint)
    return rest


def _shuffle(mnemonic: str, stack: Stack) -> Stack | Fault:
    need = 2 if mnemonic == "SWAP" else 1
    if len(stack) < need:
        return Fault(kinds.STACK_TOO_SHORT, f"`{mnemonic}` takes {need} values, the stack holds {len(stack)}")
    if mnemonic == "DUP":
        return (*stack, stack[-1])
    return stack[:-1] if mnemonic == "POP" else (*stack[:-2], stack[-1], stack[-2])


def _component(program: Program, step: Step, stack: Stack) -> Stack | Fault:
    values = (Type.REAL,) if step.mnemonic == "SETC" else ()
    rest = _take(step, stack, values)
    if isinstance(rest, Fault):
        return rest
    if not rest:
        return Fault(kinds.STACK_TOO_SHORT, f"`{step.mnemonic}` needs a composite value below")
    sizes = {Type.VEC: 3, Type.ORI: 3, Type.POSE: 6, Type.JOINTS: program.axes or 0}
    size = sizes.get(rest[-1])
    if size is None:
        message = f"`{step.mnemonic}` found {rest[-1].value}, allowed are VEC, ORI, POSE, JOINTS"
        return Fault(kinds.STACK_TYPE_WRONG, message)
    index = step.operands[0]
    if isinstance(index, int) and index >= size:
        message = f"`{step.mnemonic}` has index {index}, {rest[-1].value} has components 0 to {size - 1}"
        return Fault(kinds.OPERAND_WRONG, message)
    return rest if step.mnemonic == "SETC" else (*rest[:-1], Type.REAL)


def _return(procedure: Procedure, stack: Stack) -> Stack | Fault:
    if stack == procedure.results:
        return ()
    message = (
        f"`RET` in `{procedure.name}` leaves [{_shown(stack)}], declared is [{_shown(procedure.results)}]"
    )
    return Fault(kinds.RESULTS_DIFFER, message)


def _differ_by_number(found: Stack, wanted: Stack) -> bool:
    pairs = [pair for pair in zip(found, wanted, strict=True) if pair[0] != pair[1]]
    return all(pair == (Type.INT, Type.REAL) for pair in pairs)


def _shown(stack: Stack) -> str:
    return " ".join(one.value for one in stack)
