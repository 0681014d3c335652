"""Live runs without real time: a line and a wall clock of a test, and a project with keys."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ropsim.studio.testing import Cancel, Cancelled, LiveFrame, LiveMessage, Order, Report

NIGHT = 1e6
"""The user waits so long after the last order before the test gives up [s]."""


@dataclass
class FakeLine:
    """Gives orders at times of a wall clock that passes only while somebody waits.

    `work` is the time that passes with every look at the clock, as computing takes some.
    """

    plan: Sequence[tuple[float, Order]] = ()
    work: float = 0.0
    wall: float = 0.0
    given: int = 0
    number: int = 1
    reports: list[Report] = field(default_factory=list)

    def report(self, content: Report) -> None:
        self.reports.append(content)

    def orders(self, seconds: float) -> list[Order]:
        plan = sorted(self.plan, key=lambda one: one[0])
        following = plan[self.given][0] if self.given < len(plan) else float("inf")
        self.wall = max(self.wall, min(self.wall + seconds, following))
        due = [order for at, order in plan[self.given :] if at <= self.wall]
        self.given += len(due)
        if any(isinstance(order, Cancel) for order in due) or self.wall > NIGHT:
            raise Cancelled
        return due

    def now(self) -> float:
        self.wall += self.work
        return self.wall

    @property
    def frames(self) -> list[bytes]:
        return [one.content for one in self.reports if isinstance(one, LiveFrame)]

    def messages(self, kind: str) -> list[dict[str, object]]:
        found = [dict(one.payload) for one in self.reports if isinstance(one, LiveMessage)]
        return [one for one in found if one["type"] == kind]


CELL = """\
[robot]
model = "puma560"
tool = "jaws"

[tools.jaws]
position = [0, 0, 120]
mass = 0.5
gripper = { open_time = 0.1, close_time = 0.1, capture = 5 }

[signals.start]
input = 1

[signals.more]
input = 2
changes = [[3.0, 1]]

[signals.level]
input = 3
analog = true

[signals.lamp]
output = 1

[[supplies]]
name = "box"
size = [40, 40, 40]
mass = 0.3
position = [500, -150, 150]
count = 2
"""

KEYS = """\
program keys
units mm, deg
mov joints (0, 60, -150, 0, -60, 0)
wait until start
set lamp on
repeat 2
  mov joints (10, 60, -150, 0, -60, 0)
  if more then
    mov joints (0, 50, -150, 0, -60, 0)
  else
    mov joints (0, 60, -140, 0, -60, 0)
  endif
  wait until not start timeout 0.5 s else set lamp off
endr
"""


def project(folder: Path, program: str = KEYS, cell: str = CELL) -> Path:
    (folder / "programs").mkdir()
    (folder / "programs" / "main.task").write_text(program, "utf-8")
    (folder / "cell.toml").write_text(cell, "utf-8")
    return folder
