"""A text divided into units, chunk by chunk; results of the chunks on both sides of an edit are reused."""

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import accumulate, compress, count
from operator import is_not

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.language.blocks import units
from ropsim.language.check.calls.tasks import TaskText
from ropsim.language.cutting.chunk_walk import Step, walk_chunks
from ropsim.language.cutting.joined_steps import Trail, joined_again, joined_anew
from ropsim.language.environment import Environment
from ropsim.language.findings import names as name_kinds
from ropsim.language.report import Report
from ropsim.program import Places, SourceMap, placed
from ropsim.query import Database, Splice, splice

_TRAIL = "trail of the division"
"""Input: records of the last division."""


@frozen_dataclass
class Units:
    """A text in units.

    Attributes:
        tasks: names of its tasks, in order.
        parts: names of the units of the statements outside them, in order.
        map: where all units lie.
        opener: where the first line with a statement lies, None where there is none.
        new_tasks: tasks that may have changed, by name; None for a removed one.
        new_parts: the same of the parts, by unit: their lines and blocks.
        new_places: places of units that may have moved, by name; None for a removed one.
    """

    tasks: tuple[str, ...]
    parts: tuple[str, ...]
    map: SourceMap
    opener: Span | None
    new_tasks: Mapping[str, TaskText | None]
    new_parts: Mapping[str, units.Items | None]
    new_places: Mapping[str, Places | None]


def divided(source: SourceText, environment: Environment, report: Report, db: Database) -> Units:
    """Return the units of a text; unreadable lines are reported.

    Raises:
        TooManyFindingsError: the list is full.
    """
    steps = walk_chunks(source, environment, db)
    trail = db.auxiliary(_TRAIL, Trail)
    unchanged = splice(trail.steps, steps, is_not)
    firsts = _firsts(steps, trail.firsts, unchanged)
    found = unchanged.spliced(trail.found, [one.found for one in unchanged.between(steps)])
    for k in compress(count(), found):
        for finding in found[k]:
            report.add(placed(finding, partial(_moved, source=source.name, by=firsts[k] - 1)))
    opener = _opener(source, steps, firsts)
    made = joined_again(steps, firsts, trail, unchanged, db) if trail.is_simple else None
    made = made or joined_anew(steps, firsts, trail, db)
    now = SourceMap(source.name, made.places)
    for name, span in made.doubles:
        message = f"task `{name}` is defined twice"
        report.add(name_kinds.DUPLICATE.at(now.span(span), message, hint="rename one of them"))
    trail.steps, trail.firsts, trail.found = steps, firsts, found
    trail.task_counts, trail.part_counts, trail.free = made.task_counts, made.part_counts, made.free
    trail.tasks, trail.parts, trail.begins = made.tasks, made.parts, made.begins
    trail.places, trail.is_simple = made.places, made.is_simple
    return Units(made.tasks, made.parts, now, opener, made.new_tasks, made.new_parts, made.new_places)


def _firsts(steps: Sequence[Step], known: Sequence[int], unchanged: Splice) -> list[int]:
    """Return the line at which each step begins, and the one behind the last."""
    between = (len(one.chunk.lines) for one in unchanged.between(steps))
    found = [*unchanged.known_above(known), *accumulate(between, initial=known[unchanged.above])]
    rest = unchanged.known_below(known)
    shift = found[-1] - known[len(known) - 1 - unchanged.below]
    return [*found, *(map(shift.__add__, rest) if shift else rest)]


def _opener(source: SourceText, steps: Sequence[Step], firsts: Sequence[int]) -> Span | None:
    for step, first in zip(steps, firsts, strict=False):
        line = step.read.opener
        if line is not None:
            return _moved(line.logical.span(source.name, line.start, line.end), source.name, first - 1)
    return None


def _moved(span: Span, source: str, by: int) -> Span:
    return Span(source, span.line + by, span.column, span.end_line + by, span.end_column)
