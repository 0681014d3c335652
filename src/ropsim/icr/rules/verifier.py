"""The static verifier: rules V1 to V9. A verified program ends only by HALT, RET, STOP or a typed trap."""

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import islice

from ropsim.core import Diagnostic, Span
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import OPCODES
from ropsim.icr.program import VERSION, PoseList, Procedure, Program, channel_fault, text_place
from ropsim.icr.rules.assignment import check_assignment
from ropsim.icr.rules.calls import check_calls
from ropsim.icr.rules.flow import check_reachability, check_stack
from ropsim.icr.rules.operands import MAX_AXES, check_constant, check_operands
from ropsim.icr.types import WIDTHS, Constant, Type

MAX_LISTED = 1_000_000
"""Poses that a list may have."""


def verify(program: Program) -> tuple[Diagnostic, ...]:
    """Return the diagnostics of all rules; empty where the program may run.

    A rule is checked only where the rules that it builds on hold, so one fault causes one diagnostic.
    """
    found = [*_header(program), *_declarations(program), *_requirements(program)]
    sound = []
    for procedure in program.procedures:
        faults = tuple(check_operands(program, procedure))
        found += faults
        if not faults:
            sound.append(procedure)
    for procedure in sound:
        found += check_reachability(program, procedure)
        found += check_stack(program, procedure) if procedure.code else ()
    if not found:
        found += check_calls(program)
    if not found:
        found += check_assignment(program)
    return tuple(found)


def capabilities(procedures: Iterable[Procedure]) -> tuple[str, ...]:
    """Return the required capabilities of a robot for these procedures, sorted."""
    pose, used = Type.POSE, set[str]()
    for procedure in procedures:
        used.update([mnemonic for mnemonic, _ in procedure.code])
        constants = [one for _, operands in procedure.code for one in operands if isinstance(one, Constant)]
        if any([one.type is pose and _carries_external(one) for one in constants]):
            used.add("MKEXT")
    offers = {OPCODES[mnemonic].capability for mnemonic in used if mnemonic in OPCODES}
    return tuple(sorted(offers - {""}))


def _carries_external(constant: Constant) -> bool:
    value = constant.value
    return isinstance(value, tuple) and len(value) > WIDTHS[Type.POSE]


def _header(program: Program) -> Iterator[Diagnostic]:
    place = program.declared_at.get("ICR")
    if program.version != VERSION:
        yield kinds.HEADER_WRONG.at(place, f"version `{program.version}` found, `{VERSION}` allowed")
    main = program.procedure("main")
    if main is None:
        yield kinds.MAIN_MISSING.at(place, "there is no procedure `main`", hint="add `PROC main`")
    elif main.parameters or main.results:
        place = program.declared_at.get("PROC main", place)
        message = (
            f"`main` has {len(main.parameters)} parameters and {len(main.results)} results, allowed: none"
        )
        yield kinds.MAIN_MISSING.at(place, message)


def _declarations(program: Program) -> Iterator[Diagnostic]:
    groups: tuple[tuple[str, list[str]], ...] = (
        ("VAR", [one.name for one in program.variables]),
        ("IO", [one.name for one in program.channels]),
        ("FRAMEDEF", [one.name for one in program.frames]),
        ("TOOLDEF", [one.name for one in program.tools]),
        ("LIST", [one.name for one in program.lists]),
        ("PROC", [one.name for one in program.procedures]),
        *((f"PROC {one.name}", [variable.name for variable in one.variables]) for one in program.procedures),
    )
    for record, names in groups:
        for name in sorted(name for name, times in Counter(names).items() if times > 1):
            place = program.declared_at.get(f"{record} {name}", program.declared_at.get(record))
            yield kinds.NAME_TWICE.at(place, f"`{record}` declares `{name}` twice")
        if "" in names:
            yield kinds.NAME_UNDECLARED.at(
                program.declared_at.get(record), f"`{record}` declares an empty name"
            )
    for channel in program.channels:
        if fault := channel_fault(channel):
            yield kinds.OPERAND_WRONG.at(program.declared_at.get(f"IO {channel.name}"), fault)
    for frame in program.frames:
        yield from _pose(
            frame.pose, program.declared_at.get(f"FRAMEDEF {frame.name}"), f"frame `{frame.name}`"
        )
    for tool in program.tools:
        if tool.pose is not None:
            yield from _pose(
                tool.pose, program.declared_at.get(f"TOOLDEF {tool.name}"), f"tool `{tool.name}`"
            )

    for one in program.lists:
        yield from _list(one, program.declared_at.get(f"LIST {one.name}"))


def _list(one: PoseList, place: Span | None) -> Iterator[Diagnostic]:
    """Yield that a list has no pose, or too many, and the first pose that is none."""
    if not 0 < len(one.poses) <= MAX_LISTED:
        message = f"list `{one.name}` has {len(one.poses)} poses, allowed are 1 to {MAX_LISTED}"
        yield kinds.OPERAND_WRONG.at(place, message)
    faults = (
        fault
        for number, pose in enumerate(one.poses, 1)
        for fault in _pose(pose, place, f"pose {number} of list `{one.name}`")
    )
    yield from islice(faults, 1)


def _pose(pose: tuple[float, ...], place: Span | None, what: str) -> Iterator[Diagnostic]:
    if len(pose) != WIDTHS[Type.POSE]:
        yield kinds.OPERAND_WRONG.at(place, f"{what} has {len(pose)} numbers, a pose has {WIDTHS[Type.POSE]}")
        return
    yield from check_constant(Constant(Type.POSE, pose), place, what)


def _requirements(program: Program) -> Iterator[Diagnostic]:
    place = program.declared_at.get("REQUIRE CAP", program.declared_at.get("ICR"))
    used, declared = set(capabilities(program.procedures)), set(program.capabilities)
    if used != declared:
        missing, idle = sorted(used - declared), sorted(declared - used)
        parts = [f"`{name}` is used and not declared" for name in missing]
        parts += [f"`{name}` is declared and not used" for name in idle]
        record = f"REQUIRE CAP {' '.join(sorted(used))}" if used else "no `REQUIRE CAP`"
        yield kinds.CAPABILITIES_DIFFER.at(place, ", ".join(parts), hint=f"write {record}")
    place = program.declared_at.get("REQUIRE AXES", program.declared_at.get("ICR"))
    if program.axes is not None and not 1 <= program.axes <= MAX_AXES:
        yield kinds.AXES_DIFFER.at(place, f"`REQUIRE AXES {program.axes}`, allowed are 1 to {MAX_AXES}")
    for procedure in program.procedures:
        for index, count in _joint_counts(procedure):
            if count != program.axes:
                declared_axes = "none are declared" if program.axes is None else f"{program.axes} declared"
                message = f"joint coordinates of {count} axes found, {declared_axes}"
                where = text_place(program, procedure, index)
                yield kinds.AXES_DIFFER.at(where, message, hint=f"`REQUIRE AXES {count}`")


def _joint_counts(procedure: Procedure) -> Iterator[tuple[int, int]]:
    """Yield the instructions that make joint coordinates, with their number of axes."""
    for index, step in enumerate(procedure.code):
        operand = step.operands[0] if step.operands else None
        if step.mnemonic == "MKJ" and isinstance(operand, int):
            yield index, operand
        elif (
            isinstance(operand, Constant) and operand.type is Type.JOINTS and isinstance(operand.value, tuple)
        ):
            yield index, len(operand.value)
