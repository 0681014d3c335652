"""`ropsim fmt`: write task programs in their form."""

import argparse
import difflib
import sys
from collections.abc import Iterator
from pathlib import Path

from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import (
    Category,
    Diagnostic,
    RopsimError,
    Severity,
    define,
    frozen_dataclass,
    read_bytes,
    replace_file,
    replace_inside,
)
from ropsim.language import formatted
from ropsim.records import diagnostic_document
from ropsim.userfiles import LARGEST, UNREADABLE, read_project_text, read_text_file
from ropsim.workbench import ProjectError, open_project, project_of

NO_TASK_TEXT = define(
    "U902",
    "no-task-text",
    Severity.ERROR,
    "a file that is no task program",
    """
`ropsim fmt` writes task programs (`.task`) in their form. Give such files, a project folder, or `-` for a
text on standard input. ICR is written in its one form by `ropsim icr dis`, the cell file by its author.
""",
    Category.USAGE,
)

_STANDARD_INPUT = "-"
_MARK = b"\xef\xbb\xbf"


class NoTaskTextError(RopsimError):
    """A path that was given is no task program."""


@frozen_dataclass
class _Text:
    """A text and its form.

    Attributes:
        name: its name in messages.
        path: of its file; None for standard input.
        folder: of the project, out of which no link leads; None for a file on its own.
        before: present text.
        form: as it should be.
        mark: byte order mark, if present.
    """

    name: str
    path: Path | None
    folder: Path | None
    before: str
    form: str
    mark: bytes = b""

    @property
    def changes(self) -> bool:
        return self.before != self.form


def fmt(options: argparse.Namespace, output: Output) -> int:
    """Write texts in their form, or say which are not, and return the exit code."""
    found: list[Diagnostic] = []
    texts = [one for path in options.paths for one in _read(path, found)]
    code = output.findings(found, {})
    changed = [one for one in texts if one.changes]
    if options.diff:
        output.text("\n".join(line for one in changed for line in _difference(one)).rstrip("\n"))
    elif options.check:
        for one in changed:
            output.text(f"not in its form: {one.name}")
        if not changed and not code:
            output.text("all texts have their form")
    written = [] if options.check or options.diff else [_written(one, output) for one in texts]
    failed = code or int(options.check and bool(changed))
    output.document(
        {
            "ok": not failed,
            "changed": [one.name for one in changed],
            "written": [name for name in written if name],
            "text": next((one.form for one in texts if one.path is None), None),
            **diagnostic_document(found),
        }
    )
    return failed


def _read(given: str, found: list[Diagnostic]) -> Iterator[_Text]:
    """Yield the task texts of a path; unreadable paths are added to `found`."""
    if given == _STANDARD_INPUT:
        yield from _piped(found)
        return
    path = Path(given)
    folder: Path | None
    if path.is_dir() or path.name == "cell.toml" or not path.exists():
        home = open_project(path).folder
        folder, paths = home, sorted((home / "programs").glob("*.task"))
    elif path.suffix == ".task":
        folder, paths = project_of(path), [path]
    else:
        message = f"`{given}` is neither a project nor a `.task` file"
        raise NoTaskTextError(NO_TASK_TEXT.at(None, message))
    for one in paths:
        text, problems = (
            read_text_file(one, str(one))
            if folder is None
            else read_project_text(folder, f"programs/{one.name}", str(one))
        )
        found += problems
        if text is not None:
            mark = _MARK if read_bytes(one, LARGEST).startswith(_MARK) else b""
            yield _Text(str(one), one, folder, text.text, formatted(text.text), mark)


def _piped(found: list[Diagnostic]) -> Iterator[_Text]:
    try:
        content = sys.stdin.buffer.read(LARGEST + 1)
        if len(content) > LARGEST:
            message = f"standard input has more than {LARGEST / 1e6:.0f} MB"
            found.append(UNREADABLE.at(None, message, hint="is this a program?"))
            return
        text = content.decode()
    except UnicodeDecodeError as error:
        message = f"byte {error.start + 1} of standard input is no UTF-8"
        found.append(UNREADABLE.at(None, message, hint="give UTF-8 text"))
        return
    yield _Text("standard input", None, None, text, formatted(text))


def _difference(one: _Text) -> Iterator[str]:
    lines = (one.before.splitlines(), one.form.splitlines())
    yield from difflib.unified_diff(*lines, one.name, f"{one.name} in its form", lineterm="")


def _written(one: _Text, output: Output) -> str:
    """Write a text where it changes, that of standard input to standard output; return the name of a file."""
    if one.path is None:
        if one.form:
            output.text(one.form.removesuffix("\n"))
        return ""
    if not one.changes:
        return ""
    try:
        content = one.mark + one.form.encode()
        if one.folder is None:
            replace_file(one.path, content)
        else:
            replace_inside(one.folder, f"programs/{one.path.name}", content)
    except OSError as error:
        raise ProjectError(cannot_write(one.name, error)) from error
    output.text(f"formatted {one.name}")
    return one.name
