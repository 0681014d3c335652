"""Words of messages: names that the user may have meant, and numbers with their nouns."""

import difflib
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from heapq import merge
from itertools import islice

MANY = 150
"""Number of candidates up to which all are compared letter by letter; of more only similar ones."""

_LONGEST = 64
_Index = Mapping[tuple[str, int], list[str]]


def near(name: str, candidates: Iterable[str], limit: int = 3) -> tuple[str, ...]:
    """Return the candidates that look like `name`, best first; case is ignored.

    A candidate with the same letters in another order comes first, then one that `name` begins with, or the
    other way round: `degrees` means `deg`.
    """
    return _nearest(name, tuple(candidates), limit)


def _nearest(name: str, candidates: tuple[str, ...], limit: int, but: str | None = None) -> tuple[str, ...]:
    """Return the near candidates, of which `but` is none."""
    wanted = name.lower()[:_LONGEST]
    by_lower: dict[str, str] = {}
    for candidate in sorted(_at_a_glance(wanted, candidates)):
        if candidate != but:
            by_lower.setdefault(candidate.lower(), candidate)
    begun = [key for key in by_lower if min(len(key), len(wanted)) >= 3 and _begins(key, wanted)]
    swapped = [key for key in by_lower if sorted(key) == sorted(wanted)]
    close = difflib.get_close_matches(wanted, list(by_lower), n=limit, cutoff=0.6)
    ordered = dict.fromkeys([*swapped, *sorted(begun, key=lambda key: abs(len(key) - len(wanted))), *close])
    return tuple(by_lower[key] for key in list(ordered)[:limit])


def _at_a_glance(wanted: str, candidates: tuple[str, ...]) -> Iterable[str]:
    """Return all candidates; of very many, those with similar length and an equal first or last letter."""
    if len(candidates) <= MANY:
        return candidates
    return islice(_alike(wanted, _index(candidates)), MANY)


def _alike(wanted: str, index: _Index) -> Iterator[str]:
    """Yield the candidates that begin or end with the same letter as a word, the ones of its length first."""
    keys = (f"{wanted[:1]}…", f"…{wanted[-1:]}")
    for distance in range(_LONGEST):
        lengths = {len(wanted) - distance, len(wanted) + distance}
        found = [index.get((key, length), []) for key in keys for length in lengths]
        last = None
        for one in merge(*found):
            if one != last:
                yield one
            last = one


@lru_cache(maxsize=8)
def _index(candidates: tuple[str, ...]) -> _Index:
    """Return candidates by first or last letter and length: many words are searched among the same ones."""
    index: dict[tuple[str, int], list[str]] = {}
    for one in sorted(set(candidates)):
        word = one.lower()
        index.setdefault((f"{word[:1]}…", len(one)), []).append(one)
        index.setdefault((f"…{word[-1:]}", len(one)), []).append(one)
    return index


def _begins(one: str, other: str) -> bool:
    return one.startswith(other) or other.startswith(one)


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """Return "did you mean `x`?", or an empty string if only the name itself is near."""
    close = _nearest(name, tuple(candidates), 1, but=name)
    return f"did you mean `{close[0]}`?" if close else ""


def edit_distance(a: str, b: str) -> int:
    """Return the number of insertions, deletions, replacements and neighbour swaps between two words.

    References:
        F. J. Damerau, A technique for computer detection and correction of spelling errors, 1964
        (restricted form: no part is edited twice).
    """
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        row = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            row.append(cost)
        before, last = last, row
    return last[-1]


def there_are(names: Iterable[str]) -> str:
    """Return "there is only `x`" or "there are `x`, `y`"; an empty string for no names."""
    listed = [f"`{one}`" for one in names]
    if len(listed) == 1:
        return f"there is only {listed[0]}"
    return f"there are {', '.join(listed)}" if listed else ""


def plural(count: int, noun: str) -> str:
    """Return `1 error`, `2 errors`."""
    return f"{count} {noun}{'' if count == 1 else 's'}"
