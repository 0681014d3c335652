"""`ropsim check --watch`: check again whenever a file changes, and report new findings."""

import argparse
import time
from collections import Counter
from collections.abc import Callable, Mapping
from pathlib import Path

from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.stamps import contents, stamps
from ropsim.core import Diagnostic, RopsimError, Severity, SourceText, frozen_dataclass
from ropsim.records import diagnostic_document
from ropsim.views import count_text
from ropsim.workbench import Workspace, open_project, task_findings

PERIOD = 0.3
"""Time between two checks of the files [s]."""


@frozen_dataclass
class Checked:
    """Result of one check.

    Attributes:
        programs: names of the programs.
        diagnostics: all findings.
        texts: sources of the findings.
        code: exit code that they mean.
    """

    programs: tuple[str, ...]
    diagnostics: tuple[Diagnostic, ...]
    texts: Mapping[str, SourceText]
    code: int


def watch(options: argparse.Namespace, output: Output, wait: Callable[[float], None] = time.sleep) -> int:
    """Check a project now and whenever a file of it changes; on Ctrl+C return the code of the last check.

    Args:
        options: with the `path` of a project or a program.
        output: takes the whole of the first check, then new and solved findings.
        wait: lets a time pass [s].
    """
    place = _place(Path(options.path))
    known = stamps(place, time.time_ns(), {})
    workspace = Workspace()
    last = _checked(options.path, workspace)
    _tell(None, last, output)
    try:
        while True:
            wait(PERIOD)
            seen = stamps(place, time.time_ns(), known)
            is_changed = contents(seen) != contents(known)
            known = seen
            if is_changed:
                last = _again(options.path, workspace, last, output)
    except KeyboardInterrupt:
        return last.code


def _place(path: Path) -> Path:
    """Return the folder or file to watch; a program of a project is compiled with its cell."""
    if path.is_file() and (path.name == "cell.toml" or path.parent.name == "programs"):
        return path.parent if path.name == "cell.toml" else path.parent.parent
    return path


def _again(path: str, workspace: Workspace, before: Checked, output: Output) -> Checked:
    try:
        checked = _checked(path, workspace)
    except RopsimError as error:  # the project is not there, or not whole, for the moment
        checked = Checked((), (error.diagnostic,), {}, Output.code_of(error))
    _tell(before, checked, output)
    return checked


def _checked(path: str, workspace: Workspace) -> Checked:
    project = open_project(path, workspace)
    compiled = project.compile()
    more, texts = task_findings(project)
    found = (*compiled.diagnostics, *more)
    is_wrong = any(one.severity is Severity.ERROR for one in found)
    return Checked(tuple(sorted(compiled.programs)), found, {**project.texts, **texts}, int(is_wrong))


def _tell(before: Checked | None, checked: Checked, output: Output) -> None:
    """Report findings that are new since the last check, and the solved ones."""
    known = Counter(_key(one, before.texts) for one in before.diagnostics) if before else Counter[object]()
    new = []
    for one in checked.diagnostics:
        key = _key(one, checked.texts)
        if known[key]:
            known[key] -= 1
        else:
            new.append(one)
    output.findings(new, checked.texts)
    gone = f", {known.total()} gone" if known.total() else ""
    said = count_text(checked.diagnostics) if checked.diagnostics else "no errors"
    output.text(f"checked {', '.join(checked.programs) or 'no program'}: {said}{gone}")
    output.document(
        {
            "ok": not checked.code,
            "programs": list(checked.programs),
            **diagnostic_document(checked.diagnostics),
        }
    )


def _key(one: Diagnostic, texts: Mapping[str, SourceText]) -> object:
    """Return a key that identifies a finding although its line may have moved."""
    text = texts.get(one.span.source) if one.span else None
    line = text.line(one.span.line).strip() if text and one.span else ""
    return one.code, one.message, one.span.source if one.span else "", line
