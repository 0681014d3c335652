"""Program -> binary form."""

import hashlib
from collections.abc import Iterable, Iterator
from itertools import groupby

from ropsim.icr import diagnostics as kinds
from ropsim.icr.binary.code import Names, Numbers, put_step
from ropsim.icr.binary.layout import LONGEST_NAME, MAGIC, VERSION, Section
from ropsim.icr.binary.sink import Sink
from ropsim.icr.binary.values import put_type
from ropsim.icr.errors import UnverifiedError
from ropsim.icr.program import CHANNEL_TYPES, Procedure, Program, Variable
from ropsim.icr.rules.verifier import verify
from ropsim.icr.text.tokens import shown


def encoded(program: Program) -> bytes:
    """Return the binary form of a program that may run; `read_binary` is the inverse.

    Raises:
        UnverifiedError: the verifier refuses the program, or a name is too long; carries all diagnostics.
    """
    found = verify(program) or tuple(
        kinds.NAME_TOO_LONG.at(None, f"`{shown(name)}` has more than {LONGEST_NAME} bytes")
        for name in _names(program)
        if len(name.encode("utf-8", "surrogatepass")) > LONGEST_NAME
    )
    if found:
        raise UnverifiedError(found)
    return written(program)


def written(program: Program) -> bytes:
    """Return the binary form of a program whose operands are all declared."""
    sink = Sink()
    sink.content += MAGIC + bytes(VERSION)
    for section, content in _sections(program):
        if content:
            sink.byte(section)
            sink.number(len(content))
            sink.content += content
    return bytes(sink.content) + hashlib.sha256(sink.content).digest()


def _sections(program: Program) -> Iterator[tuple[Section, bytes]]:
    named, required, variables, channels, frames, tools, procedures = (Sink() for _ in range(7))
    named.text(program.name)
    required.integer(0 if program.axes is None else program.axes)
    _each(required, sorted(program.capabilities))
    _types(variables, program.variables)
    channels.number(len(program.channels))
    for channel in program.channels:
        channels.byte(list(CHANNEL_TYPES).index(channel.kind))
        put_type(channels, channel.type)
        channels.text(channel.name)
    frames.number(len(program.frames))
    for frame in program.frames:
        frames.text(frame.name)
        frames.reals(frame.pose)
    tools.number(len(program.tools))
    for tool in program.tools:
        tools.text(tool.name)
        tools.byte(tool.pose is not None)
        tools.reals(tool.pose or ())
    _procedures(procedures, program)
    yield Section.PROGRAM, bytes(named.content)
    yield Section.REQUIREMENTS, bytes(required.content)
    for section, sink in zip(
        (Section.VARIABLES, Section.CHANNELS, Section.FRAMES, Section.TOOLS),
        (variables, channels, frames, tools),
        strict=True,
    ):
        yield section, b"" if sink.content == b"\x00" else bytes(sink.content)
    yield Section.PROCEDURES, bytes(procedures.content)
    yield Section.LISTS, _lists(program)
    yield Section.NAMES, _variable_names(program)
    yield Section.LINES, _lines(program)
    yield Section.LIBRARIES, _libraries(program)


def _procedures(sink: Sink, program: Program) -> None:
    sink.number(len(program.procedures))
    for procedure in program.procedures:
        sink.text(procedure.name)
        _types(sink, procedure.parameters)
        _types(sink, procedure.locals)
        sink.number(len(procedure.results))
        for result in procedure.results:
            put_type(sink, result)
    shared = Numbers(Names.of(program))
    for procedure in program.procedures:
        numbers = shared.within(procedure)
        sink.number(len(procedure.code))
        for step in procedure.code:
            put_step(sink, step, numbers)


def _lists(program: Program) -> bytes:
    """Return the lists of poses; empty for none."""
    sink = Sink()
    for one in program.lists:
        sink.text(one.name)
        sink.number(len(one.poses))
        for pose in one.poses:
            sink.reals(pose)
    return bytes(sink.content)


def _variable_names(program: Program) -> bytes:
    """Return the names of all variables: the global ones, then the local ones of each procedure."""
    sink = Sink()
    for variables in (program.variables, *(one.variables for one in program.procedures)):
        for variable in variables:
            sink.text(variable.name)
    return bytes(sink.content)


def _lines(program: Program) -> bytes:
    """Return the source and how many instructions come from which line; empty where none is known."""
    runs = [list(_runs(one)) for one in program.procedures]
    if not program.source and not any(line for procedure in runs for line, _ in procedure):
        return b""
    sink = Sink()
    sink.text(program.source)
    for procedure in runs:
        for line, count in procedure:
            sink.integer(line)
            sink.number(count)
    return bytes(sink.content)


def _libraries(program: Program) -> bytes:
    """Return the texts of procedures that come from elsewhere; empty for none."""
    sink = Sink()
    for one in program.libraries:
        for text in (one.procedure, one.source, one.version):
            sink.text(text)
    return bytes(sink.content)


def _runs(procedure: Procedure) -> Iterator[tuple[int, int]]:
    for line, group in groupby(procedure.lines):
        yield line, sum(1 for _ in group)


def _types(sink: Sink, variables: tuple[Variable, ...]) -> None:
    sink.number(len(variables))
    for variable in variables:
        put_type(sink, variable.type)


def _each(sink: Sink, texts: Iterable[str]) -> None:
    listed = list(texts)
    sink.number(len(listed))
    for text in listed:
        sink.text(text)


def _names(program: Program) -> Iterator[str]:
    """Yield all names of a program."""
    for group in (
        program.variables,
        program.channels,
        program.frames,
        program.tools,
        program.lists,
        program.procedures,
    ):
        yield from (one.name for one in group)
    yield from program.capabilities
    for procedure in program.procedures:
        yield from (one.name for one in procedure.variables)
        yield from (str(step.operands[0]) for step in procedure.code if step.mnemonic == "POSTURE")
