"""Rule V7 against a search of ways, one variable after the other, in code with any jumps."""

from functools import cache

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.icr import Procedure, Program, Step, Type, Variable, unassigned
from support.examples import examples

GLOBALS = ("a", "b")
LOCALS = ("p", "x")


@cache
def instruction(size: int, callees: tuple[str, ...]) -> st.SearchStrategy[Step]:
    """Return any instruction that matters; conditions most of all, so that ways part and join."""
    places = st.integers(0, size - 1)
    calls = tuple(f"CALL {name}" for name in callees)
    words = st.sampled_from(("STORE",) * 4 + ("LOAD",) * 2 + ("JF",) * 4 + ("JMP",) + calls)

    def made(word: str, name: str, place: int) -> Step:
        mnemonic, _, callee = word.partition(" ")
        return Step(mnemonic, (callee or (place if mnemonic in ("JF", "JMP") else name),))

    return st.builds(made, words, st.sampled_from(GLOBALS + LOCALS), places)


@st.composite
def procedures(draw: st.DrawFn, name: str, callees: tuple[str, ...]) -> Procedure:
    size = draw(st.integers(4, 16))
    code = draw(st.lists(instruction(size, callees), min_size=size - 1, max_size=size - 1))
    end = draw(st.sampled_from((Step("RET"),) * 4 + (Step("HALT"), Step("JMP", (0,)))))
    local = tuple(Variable(one, Type.INT) for one in LOCALS)
    parameters = () if name == "main" else local[:1]
    return Procedure(name, parameters, local[len(parameters) :], (), (*code, end))


@st.composite
def programs(draw: st.DrawFn) -> Program:
    names = ("main", "one", "two")
    code = [draw(procedures(name, names[k + 1 :])) for k, name in enumerate(names)]
    return Program("t", tuple(code), variables=tuple(Variable(one, Type.INT) for one in GLOBALS))


def search(program: Program, procedure: Procedure, name: str) -> tuple[set[int], bool]:
    """Return where a variable is read on ways that gave it no value, and whether such a way returns."""
    own = {one.name for one in procedure.variables}
    reads: set[int] = set()
    returns = False
    seen: set[int] = set()
    work = [0]
    while work:
        index = work.pop()
        if index in seen:
            continue
        seen.add(index)
        step = procedure.code[index]
        if step.mnemonic == "CALL":
            callee = program.procedure(str(step.operands[0]))
            assert callee is not None
            inside, comes_back = search(program, callee, "" if name in own else name)
            if inside and name not in own:
                reads.add(index)
            if not comes_back:
                continue
        if step.mnemonic == "LOAD" and step.operands[0] == name:
            reads.add(index)
        if step.mnemonic == "RET":
            returns = True
        if step.mnemonic not in ("RET", "HALT") and not (
            step.mnemonic == "STORE" and step.operands[0] == name
        ):
            work += [index + 1] if step.mnemonic != "JMP" else []
            work += [one for one in step.operands if isinstance(one, int)]
    return reads, returns


@settings(max_examples=examples(500), derandomize=True)
@given(programs())
def test_the_variables_that_v7_refuses_are_those_that_a_way_reads_without_a_value(program: Program) -> None:
    wanted = {}
    for procedure in program.procedures:
        names = LOCALS if procedure.name != "main" else LOCALS + GLOBALS
        parameters = {one.name for one in procedure.parameters}
        found = {name: search(program, procedure, name)[0] for name in names if name not in parameters}
        first = {name: min(reads) for name, reads in found.items() if reads}
        if first:
            wanted[procedure.name] = first
    refused = {
        procedure: {need.slot.name: need.at for need in needs}
        for procedure, needs in unassigned(program).items()
    }
    assert refused == wanted
