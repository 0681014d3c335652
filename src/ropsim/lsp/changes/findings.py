"""Findings as the protocol has them, and the changes that would mend them."""

import re

from ropsim.core import Diagnostic, Severity, Span, TextEdit
from ropsim.language import FIRST_LINE
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json

_SEVERITIES = {Severity.ERROR: 1, Severity.WARNING: 2, Severity.HINT: 4}
_DID_YOU_MEAN = re.compile(r"did you mean `([^`]+)`\?")
_WORD = re.compile(r"(?P<quote>[\"']?)(?P<word>[A-Za-z_][\w-]*)(?P=quote)")


def diagnostic(found: Diagnostic, document: Document) -> Json:
    """Return a finding in the protocol's form; its hint stands on a line of its own."""
    words = [found.message, *found.notes, *([found.hint] if found.hint else [])]
    made: Json = {
        "range": document.range_of(found.span),
        "severity": _SEVERITIES[found.severity],
        "code": found.code,
        "source": "ropsim",
        "message": "\n".join(words),
    }
    related = [
        {
            "location": {"uri": document.uri, "range": document.range_of(label.span)},
            "message": label.text,
        }
        for label in found.secondary
        if label.span.source == document.name
    ]
    if related:
        made["relatedInformation"] = related
    data: Json = {"hint": found.hint}
    if FIRST_LINE in found.data:
        data["firstLine"] = found.data[FIRST_LINE]
    edit = fix_of(found, document)
    if edit is not None:
        data["fix"] = {"title": fix_title(edit), **_change(edit, document)}
    made["data"] = data
    return made


def fix_of(found: Diagnostic, document: Document) -> TextEdit | None:
    """Return the change that mends a finding: its own, else the near name of its hint for a marked word."""
    if found.fix is not None:
        return found.fix
    span = found.span
    near = _DID_YOU_MEAN.match(found.hint)
    if near is None or span is None or span.line != span.end_line:
        return None
    marked = document.line(span.line - 1)[span.column - 1 : span.end_column - 1]
    wrong, right = _WORD.fullmatch(marked), _WORD.fullmatch(near[1])
    if wrong is None or right is None or wrong["word"] == near[1]:
        return None
    return TextEdit(span, f"{wrong['quote']}{near[1]}{wrong['quote']}")


def fix_title(edit: TextEdit) -> str:
    """Return the title of a fix, in a few words."""
    return f"replace by `{edit.replacement}`" if edit.replacement else "remove"


def code_actions(found: Diagnostic, document: Document) -> list[Json]:
    """Return the quick fixes of a finding."""
    edit = fix_of(found, document)
    if edit is None:
        return []
    action: Json = {
        "title": fix_title(edit),
        "kind": "quickfix",
        "diagnostics": [diagnostic(found, document)],
        "isPreferred": True,
        "edit": {"changes": {document.uri: [_change(edit, document)]}},
    }
    return [action]


def touches(span: Span | None, first: int, last: int) -> bool:
    """Return whether a span reaches into the lines from `first` to `last` (from 0, both included)."""
    return span is None or (span.line - 1 <= last and first <= span.end_line - 1)


def _change(edit: TextEdit, document: Document) -> Json:
    return {"range": document.range_of(edit.span), "newText": edit.replacement}
