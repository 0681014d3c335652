"""Functions of expressions that need the file: the name space `xacro`."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.exchange.xacro.formulas.meanings import Arguments, Meaning
from ropsim.exchange.xacro.formulas.names import FileOfNames, Names
from ropsim.exchange.xacro.formulas.operators import applied
from ropsim.exchange.xacro.formulas.values import Value, XacroError, words


def _loaded(file: FileOfNames, filename: Value) -> Value:
    return file.loaded(words(filename))


def _argument(file: FileOfNames, name: Value) -> Value:
    return file.argument(words(name))


def _path(file: FileOfNames, filename_spec: Value) -> Value:
    path = words(filename_spec)
    return path if path.startswith("/") or ":" in path else f"{file.directory()}/{path}"


def _dotify(_file: FileOfNames, values: Value) -> Value:
    if not isinstance(values, dict):
        raise XacroError("`xacro.dotify` takes a dictionary")
    return values


def _reported(file: FileOfNames, *parts: Value, **_options: Value) -> Value:
    file.report(" ".join(words(part) for part in parts))
    return ""


def _unreported(_file: FileOfNames, *_parts: Value, **_options: Value) -> Value:
    return ""


def _refused(_file: FileOfNames, *parts: Value) -> Value:
    said = " ".join(words(part) for part in parts)[:200]
    raise XacroError(f"the file refuses itself: {said}", "give the arguments that it wants")


def _tokens(_file: FileOfNames, s: Value, sep: Value = ",; ", **options: Value) -> Value:
    """Return the parts of a text between characters of `sep`."""
    text, separators = words(s), words(sep)
    if not separators:
        raise XacroError("`xacro.tokenize` has no separators")
    for letter in separators[1:]:
        text = text.replace(letter, separators[0])
    parts = text.split(separators[0])
    return [part for part in parts if part or not options.get("skip_empty", True)]


FILE_FUNCTIONS: Mapping[str, Callable[..., Value]] = MappingProxyType(
    {"load_yaml": _loaded, "arg": _argument, "abs_filename": _path, "dotify": _dotify, "tokenize": _tokens}
    | {"warning": _reported, "error": _reported, "message": _unreported, "print_location": _unreported}
    | {"fatal": _refused}
)
"""Functions of `xacro.`, whose first argument is the file."""
DIRECT = ("load_yaml", "arg", "abs_filename", "dotify")
"""Functions that can also be called without `xacro.`."""


def called_in_file(name: str, arguments: Arguments) -> Meaning:
    """Return the result of a function of the file.

    Raises:
        XacroError: there is none of that name.
    """
    function = FILE_FUNCTIONS.get(name)
    if function is None:
        known = ", ".join(sorted(FILE_FUNCTIONS))
        raise XacroError(f"`xacro.{name[:40]}` is not carried out", f"functions of xacro are {known}")
    places, keywords = arguments

    def found(names: Names) -> Value:
        values = [part(names) for part in places]
        given = {key: part(names) for key, part in keywords.items()}
        return applied(f"xacro.{name}", lambda *v, **k: function(names.file, *v, **k), values, given)

    return found
