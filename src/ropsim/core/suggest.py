"""Near names: what the user may have meant."""

import difflib
from collections.abc import Iterable


def near(name: str, candidates: Iterable[str], limit: int = 3) -> tuple[str, ...]:
    """Return the candidates that look like `name`, best first; case is ignored.

    A candidate that `name` begins with, or the other way round, comes first: `degrees` means `deg`.
    """
    by_lower: dict[str, str] = {}
    for candidate in sorted(candidates):
        by_lower.setdefault(candidate.lower(), candidate)
    wanted = name.lower()[:64]
    begun = [key for key in by_lower if min(len(key), len(wanted)) >= 3 and _begins(key, wanted)]
    close = difflib.get_close_matches(wanted, list(by_lower), n=limit, cutoff=0.6)
    ordered = dict.fromkeys([*sorted(begun, key=lambda key: abs(len(key) - len(wanted))), *close])
    return tuple(by_lower[key] for key in list(ordered)[:limit])


def _begins(one: str, other: str) -> bool:
    return one.startswith(other) or other.startswith(one)


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """Return "did you mean `x`?", or an empty string where nothing is near."""
    close = near(name, candidates, limit=1)
    return f"did you mean `{close[0]}`?" if close else ""
