"""Reading the text files of a project: size, encoding and absence are diagnostics."""

import stat
from pathlib import Path

from ropsim.core import (
    Category,
    Diagnostic,
    LeadsOutError,
    Severity,
    SourceText,
    define,
    did_you_mean,
    outside_project,
    place_inside,
    read_bytes,
)

#: Largest text that is read [bytes].
LARGEST = 5_000_000
MISSING_PATH = define(
    "X840",
    "missing-path",
    Severity.ERROR,
    "a file or folder that is not there",
    """
The path that was given does not exist. Paths are taken relative to the folder in which the command runs.
""",
    Category.USAGE,
)

UNREADABLE = define(
    "X841",
    "unreadable-file",
    Severity.ERROR,
    "a file that cannot be read as text",
    """
Programs and cell files are text in UTF-8. This file cannot be opened, or holds bytes that are no UTF-8: it
may be a binary file, or be saved in another encoding. Save it as UTF-8.
""",
)

TOO_LARGE = define(
    "X842",
    "file-too-large",
    Severity.ERROR,
    "a file that is too large for a text of a project",
    """
Task files, cell files and files of robots are read up to 5 MB, about a hundred thousand lines. A larger file
is most likely another one than was meant.
""",
)


def read_text_file(path: Path, name: str) -> tuple[SourceText | None, tuple[Diagnostic, ...]]:
    """Return the text of a file under the name that messages use, or why it cannot be read."""
    content, findings = read_program_file(path, name)
    if content is None:
        return None, findings
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = (
            f"byte {error.start + 1} (line {line}) of `{name}` is no UTF-8: 0x{content[error.start]:02x}"
        )
        return None, (UNREADABLE.at(None, message, hint="save the file as UTF-8 text"),)
    return SourceText(name, text), ()


def read_project_text(
    folder: Path, inside: str, name: str = ""
) -> tuple[SourceText | None, tuple[Diagnostic, ...]]:
    """Return the text of a file of a project, or why it cannot be read; no link leads out of the project.

    Args:
        folder: of the project.
        inside: path of the file in it.
        name: that messages use; the path inside where nothing is said.
    """
    try:
        place_inside(folder, inside)
    except LeadsOutError as error:
        return None, (outside_project(name or inside, error),)
    except OSError as error:
        return None, (UNREADABLE.at(None, f"`{name or inside}` cannot be opened: {error.strerror}"),)
    return read_text_file(folder / inside, name or inside)


def read_program_file(path: Path, name: str) -> tuple[bytes | None, tuple[Diagnostic, ...]]:
    """Return the bytes of a file that holds a program, or why it cannot be read."""
    try:
        facts = path.stat()
        if not stat.S_ISREG(facts.st_mode):
            message = f"`{name}` is no ordinary file, needed is a text file"
            return None, (UNREADABLE.at(None, message, hint="write the text to a file and give that"),)
        size = facts.st_size
        if size > LARGEST:
            message = f"`{name}` has {size / 1e6:.1f} MB, at most {LARGEST / 1e6:.0f} MB of text are read"
            return None, (TOO_LARGE.at(None, message, hint="is it the file you mean?", data={"bytes": size}),)
        return read_bytes(path, LARGEST), ()
    except FileNotFoundError:
        return None, (missing_file(path, name),)
    except OSError as error:
        return None, (UNREADABLE.at(None, f"`{name}` cannot be opened: {error.strerror or error}"),)


def missing_file(path: Path, name: str) -> Diagnostic:
    """Return the finding for a missing `path` or a dead link, with a near name in its folder."""
    if path.is_symlink():
        message = f"`{name}` is a link, and what it leads to is not there"
        return MISSING_PATH.at(None, message, hint="link to a file that is there, or remove the link")
    folder = path.parent
    beside = [entry.name for entry in folder.iterdir()] if folder.is_dir() else []
    return MISSING_PATH.at(None, f"there is no file or folder `{name}`", hint=did_you_mean(path.name, beside))
