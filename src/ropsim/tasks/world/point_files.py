"""The files of lists of points in a project, and their texts in the encodings of spreadsheets."""

from collections.abc import Mapping
from pathlib import Path

from ropsim.core import Diagnostic, LeadsOutError, SourceText, outside_project, place_inside, read_bytes
from ropsim.tasks.findings.text_diagnostics import POINT_LIST
from ropsim.tasks.world.point_list import FORM, PointList, points_of

MOST_BYTES = 20_000_000
_LOOKED_AT = 100
"""Bytes at the beginning that tell UTF-16 without a mark."""
_ENCODINGS = ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"))


def read_point_list(path: Path) -> tuple[PointList | None, tuple[Diagnostic, ...]]:
    """Return the list of a file, None where it cannot be read at all; lines that are wrong are left out."""
    text, findings = _text_of(path, path.as_posix())
    return points_of(text, path.stem) if text is not None else (None, findings)


def point_text_of(folder: Path, path: Path, label: str) -> tuple[SourceText | None, tuple[Diagnostic, ...]]:
    """Return the text of a list of a project under a name, None where it is none.

    It is in UTF-8, in UTF-16, or in Windows-1252 as spreadsheets write it.
    """
    try:
        place_inside(folder, path.relative_to(folder))
    except LeadsOutError as error:
        return None, (outside_project(label, error),)
    return _text_of(path, label)


def _text_of(path: Path, label: str) -> tuple[SourceText | None, tuple[Diagnostic, ...]]:
    try:
        size = path.stat().st_size
        if size > MOST_BYTES:
            message = f"`{label}` has {size / 1e6:.4g} MB, allowed are {MOST_BYTES / 1e6:g} MB"
            return None, (POINT_LIST.at(None, message, hint="cut it into several lists"),)
        content = read_bytes(path, MOST_BYTES)
    except OSError as error:
        return None, (POINT_LIST.at(None, f"`{label}` cannot be read: {error}", hint=FORM),)
    return SourceText(label, decoded(content)), ()


def decoded(content: bytes) -> str:
    """Return the text of some bytes; every content has one, and wrong characters are found in their cells."""
    for mark, encoding in _ENCODINGS:
        if content.startswith(mark):
            return content.decode(encoding, "replace")
    if b"\0" in (begin := content[:_LOOKED_AT]):  # each second byte of UTF-16 is one in the titles
        return content.decode("utf-16-be" if begin[:1] == b"\0" else "utf-16-le", "replace")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("cp1252", "replace")


def read_point_lists(folder: Path) -> tuple[Mapping[str, PointList], tuple[Diagnostic, ...]]:
    """Return the lists in `points/*.csv` of a project by name, and their errors."""
    lists: dict[str, PointList] = {}
    findings: list[Diagnostic] = []
    for path in point_files(folder):
        text, wrong = point_text_of(folder, path, path.as_posix())
        found, more = points_of(text, path.stem) if text is not None else (None, ())
        findings += (*wrong, *more)
        if found is not None:
            lists[found.name] = found
    return lists, tuple(findings)


def point_files(folder: Path) -> tuple[Path, ...]:
    """Return the files of a project that are lists of points, by name."""
    return tuple(sorted(one for one in (folder / "points").glob("*.csv") if one.is_file()))
