"""The engine of knowledge bases: texts, facts and functions in, answers out; it survives its Prolog."""

from collections.abc import Iterable, Mapping
from pathlib import PurePosixPath
from threading import get_ident
from types import MappingProxyType

from ropsim.core import Diagnostic, SourceText
from ropsim.prolog.answers import Answer, Answers, GoalStack
from ropsim.prolog.clauses import findings_of
from ropsim.prolog.diagnostics import NOT_FOR_NATIVE, WRONG_USE
from ropsim.prolog.door import Door
from ropsim.prolog.errors import GoalError
from ropsim.prolog.failures import failure_of, failures_raised, taken
from ropsim.prolog.limits import Limits
from ropsim.prolog.loading import load_findings, loaded_module
from ropsim.prolog.native.program import NativeProgram
from ropsim.prolog.preparation import Preparation
from ropsim.prolog.program import Prolog, Start
from ropsim.prolog.running import RunningProlog
from ropsim.prolog.terms.predicate import Predicate
from ropsim.prolog.terms.terms import Atom, Struct, Term
from ropsim.prolog.terms.texts import LoadedText, Trust
from ropsim.prolog.terms.writing import write_term
from ropsim.prolog.wasm.program import WasmProgram

DOOR = "/ropsim/door.pl"
NOTHING = Preparation()
OPENING = 10.0
"""Least time for opening the door [s]: it is a part of ropsim that ends, however busy the machine is."""
_START: Mapping[Prolog, Start] = MappingProxyType(
    {Prolog.BUILT_IN: WasmProgram, Prolog.NATIVE: NativeProgram}
)


class Engine:
    """A Prolog with knowledge bases; it starts when it is first needed, and comes again after a crash.

    One thread uses it; only `cancel` may be called by others. What goals assert lives until the next crash:
    permanent facts are set with `put_facts`.
    """

    def __init__(
        self,
        limits: Limits | None = None,
        prolog: Prolog = Prolog.BUILT_IN,
        preparation: Preparation = NOTHING,
    ) -> None:
        """Prepare an engine.

        Args:
            limits: of the engine, and of goals for which no others are given.
            prolog: which one it uses.
            preparation: its contents from the start on.
        """
        self.limits = limits or Limits()
        self.prolog = prolog
        self._thread = get_ident()
        self._running: RunningProlog | None = None
        self._preparation = preparation
        self._door = Door()
        for predicate in preparation.predicates:
            self._door.register(predicate)
        self._texts: dict[str, LoadedText] = {}
        self._facts: dict[str, tuple[Term, ...]] = {}
        self._stack = GoalStack()

    def check(self, text: SourceText) -> tuple[Diagnostic, ...]:
        """Return the findings in a text, clause by clause, without loading it; its directives are not run.

        Raises:
            GoalError: reading took too long or too much.
        """
        request = Struct("check", (text.text, Atom(PurePosixPath(text.name).stem)))
        return findings_of(text, self._once("check", request))

    def consult(self, text: SourceText, trust: Trust = Trust.STRANGER) -> tuple[Diagnostic, ...]:
        """Load a text in place of the one with its name; return its findings.

        It is loaded into the module that it declares, else into one with the name of its file, without folder
        and ending. A text with errors is not loaded, and its earlier version is removed.

        Raises:
            GoalError: loading took too long or too much; or P123, a stranger's text for the native Prolog.
        """
        if trust is Trust.STRANGER and self.prolog is Prolog.NATIVE:
            raise GoalError(
                NOT_FOR_NATIVE.at(
                    None,
                    f"`{text.name}` is not trusted, and the native Prolog could do everything it asks",
                    hint="trust it, or use the built-in Prolog",
                )
            )
        self.forget(text.name)
        findings = self.check(text)
        if any(one.is_error for one in findings):
            return findings
        loaded = LoadedText(
            f"/kb/{text.name.lstrip('/')}",
            text.text.encode(errors="replace"),
            PurePosixPath(text.name).stem,
            trust,
        )
        reply = self._load(self._prolog(), loaded)
        findings = (*findings, *load_findings(text, reply))
        if any(one.is_error for one in findings):
            self._once("forget", Atom(self._prolog().place(loaded.path)))
        else:
            self._texts[text.name] = LoadedText(loaded.path, loaded.content, loaded_module(reply), trust)
        return findings

    def forget(self, name: str) -> None:
        """Take the text of a name out of the engine, and all its definitions."""
        loaded = self._texts.pop(name, None)
        if loaded is not None:
            self._once("forget", Atom(self._prolog().place(loaded.path)))

    def put_facts(self, module: str, facts: Iterable[Term]) -> None:
        """Let a module hold these facts and no others, such as the state of the cell.

        Raises:
            GoalError: a fact is no callable term, or the module is one of a text.
        """
        given = tuple(facts)
        taken(self._give(self._prolog(), module, given))
        self._facts[module] = given

    def register(self, predicate: Predicate) -> None:
        """Let all texts call a function of Python as a predicate; one of its name and arity is replaced.

        Raises:
            GoalError: the name is one of Prolog's own.
        """
        running = self._prolog()
        self._door.register(predicate)
        try:
            self._open_door(running)
        except GoalError:
            self._door.withdraw(predicate)
            self._open_door(running)
            raise

    def query(
        self, goal: str | Struct | Atom, *, module: str = "user", limits: Limits | None = None
    ) -> Answers:
        """Yield the answers of a goal, one by one; Prolog computes the next on request.

        Args:
            goal: a term, or its text without a full stop.
            module: the module in which the goal is meant.
            limits: for this goal; by default the limits of the engine.

        Raises:
            GoalError: the goal cannot be read, is not allowed, ended with an error or was stopped.
        """
        text = goal if isinstance(goal, str) else write_term(goal)
        bounds = limits or self.limits
        strange = any(one.trust is Trust.STRANGER for one in self._texts.values())
        guard = Trust.STRANGER if strange else Trust.OWN
        inferences = Atom("none") if bounds.inferences is None else bounds.inferences
        request = Struct("goal", (text, Atom(module), Atom(guard.value), inferences))
        return Answers(self._prolog().ask("solve", request, bounds.seconds), self._stack)

    def once(
        self, goal: str | Struct | Atom, *, module: str = "user", limits: Limits | None = None
    ) -> Answer | None:
        """Return the first answer of a goal, None if it has no answer; see `query`."""
        answers = self.query(goal, module=module, limits=limits)
        try:
            return next(answers, None)
        finally:
            answers.close()

    def module_of(self, name: str) -> str | None:
        """Return the module of the text of a name, or None for an unknown text."""
        loaded = self._texts.get(name)
        return loaded.module if loaded else None

    def printed(self) -> str:
        """Return the output of goals and texts since the last call, up to 64 KiB."""
        return self._running.printed() if self._running else ""

    def cancel(self) -> None:
        """Stop the goal that runs now, if any; every thread may call this."""
        running = self._running
        if running is not None:
            running.cancel()

    def close(self) -> None:
        """End Prolog and all goals; it starts again when it is needed."""
        self._stack.give_up()
        self._door.close()
        if self._running is not None:
            self._running.close()
        self._running = None

    def _once(self, name: str, request: Term) -> Term:
        """Return the reply to a request.

        Raises:
            GoalError: the reply is an error, Prolog was stopped or has crashed.
        """
        with failures_raised():
            reply = self._prolog().once(name, request, self.limits.seconds)
        if isinstance(reply, Struct) and reply.name in {"stopped", "error", "uncaught"}:
            raise failure_of(reply)
        return reply

    def _prolog(self) -> RunningProlog:
        """Return the running Prolog; if there is none, start one with the contents of the last one.

        Raises:
            GoalError: the engine belongs to another thread.
            RopsimError: SWI-Prolog is not there.
        """
        if get_ident() != self._thread:
            raise GoalError(
                WRONG_USE.at(
                    None,
                    "the engine belongs to the thread that made it, and another one used it",
                    hint="make an engine in each thread",
                )
            )
        running = self._running
        if running is None or (running.has_ended and not running.is_busy):
            self.close()
            running = RunningProlog(self.limits, self._door.answer, _START[self.prolog])
            self._running = running
            try:
                with failures_raised():
                    self._replay(running)
            except BaseException:  # contents not transferred now would never be
                self.close()
                raise
        return running

    def _replay(self, running: RunningProlog) -> None:
        self._prepare(running)
        for module, facts in self._facts.items():
            self._give(running, module, facts)
        for loaded in self._texts.values():
            self._load(running, loaded)

    def _prepare(self, running: RunningProlog) -> None:
        """Open the door and transfer the initial contents of the engine, or restore them from an image."""
        own, loads, door = self._preparation, self._preparation.loads(), self._door.text()
        mark = own.mark(door)
        if own.sources and running.go_on(mark):
            running.write(DOOR, door.encode())
            for loaded in loads:
                running.write(loaded.path, loaded.content)
            return
        self._open_door(running)
        for module, facts in own.facts.items():
            taken(self._give(running, module, facts))
        for text, loaded in zip(own.sources, loads, strict=True):
            for finding in load_findings(text, self._load(running, loaded)):
                if finding.is_error:
                    raise GoalError(finding)
        if own.sources:
            running.keep(mark)

    def _open_door(self, running: RunningProlog) -> None:
        running.write(DOOR, self._door.text().encode())
        seconds = max(self.limits.seconds, OPENING)
        with failures_raised():
            reply = running.once("open_door", Atom(running.place(DOOR)), seconds)
        taken(reply)

    def _load(self, running: RunningProlog, loaded: LoadedText) -> Term:
        running.write(loaded.path, loaded.content)
        with failures_raised():
            return running.once("load", loaded.request(running.place(loaded.path)), self.limits.seconds)

    def _give(self, running: RunningProlog, module: str, facts: tuple[Term, ...]) -> Term:
        with failures_raised():
            return running.once("put_facts", Struct("facts", (Atom(module), facts)), self.limits.seconds)
