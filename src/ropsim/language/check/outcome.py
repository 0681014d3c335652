"""What the checker tells of one body: a task or the control statements, without regard to any other body."""

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language.check.world import NO_ORIGINS, TaskOrigins
from ropsim.program import Block, Local, SignalUse, Task


@frozen_dataclass
class Outcome:
    """A checked body. Places count lines in its unit.

    Attributes:
        block: its statements, as far as they are right.
        locals: its variables.
        task: the whole task; None for the control statements.
        found: findings, in the order in which they were made.
        unread: hints at variables that nothing reads, worth telling where all else is right.
        signals: that it names.
        calls: tasks that it calls, and where.
        late: what no way leads to, and what stands before that.
        impossible: arcs and curves whose points make none.
        origins: what it tells of plain numbers.
    """

    block: Block
    locals: tuple[Local, ...]
    task: Task | None
    found: tuple[Diagnostic, ...]
    unread: tuple[Diagnostic, ...]
    signals: tuple[SignalUse, ...]
    calls: tuple[tuple[str, Span], ...]
    late: tuple[tuple[Span, Span], ...]
    impossible: tuple[Diagnostic, ...]
    origins: TaskOrigins = NO_ORIGINS
