"""`ropsim generate`: a control program of tasks, points and parameters entered one by one."""

import argparse
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from errno import EEXIST
from pathlib import Path

from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import RopsimError, create_inside
from ropsim.prolog import Prolog
from ropsim.tasks import (
    Draft,
    KnowledgeBase,
    KnownTask,
    Parameter,
    Point,
    PointList,
    TaskCall,
    TaskError,
    Value,
    added,
    default_text,
    draft_points,
    draft_text,
    not_defined,
    read_point_lists,
    taken_back,
    typed_points,
    typed_values,
    unchecked_text,
    unknown_location,
    wrong_value,
)
from ropsim.workbench import open_knowledge

END, BACK = "end", "undo"
HEAD = (
    "Type the tasks to be included in this program, `end` to terminate, `undo` to take the last one back;\n"
    "either in place of a point or parameter leaves out the task that asks for it."
)


class _LeftOutError(Exception):
    """A task is cancelled by the user."""


@dataclass(slots=True)
class _Desk:
    """Context of the dialogue: the tasks, lists of points by name, chosen tasks, time limit [s]."""

    base: KnowledgeBase
    lists: Mapping[str, PointList]
    draft: Draft
    output: Output
    seconds: float


def generate(options: argparse.Namespace, output: Output) -> int:
    """Read tasks until `end`, then print or write the program; return the exit code."""
    known = open_knowledge(options.path, Prolog(options.prolog))
    folder = Path(options.path)
    output.findings((one for one in known.findings if one.is_error), known.texts)
    lists, findings = read_point_lists(folder)
    output.findings(findings, {})
    desk = _Desk(known.base, lists, Draft(known.state), output, options.seconds)
    output.text(HEAD)
    while (name := _asked("TASK NAME")) not in (None, END):
        if name == BACK:
            desk.draft = taken_back(desk.draft)
        elif name:
            _choose(desk, name)
        _show(desk)
    if not desk.draft.calls:
        output.text("no task was accepted: there is no program")
        return 1
    text = draft_text(desk.draft, desk.base, options.name)
    output.text(f"\n{text.rstrip()}\n\n{unchecked_text(desk.draft.unchecked)}")
    return _written(folder, options.name, text, draft_points(desk.draft), output) if options.write else 0


def _choose(desk: _Desk, name: str) -> None:
    """Read points and parameters of one task and report at once whether it is possible."""
    task = desk.base.task(name)
    if task is None:
        desk.output.failure(not_defined(name, desk.base.names))
        return
    try:
        call = TaskCall(name, _points(desk, task), _parameters(desk, task))
        desk.draft = added(desk.draft, desk.base, call, desk.seconds)
    except _LeftOutError:
        return
    except RopsimError as error:
        desk.output.failure(error.diagnostic)
        return
    desk.output.findings(desk.draft.entries[-1].warnings, {})


def _points(desk: _Desk, task: KnownTask) -> tuple[Point, ...]:
    """Return the points that are typed: names of locations or lists, or X Y Z [Pitch Roll [Yaw]]."""
    wanted = [_words(one) for one in task.passed if one.kind == "location"]
    found: list[Point] = []
    while len(found) < len(wanted):
        line = _answer(f"POINT {wanted[len(found)]}, by name or X Y Z [Pitch Roll [Yaw]] in mm and deg")
        if not line:
            break
        points = typed_points(line, desk.lists)
        names = (one for one in points if isinstance(one, str))
        unknown = filter(None, (unknown_location(one, desk.draft.state) for one in names))
        if wrong := next(unknown, None):
            desk.output.failure(wrong)
        else:
            found += points
    return tuple(found)


def _parameters(desk: _Desk, task: KnownTask) -> tuple[Value, ...]:
    """Return the parameters that are typed; an empty line leaves the rest to their defaults."""
    wanted = [one for one in task.passed if one.kind != "location"]
    found: list[Value] = []
    while len(found) < len(wanted):
        line = _answer(f"PARAMETER {_words(wanted[len(found)])}")
        if not line:
            break
        try:
            values = typed_values(line, task)
        except TaskError as error:
            desk.output.failure(error.diagnostic)
            continue
        pairs = zip(wanted[len(found) :], values, strict=False)
        if wrong := next(filter(None, (wrong_value(task, one, value) for one, value in pairs)), None):
            desk.output.failure(wrong)
        else:
            found += values
    return tuple(found)


def _answer(prompt: str) -> str | None:
    """Return the input for a task.

    Raises:
        _LeftOutError: the task is cancelled.
    """
    line = _asked(prompt)
    if line in (BACK, END):
        raise _LeftOutError
    return line


def _words(parameter: Parameter) -> str:
    """Return the words of a prompt: word and unit, known bounds, and the meaning of an empty line."""
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    default = f"{default_text(parameter)} if left blank" if parameter.default is not None else ""
    more = ", ".join(filter(None, (parameter.sentence, *map(str, parameter.bounds), default)))
    return f"{parameter.label}{unit}{f' ({more})' if more else ''}"


def _show(desk: _Desk) -> None:
    """Print the state for each task."""
    rows = [(str(one.call), one) for one in desk.draft.entries]
    width = max((len(call) for call, _ in rows), default=0)
    for call, one in rows:
        desk.output.text(f"  {call:{width}}  {one.message}")
        for hint in dict.fromkeys(finding.hint for finding in one.findings if finding.hint):
            desk.output.text(f"  {'':{width}}    = {hint}")


def _asked(prompt: str) -> str | None:
    """Return the input behind a prompt, None at the end of the input."""
    print(f"{prompt}: ", end="", flush=True)
    line = sys.stdin.readline(1000)
    return line.strip() if line else None


def _written(folder: Path, name: str, text: str, points: str, output: Output) -> int:
    """Write program and points into the project and return the exit code.

    Raises:
        TaskError: one of the files is there already, or cannot be written.
    """
    files = {folder / "programs" / f"{name}.task": text, folder / "points" / f"{name}.csv": points}
    for path in files:
        if path.exists():
            raise TaskError(cannot_write(str(path), FileExistsError(EEXIST, "it is there already")))
    for path, content in files.items():
        try:
            create_inside(folder, path.relative_to(folder), content.encode())
        except OSError as error:
            raise TaskError(cannot_write(str(path), error)) from error
        output.text(f"wrote {path}")
    return 0
