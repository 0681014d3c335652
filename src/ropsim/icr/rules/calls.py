"""Rule V6: calls are acyclic."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as kinds
from ropsim.icr.program import Procedure, Program, text_place


def check_calls(program: Program) -> Iterator[Diagnostic]:
    """Yield one diagnostic for each call that closes a cycle, with the call chain (V6)."""
    procedures = {one.name: one for one in program.procedures}
    finished: set[str] = set()
    for root, procedure in procedures.items():
        chain = {} if root in finished else {root: calls(procedure)}
        while chain:
            name = next(reversed(chain))
            index, callee = next(chain[name], (-1, ""))
            if index < 0:
                finished.add(name)
                del chain[name]
            elif callee in chain:
                active = list(chain)
                cycle = " -> ".join([*active[active.index(callee) :], callee])
                place = text_place(program, procedures[name], index)
                yield kinds.CALLS_CYCLIC.at(place, f"`{callee}` calls itself: {cycle}", hint="use a loop")
            elif callee not in finished:
                chain[callee] = calls(procedures[callee])


def calls(procedure: Procedure) -> Iterator[tuple[int, str]]:
    """Yield the calls of a procedure: index and name of the one that is called."""
    for index, step in enumerate(procedure.code):
        if step.mnemonic == "CALL":
            yield index, str(step.operands[0])


def callees_first(program: Program) -> list[Procedure]:
    """Return all procedures, callees before callers."""
    procedures = {one.name: one for one in program.procedures}
    order: list[Procedure] = []
    done: set[str] = set()
    for root in procedures:
        work = [(root, False)]
        while work:
            name, is_left = work.pop()
            if is_left:
                order.append(procedures[name])
            elif name not in done:
                done.add(name)
                work.append((name, True))
                work += [(callee, False) for _, callee in calls(procedures[name])]
    return order
