"""The conditions of geometry that there are: a file for each, and a place in this table."""

from collections.abc import Mapping

from ropsim.tasks.conditions.collision_free import COLLISION_FREE
from ropsim.tasks.conditions.condition import Answer as Answer
from ropsim.tasks.conditions.condition import Condition as Condition
from ropsim.tasks.conditions.reachable import REACHABLE

CONDITIONS: Mapping[str, Condition] = {one.name: one for one in (REACHABLE, COLLISION_FREE)}
"""By their names."""

IN_ROWS = "in_rows"
"""The condition that one of them holds at every place of a pattern."""


def forms() -> str:
    """Return how all are written, for a hint."""
    written = [f"`{one.form}`" for one in CONDITIONS.values()]
    return f"{', '.join(written)} and `{IN_ROWS}(Condition, Columns, Rows, Distance)`"


def examples() -> str:
    """Return how all are written in a task, for a hint."""
    written = [f"`{one.example}`" for one in CONDITIONS.values()]
    first = next(iter(CONDITIONS.values()))
    return f"{', '.join(written)} or `{IN_ROWS}({first.example}, N, M, D)`"
