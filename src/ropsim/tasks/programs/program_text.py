"""A control program from calls: the tasks that they need, and the calls in their order."""

from collections.abc import Callable, Iterable, Sequence
from pathlib import PurePath

from ropsim.tasks.answers.not_defined import not_defined
from ropsim.tasks.kinds import TaskError
from ropsim.tasks.programs.task_text import SHORT, task_text, version_of_text
from ropsim.tasks.terms.known_task import KnownTask
from ropsim.tasks.terms.task_call import TaskCall

UNITS = "mm, deg, s"


def program_text(
    task: Callable[[str], KnownTask | None], calls: Sequence[TaskCall], name: str, units: str = UNITS
) -> str:
    """Return a task text that is complete: it has every task that is called, also by others.

    Args:
        task: the task of a name.
        calls: in their order.
        name: of the program.
        units: of the numbers of the calls.

    Raises:
        TaskError: a task is not defined, or has a body that is no task text.
    """
    parts = [f"program {name}\nunits {units}"]
    parts += map(_copied, needed(task, (call.name for call in calls)))
    parts.append("\n".join(map(str, calls)))
    return "\n\n".join(parts) + "\n"


def _copied(task: KnownTask) -> str:
    """Return the text of a task under a line that says from where it was copied, and which version it is."""
    text = task_text(task)
    file = "/".join(PurePath(task.span.source).parts[-2:])
    return f"# copied from {file}, version {version_of_text(text)[:SHORT]}\n{text}"


def needed(task: Callable[[str], KnownTask | None], names: Iterable[str]) -> tuple[KnownTask, ...]:
    """Return the tasks of these names and all tasks that they call, each once.

    Raises:
        TaskError: one is not defined.
    """
    found: dict[str, KnownTask] = {}
    left = list(dict.fromkeys(names))
    while left:
        name = left.pop(0)
        if name in found:
            continue
        known = task(name)
        if known is None:
            raise TaskError(not_defined(name, found))
        found[name] = known
        left += sorted(known.called)
    return tuple(found.values())
