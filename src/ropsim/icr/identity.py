"""Identity of programs: independent of names of variables and of the order of declarations."""

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import Procedure, Program, Step, Variable
from ropsim.icr.text.writer import disassemble

_OF_VARIABLES = frozenset(name for name, one in OPCODES.items() if one.operands == (OperandKind.VARIABLE,))


def program_id(program: Program) -> str:
    """Return the SHA-256 of the meaning of a program: of the canonical text of its plain form."""
    return program.identity(lambda: hashlib.sha256(_canonical(program)).hexdigest())


def _canonical(program: Program) -> bytes:
    return disassemble(_plain(program)).encode("ascii", "backslashreplace")


def code_lines(program: Program) -> tuple[int, ...]:
    """Return the source line of each instruction, 0 where unknown, in an order of the meaning alone.

    Programs of one identity have the same instruction at the same place, wherever their lines lie.
    """
    return tuple(line for one in _in_order_of_calls(program) for line in one.lines)


def _plain(program: Program) -> Program:
    """Return a program without source lines, in the order of use, its variables named by their place in it.

    Procedures stand in the order in which `main` and its callees first name them, uncalled ones behind them
    by name; channels, frames and tools by name; variables in order of first use.
    """
    procedures = tuple(_in_order_of_calls(program))
    used = (step.operands[0] for one in procedures for step in one.code if _is_shared(step, one))
    shared = _by_use(program.variables, used)
    names = {one.name: f"v{number}" for number, one in enumerate(shared)}
    return replace(
        program,
        procedures=tuple(_plain_procedure(one, names) for one in procedures),
        variables=_renamed(shared, names),
        channels=tuple(sorted(program.channels, key=lambda one: one.name)),
        frames=tuple(sorted(program.frames, key=lambda one: one.name)),
        tools=tuple(sorted(program.tools, key=lambda one: one.name)),
        lists=tuple(sorted(program.lists, key=lambda one: one.name)),
        source="",
        libraries=(),
    )


def _in_order_of_calls(program: Program) -> Iterator[Procedure]:
    waiting = [one for one in (program.procedure("main"),) if one is not None]
    seen = {one.name for one in waiting}
    while waiting:
        procedure = waiting.pop()
        yield procedure
        called = []
        for step in procedure.code:
            name = str(step.operands[0]) if step.mnemonic == "CALL" and step.operands else ""
            callee = program.procedure(name) if name and name not in seen else None
            if callee is not None:
                seen.add(name)
                called.append(callee)
        waiting += reversed(called)
    yield from sorted((one for one in program.procedures if one.name not in seen), key=lambda one: one.name)


def _plain_procedure(procedure: Procedure, shared: dict[str, str]) -> Procedure:
    used = (step.operands[0] for step in procedure.code if _takes_variable(step))
    local = _by_use(procedure.locals, used)
    own = {one.name: f"p{number}" for number, one in enumerate((*procedure.parameters, *local))}
    names = {**shared, **own}
    code = tuple(
        Step(one.mnemonic, (names.get(str(one.operands[0]), one.operands[0]),))
        if _takes_variable(one)
        else one
        for one in procedure.code
    )
    parameters, variables = _renamed(procedure.parameters, own), _renamed(local, own)
    return replace(procedure, parameters=parameters, locals=variables, code=code, lines=(), places=())


def _takes_variable(step: Step) -> bool:
    return step.mnemonic in _OF_VARIABLES and len(step.operands) == 1


def _is_shared(step: Step, procedure: Procedure) -> bool:
    return _takes_variable(step) and step.operands[0] not in procedure.numbers


def _by_use(variables: Iterable[Variable], used: Iterable[object]) -> tuple[Variable, ...]:
    """Return variables in the order of their first use, unused ones behind them by type."""
    place = {name: -number for number, name in enumerate(reversed(list(used)))}
    unused = 1
    return tuple(sorted(variables, key=lambda one: (place.get(one.name, unused), one.type.value)))


def _renamed(variables: Iterable[Variable], names: dict[str, str]) -> tuple[Variable, ...]:
    return tuple(Variable(names[one.name], one.type) for one in variables)
