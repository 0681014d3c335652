"""Prepares a verified program for the machine: names become indices, words become handlers."""

from typing import NamedTuple

from ropsim.icr.machine.geometry import GEOMETRY, get_component, set_component, shown
from ropsim.icr.machine.handlers import (
    HANDLERS,
    Datum,
    Handler,
    load_global,
    load_local,
    store_global,
    store_local,
)
from ropsim.icr.machine.location import FrameTag
from ropsim.icr.machine.operations import OPERATIONS
from ropsim.icr.machine.site import Site
from ropsim.icr.program import PoseList, Procedure, Program, Step, source_place
from ropsim.icr.rules.flow import stacks
from ropsim.icr.rules.stack import Stack
from ropsim.icr.types import Constant, Type, rotation
from ropsim.spatial import Pose, quaternion

_TYPED = frozenset(("GETC", "SETC", "FMT"))
"""Operations that depend on the types of their operands."""
_JUMPS = frozenset(("JMP", "JF", "JT"))
LEAVE = -1
"""Return value of the handler of an operation: no index of an instruction."""


class LoadedProcedure(NamedTuple):
    """A procedure ready to run: handlers with their operands, and how many variables it has."""

    name: str
    code: list[tuple[Handler, Datum]]
    variables: int


def load(program: Program, shared: list[Datum]) -> list[LoadedProcedure]:
    """Return the procedures ready to run; their code refers to `shared`, the list of global variables."""
    return [
        LoadedProcedure(one.name, _code(program, one, number, shared), len(one.variables))
        for number, one in enumerate(program.procedures)
    ]


def _code(
    program: Program, procedure: Procedure, number: int, shared: list[Datum]
) -> list[tuple[Handler, Datum]]:
    needs_types = any(step.mnemonic in _TYPED for step in procedure.code)
    types = stacks(program, procedure) if needs_types else ()
    code: list[tuple[Handler, Datum]] = []
    for index, step in enumerate(procedure.code):
        if step.mnemonic in {"LOAD", "STORE"}:
            code.append(_variable(program, procedure, step, shared))
        elif step.mnemonic in _TYPED:
            code.append(_typed(step, types[index]))
        elif step.mnemonic in OPERATIONS:
            place = source_place(program, procedure, index)
            operand = _operand(program, step)
            if step.mnemonic == "SYNC":  # it has its purpose as operand
                operand = procedure.code[index + 1].mnemonic
            site = Site(OPERATIONS[step.mnemonic], step.mnemonic, operand, (number, index), place)
            code.append((_leave, site))
        else:
            handler = HANDLERS.get(step.mnemonic) or GEOMETRY[step.mnemonic]
            operand = step.operands[0] if step.operands else None
            datum = _value(operand) if isinstance(operand, Constant) else operand
            if step.mnemonic in _JUMPS:
                datum = operand, index + 1
            elif step.mnemonic == "ITEM":
                datum = _list(program, str(operand)), _poses(program, str(operand))
            elif step.mnemonic == "INFRAME":
                datum = _frame(program, operand) if operand else None
            code.append((handler, datum))
    return code


def _leave(_stack: list[Datum], _values: list[Datum], _site: Datum) -> int:
    return LEAVE


def _variable(
    program: Program, procedure: Procedure, step: Step, shared: list[Datum]
) -> tuple[Handler, Datum]:
    is_load = step.mnemonic == "LOAD"
    name = str(step.operands[0])
    if name in procedure.numbers:
        return (load_local if is_load else store_local), procedure.numbers[name]
    return (load_global if is_load else store_global), (shared, program.numbers[name])


def _typed(step: Step, stack: Stack) -> tuple[Handler, Datum]:
    if step.mnemonic == "FMT":
        return shown, stack[-1]
    if step.mnemonic == "GETC":
        return get_component, (step.operands[0], stack[-1])
    return set_component, (step.operands[0], stack[-2])


def _value(constant: Constant) -> Datum:
    quaternion_part = rotation(constant)
    if not quaternion_part or not isinstance(constant.value, tuple):
        return constant.value
    w, x, y, z = quaternion_part
    at = 3 if constant.type is Type.POSE else 0
    return (*constant.value[:at], *quaternion.unit((w, x, y, z)), *constant.value[at + 4 :])


def _poses(program: Program, name: str) -> tuple[Datum, ...]:
    """Return the poses of a list."""
    return tuple([_value(Constant(Type.POSE, pose)) for pose in _list(program, name).poses])


def _list(program: Program, name: str) -> PoseList:
    return next(one for one in program.lists if one.name == name)


def _frame(program: Program, name: Datum) -> FrameTag:
    """Return a task frame with its nominal pose; without a name the base frame."""
    pose = next((Pose.from_tuple(one.pose) for one in program.frames if one.name == name), Pose())
    return FrameTag(str(name), pose)


def _operand(program: Program, step: Step) -> Datum:
    name = step.operands[0] if step.operands else None
    if step.mnemonic == "CALL":
        index = program.procedure_numbers[str(name)]
        callee = program.procedures[index]
        return index, callee.name, len(callee.parameters), len(callee.locals)
    if step.mnemonic == "MOVE.SPL.L":
        return _poses(program, str(name))
    if step.mnemonic == "FRAME":
        return _frame(program, name)
    if step.mnemonic == "TOOL":
        poses = {one.name: one.pose for one in program.tools}
        pose = poses[str(name)] if name else Pose().as_tuple()
        return name, None if pose is None else Pose.from_tuple(pose)
    if step.mnemonic == "IN":
        channel = program.channel(str(name))
        return name, channel.type if channel else None
    return step.operands if len(step.operands) > 1 else name
