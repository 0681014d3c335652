"""Diagnostics as text for a terminal, with the source lines they speak of."""

from collections.abc import Iterable, Mapping

from ropsim.core import Diagnostic, Label, Severity, SourceText, Span, frozen_dataclass, plural
from ropsim.views.summary.findings import FindingGroup, count_text, group_findings
from ropsim.views.terminal.columns import Style, Tone, paint
from ropsim.views.terminal.snippet import Mark, snippet
from ropsim.views.words.characters import clean

TONES = {Severity.ERROR: Tone.ERROR, Severity.WARNING: Tone.WARNING, Severity.HINT: Tone.HINT}
"""The tone of each severity."""
MAX_PLACES = 20
"""Further places that are shown of one finding."""


@frozen_dataclass
class _Place:
    """All marks on one source line or range, shown under one arrow."""

    arrow: str
    span: Span
    marks: tuple[Mark, ...]


def diagnostic_text(diagnostic: Diagnostic, sources: Mapping[str, SourceText], style: Style) -> str:
    """Return one diagnostic as several lines, in the layout of rustc.

    Args:
        diagnostic: the finding.
        sources: the texts by the name that spans use; without its text a place is named, not quoted.
        style: plain or with ANSI colours.
    """
    return _group_text(FindingGroup(diagnostic, 1, ()), sources, style)


def diagnostics_text(
    diagnostics: Iterable[Diagnostic], sources: Mapping[str, SourceText], style: Style
) -> str:
    """Return all diagnostics, repeats put together, and a last line such as `2 errors, 1 warning`.

    The text is empty when there are no diagnostics.
    """
    findings = tuple(diagnostics)
    if not findings:
        return ""
    blocks = [_group_text(group, sources, style) for group in group_findings(findings)]
    worst = min(findings, key=lambda finding: finding.severity.rank).severity
    return "\n\n".join([*blocks, paint(count_text(findings), TONES[worst], style)]) + "\n"


def _group_text(group: FindingGroup, sources: Mapping[str, SourceText], style: Style) -> str:
    diagnostic = group.first
    hidden = len(diagnostic.secondary) - MAX_PLACES
    tone = TONES[diagnostic.severity]
    head = paint(f"{diagnostic.severity.value}[{diagnostic.code}]", tone, style)
    title = paint(f"{diagnostic.slug}: {clean(diagnostic.message)}", Tone.STRONG, style)
    places = _places(diagnostic, tone)
    gutter = max((len(str(place.span.end_line)) for place in places), default=1)
    lines = [f"{head} {title}"]
    for place in places:
        arrow = paint(f"{' ' * gutter}{place.arrow}", Tone.GUTTER, style)
        lines.append(f"{arrow} {clean(str(place.span))}")
        source = sources.get(place.span.source)
        lines += snippet(source, place.span, place.marks, gutter, style) if source else _labels(place)
    if hidden > 0:
        note = f"{plural(hidden, 'further place')} {'is' if hidden == 1 else 'are'} not shown"
        lines.append(f"{' ' * gutter} {paint('=', Tone.GUTTER, style)} note: {note}")
    for word, text in _remarks(group):
        lines.append(f"{' ' * gutter} {paint('=', Tone.GUTTER, style)} {word}: {clean(text)}")
    return "\n".join(lines)


def _places(diagnostic: Diagnostic, tone: Tone) -> tuple[_Place, ...]:
    """Return the primary place first; labels on its own lines join it."""
    further = diagnostic.secondary[:MAX_PLACES]
    if diagnostic.span is None:
        return tuple(_place(label, ":::") for label in further)
    span = diagnostic.span
    joined = [label for label in further if _same_line(label.span, span)]
    others = [label for label in further if not _same_line(label.span, span)]
    marks = [Mark(span, diagnostic.label, "^", tone)]
    marks += [Mark(label.span, label.text, "-", Tone.GUTTER) for label in joined]
    return (_Place("-->", span, tuple(marks)), *(_place(label, ":::") for label in others))


def _place(label: Label, arrow: str) -> _Place:
    return _Place(arrow, label.span, (Mark(label.span, label.text, "-", Tone.GUTTER),))


def _same_line(one: Span, other: Span) -> bool:
    return one.source == other.source and one.line == other.line == one.end_line == other.end_line


def _labels(place: _Place) -> list[str]:
    return [f"   {clean(mark.text)}" for mark in place.marks if mark.text]


def _remarks(group: FindingGroup) -> list[tuple[str, str]]:
    diagnostic = group.first
    remarks = [("note", line) for note in diagnostic.notes for line in note.splitlines()]
    if group.count > 1:
        where = f" ({group.where})" if group.where else ""
        remarks.append(("note", f"found {plural(group.count, 'time')} here{where}; the first is shown"))
    if diagnostic.hint:
        remarks.append(("hint", diagnostic.hint))
    if diagnostic.fix is not None and diagnostic.fix.replacement not in diagnostic.hint:
        remarks.append(("fix", f"replace by `{diagnostic.fix.replacement}`"))
    return remarks
