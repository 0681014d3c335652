"""The texts of a knowledge base on disk: `kb/*.pl` in the order of `kb/manifest.toml`."""

import tomllib
from pathlib import Path

from ropsim.core import (
    Diagnostic,
    LeadsOutError,
    SourceText,
    did_you_mean,
    outside_project,
    place_inside,
    read_bytes,
)
from ropsim.tasks.findings.text_diagnostics import MANIFEST, UNREADABLE_BASE
from ropsim.tasks.kinds import TaskError

FOLDER, NAME, CELL = "kb", "manifest.toml", "cell.toml"
MOST_FILES, MOST_BYTES = 5000, 8_000_000


def read_folder(path: Path) -> tuple[tuple[SourceText, ...], tuple[Diagnostic, ...]]:
    """Return the texts of a project, a folder or one file in their order, and the errors of the folder.

    A project without a folder `kb` has no texts.

    Raises:
        TaskError: the path does not exist.
    """
    if path.is_file() and path.suffix == ".pl":
        return _read(_root(path.parent), [path])
    if path.is_file() and path.name == CELL:
        path = path.parent
    if not path.is_dir():
        hint = "name a project, its folder `kb`, or a .pl file"
        raise TaskError(UNREADABLE_BASE.at(None, f"`{path}` is no folder and no .pl file", hint=hint))
    is_folder = path.name == FOLDER or not ((path / FOLDER).is_dir() or (path / CELL).is_file())
    folder = path if is_folder else path / FOLDER
    root = _root(folder)
    files = sorted(one for one in folder.glob("*.pl") if one.is_file()) if folder.is_dir() else []
    order, findings = _manifest(root, folder / NAME, [one.name for one in files])
    places = {name: place for place, name in enumerate(order)}
    files.sort(key=lambda one: (places.get(one.name, len(order)), one.name))
    texts, more = _read(root, files)
    return texts, (*findings, *more)


def _root(folder: Path) -> Path:
    """Return the folder in which files of a knowledge base must lie: that of its project, or its own."""
    project = folder.parent
    return project if folder.name == FOLDER and (project / CELL).is_file() else folder


def _read(root: Path, files: list[Path]) -> tuple[tuple[SourceText, ...], tuple[Diagnostic, ...]]:
    texts: list[SourceText] = []
    findings: list[Diagnostic] = []
    left = MOST_BYTES
    for path in files[:MOST_FILES]:
        name = path.as_posix()
        try:
            place_inside(root, path.relative_to(root))
            if path.stat().st_size > left:
                findings.append(
                    UNREADABLE_BASE.at(None, f"`{name}` is left out: more than {MOST_BYTES} bytes in all")
                )
                continue
            content = read_bytes(path, left)
            left -= len(content)
            texts.append(SourceText(name, content.decode("utf-8-sig")))
        except LeadsOutError as error:
            findings.append(outside_project(name, error))
        except OSError as error:
            findings.append(UNREADABLE_BASE.at(None, f"`{name}` cannot be read: {error.strerror or error}"))
        except UnicodeDecodeError as error:
            findings.append(UNREADABLE_BASE.at(None, f"`{name}` is not UTF-8 at byte {error.start}"))
    if len(files) > MOST_FILES:
        findings.append(UNREADABLE_BASE.at(None, f"{len(files)} files; at most {MOST_FILES} are read"))
    return tuple(texts), tuple(findings)


def _manifest(root: Path, path: Path, files: list[str]) -> tuple[list[str], list[Diagnostic]]:
    """Return the order in a manifest; empty without one."""
    if not path.is_file():
        return [], []
    name = path.as_posix()
    hint = 'write `order = ["first.pl", "second.pl"]`'
    try:
        place_inside(root, path.relative_to(root))
        table = tomllib.loads(read_bytes(path, MOST_BYTES).decode("utf-8-sig"))
    except LeadsOutError as error:
        return [], [outside_project(name, error)]
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError, RecursionError) as error:
        return [], [MANIFEST.at(None, f"`{name}` cannot be read: {error}", hint=hint)]
    found = [MANIFEST.at(None, f"`{name}` has no key `{key}`", hint=hint) for key in table if key != "order"]
    order = table.get("order", [])
    if not isinstance(order, list) or not all(isinstance(one, str) for one in order):
        return [], [*found, MANIFEST.at(None, f"`order` in `{name}` is no list of names of files", hint=hint)]
    for one in dict.fromkeys(order):
        if one not in files:
            hint = did_you_mean(one, files) or "the files of the folder itself can be named"
            found.append(MANIFEST.at(None, f"`{name}` names `{one}`, which is not there", hint=hint))
    return list(dict.fromkeys(order)), found
