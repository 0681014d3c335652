"""A whole TOML text: its root table, or why there is none."""

import re
from collections.abc import Mapping
from functools import lru_cache

from ropsim.core import Diagnostic, SourceText, toml_values
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import Findings, TomlTable
from ropsim.tomltext.positions import positions

_KEY_TUPLE = re.compile(r"\((?:'[^']*'(?:, |,)?)+\)")
_KEY = re.compile(r"'([^']*)'")
_PLACE = re.compile(r" \(at (?:line (\d+), column (\d+)|end of document)\)$")


@lru_cache(maxsize=4)
def document_values(text: SourceText) -> Mapping[str, object]:
    """Return the values of a text; the mapping is shared, do not change it.

    Raises:
        tomllib.TOMLDecodeError: it is no TOML.
        RecursionError: values are nested too deeply.
    """
    return toml_values("\n".join(text.lines))


def read_document(text: SourceText) -> tuple[TomlTable | None, tuple[Diagnostic, ...]]:
    """Return the root table of a text, or nothing and the finding that it is no TOML.

    Args:
        text: any text is allowed.
    """
    try:
        values = document_values(text)
        places = positions(text)
    except RecursionError:
        return None, (_too_deep(text),)
    except ValueError as error:
        return None, (_syntax(text, error),)
    return TomlTable(values, (), Findings(places)), ()


def _syntax(text: SourceText, error: ValueError) -> Diagnostic:
    words = str(error)
    place = _PLACE.search(words)
    line, column = len(text.lines), len(text.lines[-1]) + 1
    if place is not None:
        words = words[: place.start()]
        if place[1]:
            line, column = int(place[1]), int(place[2])
    words = _KEY_TUPLE.sub(
        lambda key: f"`{'.'.join(_KEY.findall(key[0]))}`", words.partition("; use sys.")[0]
    )
    hint = 'text needs quotation marks, sections look like `[robot]`, keys like `model = "puma560"`'
    if "overwrite" in words or "twice" in words:
        hint = "the same key or section stands here a second time: remove one"
    message = f"not valid TOML: {words[:1].lower()}{words[1:200]}"
    return kinds.TOML_SYNTAX.at(text.span(line, column), message, hint=hint)


def _too_deep(text: SourceText) -> Diagnostic:
    message = "not valid TOML: lists or tables are nested too deeply"
    return kinds.TOML_SYNTAX.at(text.span(1), message, hint="no value needs more than a few levels")
