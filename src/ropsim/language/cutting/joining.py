"""Chunks that are put together to units one after the other: tasks, and parts of the control statements."""

from dataclasses import dataclass, field

from ropsim.language.blocks import units
from ropsim.language.check.calls.tasks import TaskText
from ropsim.language.cutting.chunk_walk import Step
from ropsim.language.cutting.reading import alone_of, control_of
from ropsim.program import Places
from ropsim.query import Database

MOST_ITEMS = 40
"""Of a part of the control statements, unless they are of one piece."""


@dataclass(slots=True)
class Joining:
    """Result for some consecutive chunks.

    Attributes:
        db: database of other results.
        tasks: of them, and where they lie.
        parts: of them that have ended: name of each by how it begins, its lines and blocks, where they lie.
        task_counts: how many tasks each chunk had.
        part_counts: how many parts ended with each chunk.
        free: of each chunk, whether no part goes on behind it.
        items: lines and blocks of the part that has not ended.
        offsets: where their lines lie.
    """

    db: Database
    tasks: list[tuple[TaskText, Places]] = field(default_factory=list)
    parts: list[tuple[str, units.Items, Places]] = field(default_factory=list)
    task_counts: list[int] = field(default_factory=list)
    part_counts: list[int] = field(default_factory=list)
    free: list[bool] = field(default_factory=list)
    items: units.Items = ()
    offsets: list[int] = field(default_factory=list)

    def step(self, step: Step, first: int) -> None:
        """Take the next chunk, which begins with line `first` of the text."""
        self.tasks += [(task.text, Places(first, task.places)) for task in step.read.tasks]
        before = len(self.parts)
        if step.read.control:
            self._take_control(step, first)
        self.task_counts.append(len(step.read.tasks))
        self.part_counts.append(len(self.parts) - before)
        self.free.append(not self.items)

    def end(self) -> None:
        """End the part that has not ended; it may be empty."""
        first = self.offsets[0] if self.offsets else 0
        lying = Places(first, tuple(offset - first for offset in self.offsets))
        self.parts.append((units.name_of(self.items), self.items, lying))
        self.items, self.offsets = (), []

    def _take_control(self, step: Step, first: int) -> None:
        if not self.items:
            alone = self.db.ask(alone_of, step.key)
            if step.chunk.ends_part or alone.ends or len(alone.items) >= MOST_ITEMS:
                self.parts.append((alone.name, alone.items, Places(first + alone.first, alone.offsets)))
                return
        items, offsets, ends = self.db.ask(control_of, step.key, len(self.offsets))
        self.items += items
        self.offsets += [first + offset for offset in offsets]
        if step.chunk.ends_part or ends or len(self.items) >= MOST_ITEMS:
            self.end()
