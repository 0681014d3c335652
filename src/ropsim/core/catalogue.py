"""The catalogue of diagnostic kinds: every code once, with the page that `ropsim explain` prints."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.core.diagnostic import Category, Diagnostic, Label, Severity, TextEdit
from ropsim.core.frozen_dataclass import frozen_dataclass
from ropsim.core.span import Span

_KINDS: dict[str, "Kind"] = {}
"""By their codes."""

_BY_SLUG: dict[str, "Kind"] = {}


@frozen_dataclass
class Kind:
    """A sort of diagnostic.

    Attributes:
        code: band letter and three digits (`M502`); never reused.
        slug: the pattern found, in kebab case.
        severity: default severity.
        summary: one line for lists.
        explanation: Markdown paragraphs: meaning, importance, remedy.
        category: class of its findings, for programs that treat a class of findings alike.
    """

    code: str
    slug: str
    severity: Severity
    summary: str
    explanation: str
    category: Category = Category.OTHER

    def at(
        self,
        span: Span | None,
        message: str,
        *,
        label: str = "",
        hint: str = "",
        notes: tuple[str, ...] = (),
        secondary: tuple[Label, ...] = (),
        fix: TextEdit | None = None,
        data: Mapping[str, object] | None = None,
    ) -> Diagnostic:
        """Return a diagnostic of this kind at `span`."""
        return Diagnostic(
            self.code,
            self.slug,
            self.severity,
            message,
            span,
            label,
            secondary,
            notes,
            hint,
            fix,
            data or {},
            self.category,
        )


def define(
    code: str,
    slug: str,
    severity: Severity,
    summary: str,
    explanation: str,
    category: Category = Category.OTHER,
) -> Kind:
    """Enter a kind into the catalogue and return it.

    Raises:
        ValueError: the code or the slug is taken by another kind.
    """
    kind = Kind(code, slug, severity, summary, explanation.strip(), category)
    for known in (_KINDS.get(code), _BY_SLUG.get(slug)):
        if known is not None and known != kind:
            raise ValueError(f"diagnostic {code} {slug} collides with {known.code} {known.slug}")
    _KINDS[code] = _BY_SLUG[slug] = kind
    return kind


def catalogue() -> Mapping[str, Kind]:
    """Return all kinds that the imported packages have defined, by code."""
    return MappingProxyType(dict(sorted(_KINDS.items())))
