"""Components behind the dot of a location, and of one that a loop takes from a pattern."""

import re
from collections.abc import Iterable, Iterator

from ropsim.language import Role
from ropsim.lsp.expected import type_of
from ropsim.lsp.items import FIELD, NO_VALUES, item
from ropsim.lsp.messages import Json
from ropsim.lsp.names import Known

_OWNER = re.compile(r"([A-Za-z_]\w*)\.$", re.ASCII)
_FOR_EACH = re.compile(r"^\s*for\s+each\b", re.IGNORECASE)
_COORDINATES = ("x", "y", "z", "rx", "ry", "rz")
_PLACES = ("col", "row", "layer")


def members(lead: str, known: Iterable[Known]) -> Iterator[Json]:
    """Yield the components of the name that a line ends with; those of a location where nobody knows it.

    Args:
        lead: the line up to the word that is being typed, with the dot.
        known: all names.
    """
    named = _OWNER.search(lead)
    owner = next((one for one in known if named is not None and one.name == named[1]), None)
    if owner is not None and (owner.role in NO_VALUES or type_of(owner) not in ("loc", "")):
        return
    if owner is not None and owner.role is Role.VARIABLE and _FOR_EACH.match(owner.text):
        for at, name in enumerate(_PLACES):
            yield item(name, FIELD, "place in the pattern, from 1", "", f"0{at}")
    for at, name in enumerate(_COORDINATES):
        yield item(name, FIELD, "coordinate", "", f"1{at}")
