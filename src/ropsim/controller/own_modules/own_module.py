"""A module of a project, which makes entities of the controller; it runs in trusted projects only."""

from traceback import extract_tb

from ropsim.controller.own_modules.module_diagnostics import (
    MODULE_FAILS,
    ModuleError,
    entity_page,
    entity_words,
    untrusted,
)
from ropsim.controller.own_modules.module_loading import ModuleLoading
from ropsim.core import Diagnostic, RopsimError, SourceText
from ropsim.model import ControllerFile


def made_by_module(file: ControllerFile, entry: str, *arguments: object) -> object:
    """Return the result of a function of a module of the project; it and its imports are run anew.

    Args:
        file: the module.
        entry: name of the function.
        arguments: of the function.

    Raises:
        ModuleError: C628, the project is not trusted; C629, the module or its function fails.
    """
    if not file.is_trusted:
        raise ModuleError(untrusted(file, entry))
    loading = ModuleLoading(file)
    try:
        module = loading.module(file.path)
    except (Exception, SystemExit) as error:  # any exception of a user's code is reported
        raise ModuleError(_failure(loading, file, entry, error)) from error
    function = getattr(module, entry, None)
    if not callable(function):
        message = f"`{file.path}` defines no function `{entry}`"
        raise ModuleError(MODULE_FAILS.at(None, message, hint=entity_page(entry)))
    try:
        made: object = function(*arguments)
    except RopsimError:
        raise
    except (Exception, SystemExit) as error:  # any exception of a user's code is reported
        raise ModuleError(_failure(loading, file, entry, error)) from error
    return made


def syntax_finding(text: SourceText) -> Diagnostic | None:
    """Return a finding where a text is no Python; nothing of it is run."""
    try:
        compile(text.text, text.name, "exec", dont_inherit=True)
    except (SyntaxError, ValueError, RecursionError, MemoryError, OverflowError) as error:
        line = getattr(error, "lineno", None) or 1
        span = text.span(min(max(line, 1), len(text.lines) or 1))
        said = getattr(error, "msg", None) or str(error).splitlines()[0]
        return MODULE_FAILS.at(span, f"the module is no Python: {said}")
    return None


def _failure(loading: ModuleLoading, file: ControllerFile, entry: str, error: BaseException) -> Diagnostic:
    """Return the finding that code of a module fails, with the line of it or of the one that it imports."""
    lines = [one.strip() for one in str(error).splitlines() if one.strip()]
    words = f"{type(error).__name__}: {lines[0]}" if lines else type(error).__name__
    places = [
        (one.filename, one.lineno) for one in extract_tb(error.__traceback__) if one.filename in loading.paths
    ]
    if isinstance(error, SyntaxError) and error.filename in loading.paths:
        places.append((error.filename or file.path, error.lineno))
    path, line = places[-1] if places else (file.path, None)
    where = f", line {line}" if line else ""
    message = f"{entity_words(entry)}: `{path}`{where} fails: {words}"
    return MODULE_FAILS.at(None, message, hint=entity_page(entry))
