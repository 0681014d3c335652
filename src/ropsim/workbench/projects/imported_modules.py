"""Which files of a project its modules in Python import; they are read, nothing of them is run."""

import errno

from ropsim.core import Diagnostic, LeadsOutError, SourceText, outside_project
from ropsim.model import Import, import_folders, imports_in, module_files, places_of
from ropsim.userfiles import MISSING_PATH
from ropsim.workbench.robots.robot_files import TextOf

MOST = 200
"""Further modules are not read; those that import them fail."""


def imported_modules(
    path: str, text: SourceText, text_of: TextOf
) -> tuple[dict[str, SourceText], tuple[Diagnostic, ...]]:
    """Return the modules of a project that one of them imports, by their paths, and what is wrong with them.

    Findings are files that lead out of the project folder or cannot be read, and texts that are no Python.

    Args:
        path: of the module in the project.
        text: of it.
        text_of: reads a file of the project by its path inside.
    """
    from ropsim.controller import syntax_finding  # it generates code, which few projects need

    texts, findings, open_ones = dict[str, SourceText](), list[Diagnostic](), [(path, text)]
    known = {path}
    while open_ones and len(texts) < MOST:
        importer, source = open_ones.pop(0)
        for one in imports_in(source.text):
            if not import_folders(importer, one.level):
                findings.append(_outside(one, source))
            for file, (found, problems) in _files(one, importer, known, text_of):
                known.add(file)
                findings += problems
                if found is not None:
                    texts[file] = found
                    open_ones.append((file, found))
                    findings += [wrong] if (wrong := syntax_finding(found)) else []
    return texts, tuple(findings)


def _files(
    statement: Import, importer: str, known: set[str], text_of: TextOf
) -> "list[tuple[str, tuple[SourceText | None, tuple[Diagnostic, ...]]]]":
    """Return the files that a statement imports and that are not known, with their texts or faults."""
    for folder in import_folders(importer, statement.level):
        found, is_there = [], False
        for place in places_of(statement, folder):
            for file in module_files(place):
                if file in known:
                    is_there = True
                    continue
                text, problems = text_of(file)
                if text is None and all(one.code == MISSING_PATH.code for one in problems):
                    continue
                is_there = True
                found.append((file, (text, problems)))
                break
        if is_there:
            return found
    return []


def _outside(statement: Import, source: SourceText) -> Diagnostic:
    name = f"{'.' * statement.level}{statement.name}"
    error = LeadsOutError(errno.EXDEV, "leads out of the project folder")
    return outside_project(name, error, source.span(statement.line))
