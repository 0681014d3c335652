"""Rules V6 and V7: acyclic calls, and a value in every variable before it is read."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as kinds
from ropsim.icr.program import Procedure, Program, text_place
from ropsim.icr.rules.flow import successors


class Slot(NamedTuple):
    """A variable as one procedure sees it."""

    name: str
    is_global: bool


class Need(NamedTuple):
    """A variable that may be read without a value, and the instruction where that happens."""

    slot: Slot
    at: int


class Summary(NamedTuple):
    """What a procedure does with variables.

    Attributes:
        needs: variables read before a value was given in it; globals may get theirs from the caller.
        assigns: global variables that have a value whenever it returns.
    """

    needs: tuple[Need, ...]
    assigns: frozenset[Slot]


def check_calls(program: Program) -> Iterator[Diagnostic]:
    """Yield one diagnostic for each call that closes a cycle, with the call chain (V6)."""
    procedures = {one.name: one for one in program.procedures}
    finished: set[str] = set()
    for root, procedure in procedures.items():
        chain: list[tuple[str, Iterator[tuple[int, str]]]] = []
        if root not in finished:
            chain.append((root, _calls(procedure)))
        while chain:
            name, calls = chain[-1]
            index, callee = next(calls, (-1, ""))
            active = [one for one, _ in chain]
            if index < 0:
                finished.add(name)
                chain.pop()
            elif callee in active:
                cycle = " -> ".join([*active[active.index(callee) :], callee])
                place = text_place(program, procedures[name], index)
                yield kinds.CALLS_CYCLIC.at(place, f"`{callee}` calls itself: {cycle}", hint="use a loop")
            elif callee not in finished:
                chain.append((callee, _calls(procedures[callee])))


def check_assignment(program: Program) -> Iterator[Diagnostic]:
    """Yield where a variable may be read without a value (V7); needs rules V1 to V6."""
    procedures = {one.name: one for one in program.procedures}
    for name, needs in unassigned(program).items():
        for need in needs:
            place = text_place(program, procedures[name], need.at)
            message = f"variable `{need.slot.name}` may be read in `{name}` before it has a value"
            yield kinds.NOT_ASSIGNED.at(place, message, hint="store a value first on every way")


def unassigned(program: Program) -> Mapping[str, tuple[Need, ...]]:
    """Return, by procedure, the variables that rule V7 refuses: locals, and in `main` globals too."""
    summaries: dict[str, Summary] = {}
    for name in _callees_first(program):
        procedure = program.procedure(name)
        if procedure is not None:
            summaries[name] = _summary(program, procedure, summaries)
    refused = {}
    for one in program.procedures:
        needs = summaries[one.name].needs
        found = tuple(need for need in needs if one.name == "main" or not need.slot.is_global)
        if found:
            refused[one.name] = found
    return refused


def _calls(procedure: Procedure) -> Iterator[tuple[int, str]]:
    for index, step in enumerate(procedure.code):
        if step.mnemonic == "CALL":
            yield index, str(step.operands[0])


def _callees_first(program: Program) -> list[str]:
    procedures = {one.name: one for one in program.procedures}
    order: list[str] = []
    done: set[str] = set()
    for root in procedures:
        work = [(root, False)]
        while work:
            name, is_left = work.pop()
            if is_left:
                order.append(name)
            elif name not in done:
                done.add(name)
                work.append((name, True))
                work += [(callee, False) for _, callee in _calls(procedures[name])]
    return order


def _summary(program: Program, procedure: Procedure, known: Mapping[str, Summary]) -> Summary:
    states = {0: frozenset(Slot(variable.name, is_global=False) for variable in procedure.parameters)}
    work = [0]
    while work:
        index = work.pop()
        after = states[index] | _given(procedure, index, known)
        for target in successors(procedure, index):
            merged = states[target] & after if target in states else after
            if states.get(target) != merged:
                states[target] = merged
                work.append(target)
    needs: dict[Slot, Need] = {}
    ends = []
    for index in sorted(states):
        for slot in sorted(_read(procedure, index, known) - states[index]):
            needs.setdefault(slot, Need(slot, index))
        if procedure.code[index].mnemonic == "RET":
            ends.append(frozenset(slot for slot in states[index] if slot.is_global))
    # A procedure that never returns promises everything: nothing after the call is reached.
    everything = frozenset(Slot(variable.name, is_global=True) for variable in program.variables)
    return Summary(tuple(needs.values()), frozenset.intersection(*ends) if ends else everything)


def _slot(procedure: Procedure, index: int) -> Slot:
    name = str(procedure.code[index].operands[0])
    return Slot(name, all(variable.name != name for variable in procedure.variables))


def _given(procedure: Procedure, index: int, known: Mapping[str, Summary]) -> frozenset[Slot]:
    mnemonic = procedure.code[index].mnemonic
    if mnemonic == "STORE":
        return frozenset({_slot(procedure, index)})
    return known[_slot(procedure, index).name].assigns if mnemonic == "CALL" else frozenset()


def _read(procedure: Procedure, index: int, known: Mapping[str, Summary]) -> frozenset[Slot]:
    mnemonic = procedure.code[index].mnemonic
    if mnemonic == "LOAD":
        return frozenset({_slot(procedure, index)})
    if mnemonic != "CALL":
        return frozenset()
    needs = known[_slot(procedure, index).name].needs
    return frozenset(need.slot for need in needs if need.slot.is_global)
