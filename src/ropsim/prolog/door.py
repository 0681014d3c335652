"""The only way from Prolog back to Python: calls of the predicates that were registered, and nothing else."""

from collections.abc import Iterator, Sequence

from ropsim.core import RopsimError
from ropsim.prolog.terms.predicate import Predicate, complaint
from ropsim.prolog.terms.reading import read_term
from ropsim.prolog.terms.terms import Atom, Struct, Term, Var
from ropsim.prolog.terms.writing import write_term

MOST_OPEN = 1000
"""Number of calls that may wait for their next solution at a time."""
MODULE = "ropsim_door"


class Door:
    """Registered predicates by name, and the calls of them that Prolog may request another solution."""

    def __init__(self) -> None:
        self._predicates: dict[tuple[str, int], Predicate] = {}
        self._open: dict[int, tuple[Predicate, Iterator[Sequence[Term]]]] = {}
        self._last = 0

    def register(self, predicate: Predicate) -> None:
        """Let Prolog call a predicate; one of the same name and arity is replaced."""
        self._predicates[predicate.name, len(predicate.inputs) + len(predicate.outputs)] = predicate

    def withdraw(self, predicate: Predicate) -> None:
        """Let Prolog not call a predicate any more."""
        self._predicates.pop((predicate.name, len(predicate.inputs) + len(predicate.outputs)), None)

    def text(self) -> str:
        """Return the module of Prolog in which the predicates are, each with a call of the host."""
        lines = []
        for (name, arity), one in sorted(self._predicates.items(), key=lambda item: item[0]):
            names = [f"A{index}" for index in range(arity)]
            inputs, outputs = (
                ", ".join(part) for part in (names[: len(one.inputs)], names[len(one.inputs) :])
            )
            head = f"{name}({', '.join(names)})" if names else name
            any_head = f"{name}({', '.join('_' * arity)})" if names else name
            call = (
                f"ask({name}/{arity}, [{inputs}], [{outputs}])"
                if one.outputs
                else f"ask_once({name}/{arity}, [{inputs}])"
            )
            lines += [f"{head} :- ropsim_engine:{call}.", f"sandbox:safe_primitive({MODULE}:{any_head})."]
        exports = ", ".join(f"{name}/{arity}" for name, arity in sorted(self._predicates))
        begin = [
            f":- module({MODULE}, [{exports}]).",
            ":- multifile sandbox:safe_primitive/1.",
            ":- discontiguous sandbox:safe_primitive/1.",
        ]
        return "\n".join([*begin, *sorted(lines, key=lambda line: line.startswith("sandbox")), ""])

    def answer(self, request: str) -> str:
        """Return the canonical text of the reply to a call; an exception becomes an error of Prolog."""
        try:
            return write_term(self._answer(read_term(request)))
        except Exception as error:
            formal = Struct("python_error", _failure(error))
            return write_term(_thrown(Struct("error", (formal, Var("_")))))

    def close(self) -> None:
        """End all calls that wait."""
        for _, solutions in self._open.values():
            _close(solutions)
        self._open.clear()

    def _answer(self, request: Term) -> Term:
        match request:
            case Struct("test" | "open" as kind, (Struct("/", (Atom(name), int(arity))), tuple(inputs))):
                predicate = self._predicates[name, arity]
                for sort, term in zip(predicate.inputs, inputs, strict=True):
                    if error := complaint(sort, term):
                        return _thrown(error)
                solutions = iter(predicate.solve(*inputs))
                return self._opened(predicate, solutions) if kind == "open" else _tested(solutions)
            case Struct("next", (int(handle),)):
                return self._next(handle)
            case Struct("close", (int(handle),)):
                _close(self._open.pop(handle, (None, iter(())))[1])
                return Atom("yes")
        raise LookupError("the host knows no such call")

    def _opened(self, predicate: Predicate, solutions: Iterator[Sequence[Term]]) -> Term:
        if len(self._open) >= MOST_OPEN:
            raise OverflowError(f"{MOST_OPEN} calls wait for their next solution")
        self._last += 1
        self._open[self._last] = predicate, solutions
        return Struct("handle", (self._last,))

    def _next(self, handle: int) -> Term:
        predicate, solutions = self._open[handle]
        found = next(solutions, None)
        if found is None:
            return Atom("end")
        for sort, term in zip(predicate.outputs, found, strict=True):
            if not sort.admits(term):
                raise ValueError(f"`{predicate.indicator}` found {_found(term)}, promised was {sort.value}")
        return Struct("sol", (tuple(found),))


def _failure(error: Exception) -> tuple[Term, Term]:
    """Return the sort of an error of a function and its words."""
    if isinstance(error, RopsimError):
        return Atom("RopsimError"), error.diagnostic.message
    return Atom(type(error).__name__), str(error)[:2000]


def _found(term: object) -> str:
    """Return the result of a function in Prolog syntax."""
    if isinstance(term, Atom | Struct | Var | int | float | str | tuple):
        return f"`{write_term(term)}`"
    return "a value that is no term"


def _tested(solutions: Iterator[Sequence[Term]]) -> Term:
    return Atom("no" if next(solutions, None) is None else "yes")


def _thrown(error: Term) -> Term:
    return Struct("throw", (error,))


def _close(solutions: Iterator[Sequence[Term]]) -> None:
    close = getattr(solutions, "close", None)
    if close is not None:
        close()
