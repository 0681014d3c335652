"""Near names: what the user may have meant."""

import difflib
from collections.abc import Iterable
from heapq import nsmallest

MANY = 300
"""So many candidates are compared letter by letter; among more of them those that look alike at a glance."""


def near(name: str, candidates: Iterable[str], limit: int = 3) -> tuple[str, ...]:
    """Return the candidates that look like `name`, best first; case is ignored.

    A candidate with the same letters in another order comes first, then one that `name` begins with, or the
    other way round: `degrees` means `deg`.
    """
    wanted = name.lower()[:64]
    by_lower: dict[str, str] = {}
    for candidate in sorted(_at_a_glance(wanted, tuple(candidates))):
        by_lower.setdefault(candidate.lower(), candidate)
    begun = [key for key in by_lower if min(len(key), len(wanted)) >= 3 and _begins(key, wanted)]
    swapped = [key for key in by_lower if sorted(key) == sorted(wanted)]
    close = difflib.get_close_matches(wanted, list(by_lower), n=limit, cutoff=0.6)
    ordered = dict.fromkeys([*swapped, *sorted(begun, key=lambda key: abs(len(key) - len(wanted))), *close])
    return tuple(by_lower[key] for key in list(ordered)[:limit])


def _at_a_glance(wanted: str, candidates: tuple[str, ...]) -> Iterable[str]:
    """Return all candidates; of very many those of a like length that begin or end with the same letter."""
    if len(candidates) <= MANY:
        return candidates
    alike = (one for one in candidates if one[:1].lower() == wanted[:1] or one[-1:].lower() == wanted[-1:])
    return nsmallest(MANY, alike, key=lambda one: (abs(len(one) - len(wanted)), one))


def _begins(one: str, other: str) -> bool:
    return one.startswith(other) or other.startswith(one)


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """Return "did you mean `x`?", or an empty string where nothing but the name itself is near."""
    close = near(name, (one for one in candidates if one != name), limit=1)
    return f"did you mean `{close[0]}`?" if close else ""
