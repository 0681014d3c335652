"""Findings as the page gets them."""

from collections.abc import Iterable, Mapping
from dataclasses import asdict

from ropsim.core import Diagnostic


def plain_findings(findings: Iterable[Diagnostic]) -> tuple[Mapping[str, object], ...]:
    """Return findings without a time, as plain JSON values."""
    return tuple(
        {
            "code": one.code,
            "severity": one.severity.value,
            "message": one.message,
            "hint": one.hint,
            "span": None if one.span is None else asdict(one.span),
            "time": None,
        }
        for one in findings
    )
