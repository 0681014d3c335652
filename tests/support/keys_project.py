"""A project whose program waits until an input is set and until it is set back."""

from pathlib import Path

CELL = """\
[robot]
model = "puma560"

[signals.start]
input = 1

[signals.level]
input = 2
analog = true

[signals.lamp]
output = 1
"""

PROGRAM = """\
program keys
units mm, deg, s
mov joints (0, 60, -150, 0, -60, 0)
wait until start timeout 60 s else stop "nobody has pressed start"
set lamp on
wait until not start timeout 60 s else stop "nobody has let it go"
mov joints (10, 60, -150, 0, -60, 0)
"""


def keys_project(folder: Path) -> Path:
    """Write the project into a folder and return that."""
    (folder / "programs").mkdir(parents=True)
    (folder / "programs" / "main.task").write_text(PROGRAM, "utf-8")
    (folder / "cell.toml").write_text(CELL, "utf-8")
    return folder
