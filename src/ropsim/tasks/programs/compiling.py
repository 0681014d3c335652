"""The bodies of a knowledge base in a cell: as tasks that programs call, and their errors."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from pathlib import PurePath

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language import HIDDEN, UNKNOWN_TASK, Environment, TaskSignature, compile_library
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.findings.text_diagnostics import NO_COMPILING
from ropsim.tasks.kinds import TaskError
from ropsim.tasks.programs.program_text import UNITS, needed
from ropsim.tasks.programs.task_text import task_text, version_of_text
from ropsim.tasks.terms.known_task import KnownTask


def renamed_calls(body: tuple[Term, ...], names: Mapping[str, str]) -> tuple[Term, ...]:
    """Return a body that calls tasks by other names.

    Args:
        body: statements as terms.
        names: the other name of each task, by its own; tasks without one keep theirs.
    """
    return tuple(_renamed(one, names) for one in body) if names else body


def _renamed(term: Term, names: Mapping[str, str]) -> Term:
    match term:
        case Struct("call", (Struct(name, arguments),)):
            return Struct("call", (Struct(names.get(name, name), arguments),))
        case Struct("call", (Atom(name),)):
            return Struct("call", (Atom(names.get(name, name)),))
        case Struct(name, arguments):
            return Struct(name, tuple(_renamed(one, names) for one in arguments))
        case tuple():
            return tuple(_renamed(one, names) for one in term)
    return term


_HEAD = ("program bodies", f"units {UNITS}")


@frozen_dataclass
class Library:
    """Tasks of a knowledge base as programs call them in a cell.

    Attributes:
        tasks: tasks that compile, with all tasks that they call, as `Environment.tasks` has them.
        refused: tasks that do not, with the reason.
        text: task text of which they were made; it is their version.
    """

    tasks: Mapping[str, TaskSignature] = field(default_factory=dict)
    refused: Mapping[str, str] = field(default_factory=dict)
    text: str = ""

    @property
    def version(self) -> str:
        """Return the SHA-256 of the content of the tasks, as 64 digits."""
        return version_of_text(self.text)


@frozen_dataclass
class _Bodies:
    """Some tasks as one text: its lines, and the task of each."""

    lines: list[str]
    owners: list[KnownTask | None]

    @classmethod
    def of(cls, texts: Mapping[str, tuple[KnownTask, str]]) -> "_Bodies":
        lines: list[str] = list(_HEAD)
        owners: list[KnownTask | None] = [None] * len(_HEAD)
        for task, text in texts.values():
            lines += text.splitlines()
            owners += [task] * (len(lines) - len(owners))
        return cls(lines, owners)

    def compiled(
        self, environment: Environment
    ) -> tuple[Mapping[str, TaskSignature], list[tuple[KnownTask, str, Diagnostic]]]:
        """Return the tasks, and each error with its task and the line of task text."""
        compiled, made = compile_library("\n".join(self.lines), environment)
        found: list[tuple[KnownTask, str, Diagnostic]] = []
        for one in compiled.diagnostics:
            number = one.span.line - 1 if one.span else 0
            owner = self.owners[number] if number < len(self.owners) else None
            # a body that uses something of the cell has no parameter of its name, see `text_names`
            if one.is_error and one.code != HIDDEN.code and owner is not None:
                found.append((owner, self.lines[number].strip(), one))
        return made, found


def own_tasks(base: KnowledgeBase) -> tuple[KnownTask, ...]:
    """Return the tasks of a knowledge base that are not of the library."""
    return tuple(task for task in base.tasks() if not task.is_built_in)


def body_findings(
    base: KnowledgeBase, environment: Environment, tasks: Iterable[KnownTask]
) -> tuple[Diagnostic, ...]:
    """Return a finding for each error in bodies of tasks and of all tasks that they call.

    Args:
        base: of the project.
        environment: the cell for which the bodies are compiled.
        tasks: of the knowledge base.
    """
    own = [task.name for task in tasks]
    texts, findings = _texts(_reached(base, own), {})
    _, found = _Bodies.of(texts).compiled(environment) if own else ({}, [])
    for task, line, one in found:
        if one.code != UNKNOWN_TASK.code:  # the knowledge base reports such calls
            message = f"the body of `{task.name}` does not compile: {one.message}"
            notes = (f"its text there: {line}",)
            findings.append(NO_COMPILING.at(_begin(task), message, notes=notes, hint=one.hint))
    return tuple(findings)


def library(
    base: KnowledgeBase, environment: Environment, names: Sequence[str], taken: Collection[str] = ()
) -> Library:
    """Return tasks of a knowledge base as programs call them; names of no task are left out.

    Args:
        base: of the project.
        environment: the cell for which the bodies are compiled.
        names: of tasks.
        taken: names of tasks of the program; a task that only others of the knowledge base call under one of
            these names is renamed, so that each call keeps its callee.
    """
    wanted = [name for name in names if base.task(name) is not None]
    reached = list(_reached(base, wanted))
    others = _other_names(reached, wanted, taken, base.names)
    texts, findings = _texts(reached, others)
    refused = {task.name: _reason(task, error) for task, error in _without_text(reached, findings)}
    for task in reached:
        for name in task.called:
            if base.task(name) is None:
                refused.setdefault(task.name, _reason(task, f"`{name}` is not defined"))
    while True:
        _spread(reached, refused)
        texts = {name: one for name, one in texts.items() if name not in refused}
        bodies = _Bodies.of(texts)
        made, found = bodies.compiled(environment) if texts else ({}, [])
        if not found:
            kept = {name: refused[name] for name in wanted if name in refused}
            called = {others.get(name, name): one for name, one in texts.items()}
            tasks = {name: _told(one, *called[name]) for name, one in made.items()}
            return Library(tasks, kept, "\n".join(bodies.lines) if made else "")
        for task, _, one in found:
            refused.setdefault(task.name, _reason(task, one.message))


def _texts(
    tasks: Iterable[KnownTask], names: Mapping[str, str]
) -> tuple[dict[str, tuple[KnownTask, str]], list[Diagnostic]]:
    """Return each task with its text, and the errors of tasks without a text.

    Args:
        tasks: in their order.
        names: others than their own, by those.
    """
    texts: dict[str, tuple[KnownTask, str]] = {}
    findings: list[Diagnostic] = []
    for task in tasks:
        called = names.get(task.name, task.name)
        try:
            text = task_text(replace(task, name=called, body=renamed_calls(task.body, names)))
            texts[task.name] = task, text
        except TaskError as error:
            findings.append(error.diagnostic)
    return texts, findings


def _other_names(
    reached: Sequence[KnownTask], wanted: Collection[str], taken: Collection[str], known: Collection[str]
) -> Mapping[str, str]:
    """Return another name for each task that has the name of one of the program and that others call."""
    names: dict[str, str] = {}
    for task in reached:
        if task.name in taken and task.name not in wanted:
            name = f"{task.name}_"
            while name in taken or name in known or name in names.values():
                name += "_"
            names[task.name] = name
    return names


def _without_text(
    reached: Sequence[KnownTask], findings: Sequence[Diagnostic]
) -> Iterator[tuple[KnownTask, str]]:
    for one in findings:
        yield from ((task, one.message) for task in reached if task.span == one.span)


def _spread(reached: Sequence[KnownTask], refused: dict[str, str]) -> None:
    """Refuse tasks that call refused ones."""
    is_more = True
    while is_more:
        is_more = False
        for task in reached:
            for name in task.called:
                if name in refused and task.name not in refused:
                    refused[task.name] = f"it calls `{name}`, and {refused[name]}"
                    is_more = True


def _told(signature: TaskSignature, task: KnownTask, text: str) -> TaskSignature:
    """Return a task with the version of its text."""
    return replace(signature, source=_file(task), version=version_of_text(text))


def _file(task: KnownTask) -> str:
    return "/".join(PurePath(task.span.source).parts[-2:])


def _reason(task: KnownTask, message: str) -> str:
    return f"{place_of(task)}: {message}"


def place_of(task: KnownTask) -> str:
    """Return file and line of a task as people name them, such as `kb/glue.pl:3`."""
    return f"{_file(task)}:{task.span.line}"


def _begin(task: KnownTask) -> Span:
    """Return where the clause of a task begins, as far as its name."""
    span = task.span
    return Span.on_line(span.source, span.line, span.column, len(f"task({task.name}"))


def _reached(base: KnowledgeBase, names: Sequence[str]) -> Iterator[KnownTask]:
    """Yield the tasks of these names and their callees; calls of unknown tasks have their finding already."""
    seen: set[str] = set()
    for name in names:
        try:
            reached = needed(base.task, [name])
        except TaskError:
            task = base.task(name)
            reached = (task,) if task is not None else ()
        for one in reached:
            if one.name not in seen:
                seen.add(one.name)
                yield one
