"""A new project is named after its folder: in the cell file and in the program named like the example."""

import re
import unicodedata
from pathlib import Path

from ropsim.core import read_bytes
from ropsim.language import RESERVED_WORDS

LONGEST = 60
"""Longest name that is made from the name of a folder [characters]."""

_CELL_NAME = re.compile(
    r'(^\[cell\][ \t]*\r?\n(?:(?!\[).*\r?\n)*?name[ \t]*=[ \t]*)"([^"\\\r\n]*)"', re.MULTILINE
)


def name_from_folder(folder: str) -> str:
    """Return the name that a project in this folder gets: one that a program may have.

    Letters lose their accents, other characters that are no letter, digit or `_` become `_`; `cell_` stands
    before a name that would begin with a digit or be a word of the task language, and before one that is left
    empty.
    """
    plain = unicodedata.normalize("NFKD", folder).encode("ascii", "ignore").decode()
    name = re.sub(r"_+", "_", re.sub(r"\W", "_", plain, flags=re.ASCII)).strip("_")[:LONGEST].strip("_")
    taken = name.lower() in RESERVED_WORDS
    return f"cell_{name}".rstrip("_") if taken or not name or name[0].isdigit() else name


def name_project(folder: Path, name: str) -> None:
    """Set the name of a project; the rest of its texts stays unchanged, including comments and line ends.

    Args:
        folder: of the project, made from an example.
        name: as `name_from_folder` makes it.
    """
    cell = folder / "cell.toml"
    text = _read(cell)
    found = _CELL_NAME.search(text)
    if found is None:
        return
    _write(cell, _CELL_NAME.sub(rf'\g<1>"{name}"', text, count=1))
    header = re.compile(rf"^([ \t]*+program[ \t]+){re.escape(found[2])}\b", re.MULTILINE)
    for program in sorted((folder / "programs").glob("*.task")):
        text = _read(program)
        named = header.sub(rf"\g<1>{name}", text, count=1)
        if named != text:
            _write(program, named)


def _read(path: Path) -> str:
    return read_bytes(path).decode("utf-8")


def _write(path: Path, text: str) -> None:
    path.write_bytes(text.encode("utf-8"))
