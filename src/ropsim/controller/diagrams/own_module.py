"""A module of a project, which makes entities of the controller; it runs in trusted projects only."""

from traceback import extract_tb

from ropsim.controller.diagrams.module_loading import ModuleLoading
from ropsim.controller.law_diagnostics import MODULE_FAILS, MODULE_NOT_TRUSTED, LawError
from ropsim.core import Diagnostic, RopsimError, SourceText
from ropsim.model import LawFile


def made_by_module(file: LawFile, entry: str, *arguments: object) -> object:
    """Return the result of a function of a module of the project; it and its imports are run anew.

    Args:
        file: the module.
        entry: name of the function.
        arguments: of the function.

    Raises:
        LawError: C628, the project is not trusted; C629, the module or its function fails.
    """
    if not file.is_trusted:
        raise LawError(untrusted(file))
    loading = ModuleLoading(file)
    try:
        module = loading.module(file.path)
    except (Exception, SystemExit) as error:  # any exception of a user's code is reported
        raise LawError(_failure(loading, file, error)) from error
    function = getattr(module, entry, None)
    if not callable(function):
        message = f"`{file.path}` defines no function `{entry}`"
        raise LawError(MODULE_FAILS.at(None, message, hint="see docs/how-to/own-controller.md"))
    try:
        made: object = function(*arguments)
    except RopsimError:
        raise
    except (Exception, SystemExit) as error:  # any exception of a user's code is reported
        raise LawError(_failure(loading, file, error)) from error
    return made


def untrusted(file: LawFile) -> Diagnostic:
    """Return the finding that a module stays inert."""
    message = f"`{file.path}` is code of the project and is not run: the folder is not trusted"
    hint = "`ropsim trust PATH` lets it run, if you know where it comes from"
    return MODULE_NOT_TRUSTED.at(None, message, hint=hint, data={"file": file.path})


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


def _failure(loading: ModuleLoading, file: LawFile, error: BaseException) -> Diagnostic:
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
    return MODULE_FAILS.at(None, f"`{path}`{where} fails: {words}", hint="see docs/how-to/own-controller.md")
