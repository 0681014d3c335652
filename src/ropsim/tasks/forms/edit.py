"""A changed form written into its text: changed fields are written anew, the rest stays unchanged."""

import re

from ropsim.tasks.findings.text_diagnostics import TASK_FORM
from ropsim.tasks.forms.clause import ORDER, FieldFault, FormClause
from ropsim.tasks.terms.clause_text import ClausePlaces

_QUOTED = re.compile(r"0'(?:\\.|''|.)|\"(?:[^\"\\]|\\.|\"\")*\"|'(?:[^'\\]|\\.|'')*'", re.DOTALL)
_COMMENT = re.compile(r"%|/\*")
_NUMBERED = re.compile(r"(?<!\w)_\d+(?!\w)")
"""Variables that Prolog, and so a form, takes for nameless ones."""


def edited(
    text: str, places: ClausePlaces, before: FormClause, after: FormClause
) -> tuple[str, tuple[FieldFault, ...]]:
    """Return a text with the clause of the changed form, and the faults of fields that cannot be written.

    A property with a comment inside is not written anew: a form does not show the comment, and would lose it.
    Nor is one with variables such as `_1`, which a form shows as `_`.

    Args:
        text: present text.
        places: of the clause in it.
        before: clause of the form of the text.
        after: clause of the changed form.
    """
    changes: list[tuple[int, int, str]] = []
    faults: list[FieldFault] = []
    if before.head != after.head:
        changes.append((*places.head, after.head))
    added: list[str] = []
    for name in ORDER:
        new = after.properties.get(name, "")
        if new == before.properties.get(name, ""):
            continue
        if name not in places.properties:
            added.append(new)
            continue
        begin, end = places.properties[name]
        hidden = _hidden(_QUOTED.sub("", text[begin:end]))
        if hidden:
            message = f"`{name}` has {hidden} that a form does not show"
            hint = "change it in the text, or take that out there"
            faults.append(FieldFault(name, 0, TASK_FORM.at(None, message, hint=hint)))
            continue
        changes.append((begin, end, new or (f'{name}("")' if name == "doc" else f"{name}([])")))
    if added:
        changes.append(_addition(places, added))
    for begin, end, new in sorted(changes, reverse=True):
        text = text[:begin] + new + text[end:]
    return text, tuple(faults)


def _hidden(text: str) -> str:
    """Return the part of a text, without quoted parts, that a form does not show; empty if none."""
    if _COMMENT.search(text):
        return "a comment"
    found = _NUMBERED.search(text)
    return f"the variable `{found[0]}`" if found else ""


def _addition(places: ClausePlaces, added: list[str]) -> tuple[int, int, str]:
    """Return where properties that are not there yet are written: behind the last one."""
    inner = ",\n  ".join(added)
    if not places.properties:
        return (*places.inside, f"[\n  {inner}]")
    last = max(end for _, end in places.properties.values())
    return last, last, f",\n  {inner}"
