"""What may stand in the condition that ends a motion: one signal, and what it is compared with."""

import re
from collections.abc import Iterable, Iterator

from ropsim.language import Role
from ropsim.lsp import words
from ropsim.lsp.behind_values import MOTION
from ropsim.lsp.expected import type_of
from ropsim.lsp.items import OPERATOR, item, name_item, some_words
from ropsim.lsp.messages import Json
from ropsim.lsp.names import Known

_BEGUN = re.compile(r"\buntil\s+(not\s+)?$", re.IGNORECASE)
_SIGNAL = re.compile(r"\buntil\s+(?:not\s+)?([A-Za-z_]\w*)\s+$", re.IGNORECASE | re.ASCII)
_NOT = tuple(some_words(words.INNER, ("not",), "1"))
_ORDER = {">": "until SIGNAL > value", "<": "until SIGNAL < value"}


def begun_guard(lead: str, known: Iterable[Known]) -> list[Json] | None:
    """Return what a motion can look at, or what an analog signal is compared by; None at other places.

    Args:
        lead: the statement up to the word that is being typed.
        known: all names.
    """
    if MOTION.match(lead) is None:
        return None
    signals = [one for one in known if one.role is Role.SIGNAL]
    begun = _BEGUN.search(lead)
    if begun is not None:
        digital = [name_item(one, "0") for one in signals if type_of(one) == "bool"]
        return digital if begun[1] is not None else [*digital, *_analog(signals), *_NOT]
    named = _SIGNAL.search(lead)
    if named is not None and any(one.name == named[1] and type_of(one) == "num" for one in signals):
        return [item(sign, OPERATOR, form, "", "1") for sign, form in _ORDER.items()]
    return None


def _analog(signals: Iterable[Known]) -> Iterator[Json]:
    """Yield analog signals, which `not` does not negate."""
    yield from (name_item(one, "0") for one in signals if type_of(one) == "num")
