"""Names in groups: results of a group are combined once, so that an edit reaches one group of many.

Where a group ends depends on the name there, so that an added or removed name changes its group and no other.
"""

from collections.abc import Iterable
from functools import lru_cache
from zlib import crc32

from ropsim.language.questions.inputs import ORDER, PARTS, TASKS
from ropsim.query import Database

Group = tuple[str, ...]
"""Names that follow each other."""

USUAL = 32
"""Names of a group on average."""
MOST = 40
"""Names of a group at most: an edit costs the rest of its group."""


def grouped(names: Iterable[str]) -> tuple[Group, ...]:
    """Return names in groups."""
    found: list[Group] = []
    group: list[str] = []
    for name in names:
        group.append(name)
        if _number(name) % USUAL == 0 or len(group) == MOST:
            found.append(tuple(group))
            group = []
    return (*found, tuple(group)) if group else tuple(found)


@lru_cache(maxsize=65_536)
def _number(name: str) -> int:
    return crc32(name.encode(errors="surrogatepass"))


def groups(db: Database) -> tuple[Group, ...]:
    """Return the tasks of the text in groups, callees before callers."""
    return grouped(db.read(ORDER))


def text_groups(db: Database) -> tuple[Group, ...]:
    """Return the tasks of the text in groups, in the order of the text."""
    return grouped(db.read(TASKS))


def part_groups(db: Database) -> tuple[Group, ...]:
    """Return the parts of the control statements in groups."""
    return grouped(db.read(PARTS))
