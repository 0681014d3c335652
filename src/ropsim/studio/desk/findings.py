"""Findings as the page gets them."""

from collections.abc import Iterable, Mapping

from ropsim.core import Diagnostic
from ropsim.views import plain_finding


def plain_findings(findings: Iterable[Diagnostic]) -> tuple[Mapping[str, object], ...]:
    """Return findings without a time, as plain JSON values."""
    return tuple(plain_finding(one) for one in findings)
