"""Diagnostics as a plain document for other programs; docs/reference/diagnostics-json.md describes it.

The document only ever grows: entries are added, never renamed or given another meaning.
"""

from collections.abc import Callable, Iterable
from dataclasses import asdict

from ropsim.core import Diagnostic, Severity, Span
from ropsim.records.plain_values import readable

SCHEMA = "ropsim-diagnostics"
VERSION = 1


def diagnostic_document(diagnostics: Iterable[Diagnostic]) -> dict[str, object]:
    """Return the document of all diagnostics, in their order; numbers that are not finite become texts."""
    findings = tuple(diagnostics)
    counts = {
        f"{severity.value}s": sum(finding.severity is severity for finding in findings)
        for severity in Severity
    }
    return {
        "schema": SCHEMA,
        "version": VERSION,
        "counts": counts,
        "diagnostics": [diagnostic_entry(finding, readable) for finding in findings],
    }


def diagnostic_entry(diagnostic: Diagnostic, form: Callable[[object], object]) -> dict[str, object]:
    """Return one diagnostic as a mapping.

    Args:
        diagnostic: the finding.
        form: makes its data plain, see `plain_values`.
    """
    fix = diagnostic.fix
    return {
        "code": diagnostic.code,
        "slug": diagnostic.slug,
        "severity": diagnostic.severity.value,
        "category": diagnostic.category.value,
        "message": diagnostic.message,
        "span": span_entry(diagnostic.span),
        "label": diagnostic.label,
        "secondary": [{"span": span_entry(label.span), "text": label.text} for label in diagnostic.secondary],
        "notes": list(diagnostic.notes),
        "hint": diagnostic.hint,
        "fix": {"span": span_entry(fix.span), "replacement": fix.replacement} if fix else None,
        "data": form(dict(diagnostic.data)),
    }


def span_entry(span: Span | None) -> dict[str, object] | None:
    """Return a span as a mapping, None for none."""
    return asdict(span) if span else None
