"""In which call of a task a place of a line stands, in which argument, and how that task is called."""

import re
from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.language import ParameterForm, TaskForm
from ropsim.lsp.analysis import names
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import AtPosition

_CALL = re.compile(
    r"^\s*+(?:\d++\.\s*+)?(?:.*\b(?:then|else)\s++)?(?:call\s++)?([A-Za-z_]\w*+)([ (].*)$",
    re.ASCII | re.IGNORECASE,
)
_NAMED = re.compile(r"\s*([A-Za-z_]\w*)\s*:?=(?!=)", re.ASCII)
_TEXT = re.compile(r'"(?:[^"\\]|\\.)*+("?)')
_NO_PLACE = re.compile(r'["#]|//')


@frozen_dataclass
class CallPlace:
    """A place in the arguments of a call.

    Attributes:
        form: how the task is called.
        index: of the parameter, from 0; beyond the last one where there are too many arguments.
        typed: text of the argument before the place, without the name of its parameter.
        is_inner: whether the place lies in a parenthesis of the argument.
    """

    form: TaskForm
    index: int
    typed: str
    is_inner: bool

    @property
    def parameter(self) -> ParameterForm | None:
        """Return the parameter, None beyond the last one."""
        return self.form.parameters[self.index] if self.index < len(self.form.parameters) else None


def call_place(prefix: str, tasks: Mapping[str, TaskForm]) -> CallPlace | None:
    """Return in which argument of which call the end of a line stands, None outside of calls.

    Args:
        prefix: the line up to the place.
        tasks: how each task is called.
    """
    bare = _TEXT.sub(lambda text: "_" * len(text[0]) if text[1] else text[0], prefix)
    if _NO_PLACE.search(bare):  # in a text that goes on, or in a comment
        return None
    for start in reversed(_open_brackets(bare)):
        form = tasks.get(_word_before(bare, start))
        if form is not None:
            touches = bare[start - 1 : start] not in (" ", "\t")
            arguments = bare[start + 1 :]
            return _place(form, arguments if touches or _is_list(arguments, form) else bare[start:])
    call = _CALL.match(bare)
    form = tasks.get(call[1]) if call is not None else None
    return _place(form, call[2]) if call is not None and form is not None else None


def _word_before(text: str, place: int) -> str:
    """Return the word before a place, blanks between left out; empty for none."""
    end = place
    while end and text[end - 1].isspace():
        end -= 1
    begin = end
    while begin and (text[begin - 1].isalnum() or text[begin - 1] == "_"):
        begin -= 1
    return text[begin:end]


def _open_brackets(text: str) -> list[int]:
    """Return the places of the parentheses that are not closed."""
    found: list[int] = []
    for place, sign in enumerate(text):
        if sign == "(":
            found.append(place)
        elif sign == ")" and found:
            found.pop()
    return found


def _is_list(arguments: str, form: TaskForm) -> bool:
    """Return whether one parenthesis with a blank before it is an argument list and no location."""
    starts_with_location = bool(form.parameters) and form.parameters[0].type == "loc"
    return not starts_with_location or any(_NAMED.match(one) for one in _outer_parts(arguments))


def _place(form: TaskForm, arguments: str) -> CallPlace:
    parts = _outer_parts(arguments)
    last = parts[-1]
    named = _NAMED.match(last)
    names = [one.name for one in form.parameters]
    index = len(parts) - 1
    if named is not None:
        index = names.index(named[1]) if named[1] in names else len(names)
        last = last[named.end() :]
    return CallPlace(form, index, last.strip(), bool(_open_brackets(last)))


def _outer_parts(arguments: str) -> list[str]:
    """Return the texts between the commas outside parentheses."""
    parts, depth, start = [], 0, 0
    for place, sign in enumerate(arguments):
        depth += (sign == "(") - (sign == ")")
        if sign == "," and depth == 0:
            parts.append(arguments[start:place])
            start = place + 1
    return [*parts, arguments[start:]]


def signature_help(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return how the task is called in whose arguments a place stands, None outside of calls."""
    if not is_program(document):
        return None
    prefix = document.line(params.position.line)[: document.column(params.position)]
    place = call_place(prefix, workshop.checked(document, documents).tasks)
    if place is None or not place.form.is_known:
        return None
    form = place.form
    signature: Json = {
        "label": str(form),
        "parameters": [{"label": str(one)} for one in form.parameters],
        "activeParameter": place.index,
    }
    notes = "\n".join(names.task_notes(workshop.outline(document), form.name))
    if notes:
        signature["documentation"] = {"kind": "plaintext", "value": notes}
    return {"signatures": [signature], "activeSignature": 0, "activeParameter": place.index}
