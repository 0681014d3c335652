"""Near names: what the user may have meant."""

import difflib
from collections.abc import Iterable


def near(name: str, candidates: Iterable[str], limit: int = 3) -> tuple[str, ...]:
    """Return the candidates that look like `name`, best first; case is ignored."""
    by_lower: dict[str, str] = {}
    for candidate in sorted(candidates):
        by_lower.setdefault(candidate.lower(), candidate)
    close = difflib.get_close_matches(name.lower()[:64], list(by_lower), n=limit, cutoff=0.6)
    return tuple(by_lower[key] for key in close)


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """Return "did you mean `x`?", or an empty string where nothing is near."""
    close = near(name, candidates, limit=1)
    return f"did you mean `{close[0]}`?" if close else ""
