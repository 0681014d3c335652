"""Binary form -> program. No bytes make the reader raise; damage is reported with its place."""

import hashlib
from collections.abc import Iterator, Mapping

from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as kinds
from ropsim.icr.binary.code import Names, take_step
from ropsim.icr.binary.layout import CHECKSUM, MAGIC, VERSION, Section
from ropsim.icr.binary.supply import DamageError, Supply
from ropsim.icr.binary.values import take_type
from ropsim.icr.binary.writing import written
from ropsim.icr.program import (
    CHANNEL_TYPES,
    FrameDefinition,
    IoChannel,
    LibraryText,
    PoseList,
    Procedure,
    Program,
    Step,
    ToolDefinition,
    Variable,
)
from ropsim.icr.types import Type
from ropsim.spatial import PoseTuple

_HEAD = len(MAGIC) + len(VERSION)
_POSE = 56
"""Bytes of a pose."""


def read_binary(content: bytes, name: str = "<icb>") -> tuple[Program | None, tuple[Diagnostic, ...]]:
    """Return the program and the errors in the bytes; the program is None if there are any.

    There is one binary form of a program: other encodings are refused. `verify` checks whether the program
    may run. Memory and time are in proportion to the bytes.

    Args:
        content: any bytes.
        name: name of the bytes in diagnostics.
    """
    if content[: len(MAGIC)] != MAGIC:
        return None, (kinds.BINARY_DAMAGED.at(None, f"`{name}` does not begin as binary ICR does"),)
    if len(content) < _HEAD + CHECKSUM:
        message = f"`{name}` has {len(content)} bytes, binary ICR has {_HEAD + CHECKSUM} or more"
        return None, (kinds.BINARY_DAMAGED.at(None, message),)
    version = tuple(content[len(MAGIC) : _HEAD])
    if version != VERSION:
        found, allowed = (".".join(map(str, one)) for one in (version, VERSION))
        return None, (kinds.HEADER_WRONG.at(None, f"version `{found}` found, `{allowed}` allowed"),)
    end = len(content) - CHECKSUM
    if hashlib.sha256(content[:end]).digest() != content[end:]:
        hint = "get the file once more from where it was made"
        message = f"the checksum of `{name}` does not agree with its content"
        return None, (kinds.BINARY_DAMAGED.at(None, message, hint=hint),)
    try:
        program = _program(_sections(content, end))
    except DamageError as damage:
        message = f"byte {damage.at} of `{name}`: {damage.message}"
        return None, (kinds.BINARY_DAMAGED.at(None, message, data={"byte": damage.at}),)
    if written(program) != content:
        return None, (kinds.BINARY_OTHER_FORM.at(None, f"`{name}` is not in the one binary form"),)
    return program, ()


def _sections(content: bytes, end: int) -> Mapping[Section, Supply]:
    supply = Supply(content, _HEAD, end)
    found: dict[Section, Supply] = {}
    while supply.left:
        start, number = supply.at, supply.byte("a section")
        if number not in list(Section) or any(number <= known for known in found):
            raise DamageError(start, f"section {number} is unknown or not in its order")
        length = supply.number("the length of a section")
        begin = supply.at
        supply.take(length, f"section {number}")
        found[Section(number)] = Supply(content, begin, begin + length)
    for section in Section:
        found.setdefault(section, Supply(content, end, end))
    return found


def _program(sections: Mapping[Section, Supply]) -> Program:
    required = sections[Section.REQUIREMENTS]
    axes = required.integer("the number of axes")
    capabilities = tuple(required.name("a capability") for _ in required.each("capabilities", 2))
    channels = _channels(sections[Section.CHANNELS])
    frames = _frames(sections[Section.FRAMES])
    tools = _tools(sections[Section.TOOLS])
    names = sections[Section.NAMES]
    shared_types = _types(sections[Section.VARIABLES]) if sections[Section.VARIABLES].left else ()
    variables = _variables(names, shared_types)
    title = sections[Section.PROGRAM].text("the name of the program")
    heads = _heads(sections[Section.PROCEDURES], names)
    lists = tuple(_lists(sections[Section.LISTS]))
    empty = Program(
        title, heads, variables=variables, channels=channels, frames=frames, tools=tools, lists=lists
    )
    code = sections[Section.PROCEDURES]
    known = Names.of(empty)
    codes = [_code(code, known.within(one)) for one in heads]
    lines = sections[Section.LINES]
    source = lines.text("the name of the source") if lines.left else ""
    procedures = tuple(
        Procedure(one.name, one.parameters, one.locals, one.results, steps, _lines(lines, len(steps)))
        for one, steps in zip(heads, codes, strict=True)
    )
    libraries = tuple(_libraries(sections[Section.LIBRARIES]))
    for section, supply in sections.items():
        if supply.left:
            raise DamageError(supply.at, f"{supply.left} bytes are left over in section {section.value}")
    return Program(
        title,
        procedures,
        capabilities=capabilities,
        axes=axes or None,
        variables=variables,
        channels=channels,
        frames=frames,
        tools=tools,
        lists=lists,
        source=source,
        libraries=libraries,
    )


def _heads(supply: Supply, names: Supply) -> tuple[Procedure, ...]:
    """Return the interfaces of all procedures."""
    found = []
    for _ in supply.each("procedures", 6):
        name = supply.name("the name of a procedure")
        parameters, local, results = _types(supply), _types(supply), _types(supply)
        found.append(Procedure(name, _variables(names, parameters), _variables(names, local), results))
    return tuple(found)


def _code(supply: Supply, names: Names) -> tuple[Step, ...]:
    return tuple(take_step(supply, names) for _ in supply.each("instructions", 2))


def _lines(supply: Supply, count: int) -> tuple[int, ...]:
    """Return the source lines of the instructions of a procedure."""
    found: list[int] = []
    while supply.left and len(found) < count:
        start, line = supply.at, supply.integer("a source line")
        times = supply.number("how many instructions come from a line")
        if not 0 < times <= count - len(found) or line < 0:
            raise DamageError(start, f"{times} instructions from line {line}, {count - len(found)} are left")
        found += [line] * times
    return tuple(found)


def _libraries(supply: Supply) -> Iterator[LibraryText]:
    while supply.left:
        name = supply.name("the name of a procedure")
        yield LibraryText(name, supply.text("the name of a text"), supply.text("the version of a text"))


def _lists(supply: Supply) -> Iterator[PoseList]:
    while supply.left:
        name = supply.name("the name of a list")
        yield PoseList(name, tuple(_pose(supply) for _ in supply.each("poses", _POSE)))


def _types(supply: Supply) -> tuple[Type, ...]:
    return tuple(take_type(supply) for _ in supply.each("types", 1))


def _variables(names: Supply, types: tuple[Type, ...]) -> tuple[Variable, ...]:
    return tuple(Variable(names.name("the name of a variable"), kind) for kind in types)


def _channels(supply: Supply) -> tuple[IoChannel, ...]:
    found = []
    for _ in supply.each("channels", 4) if supply.left else ():
        start, number = supply.at, supply.byte("a kind of channel")
        if number >= len(CHANNEL_TYPES):
            raise DamageError(start, f"there is no kind of channel {number}")
        kind = take_type(supply)
        found.append(IoChannel(supply.name("the name of a channel"), list(CHANNEL_TYPES)[number], kind))
    return tuple(found)


def _frames(supply: Supply) -> tuple[FrameDefinition, ...]:
    return tuple(
        FrameDefinition(supply.name("the name of a frame"), _pose(supply))
        for _ in (supply.each("frames", 2 + _POSE) if supply.left else ())
    )


def _tools(supply: Supply) -> tuple[ToolDefinition, ...]:
    found = []
    for _ in supply.each("tools", 3) if supply.left else ():
        name = supply.name("the name of a tool")
        start, has_pose = supply.at, supply.byte("whether a tool has a pose")
        if has_pose > 1:
            raise DamageError(start, f"a tool has {has_pose} poses, allowed are 0 and 1")
        found.append(ToolDefinition(name, _pose(supply) if has_pose else None))
    return tuple(found)


def _pose(supply: Supply) -> PoseTuple:
    x, y, z, qw, qx, qy, qz = supply.reals(7, "a pose")
    return (x, y, z, qw, qx, qy, qz)
