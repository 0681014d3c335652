"""Findings, skipped moves and messages of the program in the HTML report."""

from collections.abc import Mapping, Sequence

from ropsim.core import SourceText, plural
from ropsim.flow import SkipEvent
from ropsim.views.markup.markup import prose, table, text
from ropsim.views.summary.findings import FindingGroup
from ropsim.views.summary.summary import Summary
from ropsim.views.terminal.columns import Style, Tone
from ropsim.views.terminal.snippet import Mark, snippet
from ropsim.views.words.event_text import event_text
from ropsim.views.words.figures import seconds
from ropsim.views.words.messages import Message

SHOWN_FINDINGS = 200


def findings_section(summary: Summary, sources: Mapping[str, SourceText]) -> str:
    """Return the findings, each with the source line it speaks of."""
    if not summary.findings:
        return "<section><h2>Findings</h2><p>None.</p></section>\n"
    shown = summary.findings[:SHOWN_FINDINGS]
    more = len(summary.findings) - len(shown)
    rest = f"<p>… and {plural(more, 'more finding')}.</p>" if more else ""
    body = "".join(_finding(group, sources) for group in shown)
    return f"<section><h2>Findings</h2>\n{body}{rest}</section>\n"


def _finding(group: FindingGroup, sources: Mapping[str, SourceText]) -> str:
    first = group.first
    where = f" ({prose(group.where)})" if group.where else ""
    repeats = (
        f'<p class="quiet">{plural(group.count, "time")}{where}; the first is shown.</p>'
        if group.count > 1
        else ""
    )
    cause = f'<p class="quiet">{text(group.cause_text)}</p>' if group.cause_text else ""
    notes = "".join(f"<p>{prose(note)}</p>" for note in first.notes)
    hint = f"<p>Hint: {prose(first.hint)}</p>" if first.hint else ""
    severity = first.severity.value
    return (
        f'<div class="finding {severity}"><p class="head"><span class="kind">{severity}'
        f"[{text(first.code)}]</span> {text(first.slug)}: {prose(first.message)}</p>\n"
        f"{_quote(group, sources)}{cause}{notes}{hint}{repeats}</div>\n"
    )


def _quote(group: FindingGroup, sources: Mapping[str, SourceText]) -> str:
    span = group.first.span
    if span is None:
        return ""
    place = f'<p class="quiet">{text(str(span))}</p>'
    source = sources.get(span.source)
    if source is None:
        return place
    mark = Mark(span, group.first.label, "^", Tone.ERROR)
    lines = snippet(source, span, (mark,), len(str(span.end_line)), Style.PLAIN)
    return f"{place}<pre>{chr(10).join(text(line) for line in lines)}</pre>"


def skipped_section(summary: Summary) -> str:
    """Return the list of moves that were left out; empty where there is none."""
    if not summary.skipped:
        return ""
    rows = "".join(_skipped(event) for event in summary.skipped[:SHOWN_FINDINGS])
    more = len(summary.skipped) - SHOWN_FINDINGS
    rest = f"<p>… and {more} more.</p>" if more > 0 else ""
    return f"<section><h2>Skipped moves</h2>\n<ul>{rows}</ul>{rest}</section>\n"


def _skipped(event: SkipEvent) -> str:
    place = f" ({text(str(event.span))})" if event.span else ""
    return f"<li>t = {seconds(event.time)} s: {text(event_text(event))}{place}</li>\n"


SHOWN_MESSAGES = 500


def messages_section(printed: Sequence[Message]) -> str:
    """Return the section on messages of `print`; empty without messages."""
    if not printed:
        return ""
    rows = [
        (seconds(one.time), text(one.place), str(one.visit or ""), text(one.text))
        for one in printed[:SHOWN_MESSAGES]
    ]
    more = len(printed) - len(rows)
    rest = f"<p>… and {plural(more, 'more message')}.</p>" if more > 0 else ""
    listed = table("What <code>print</code> showed.", ("at t [s]", "line", "pass", "text"), rows, "words")
    return f"<section><h2>Messages</h2>\n{listed}{rest}</section>\n"
