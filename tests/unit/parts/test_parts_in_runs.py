"""Runs of cells with library parts: each kind as it comes, and a part from a table on a pallet."""

from pathlib import Path

import pytest

from ropsim.parts import PART_KINDS, PartKind, Use
from ropsim.workbench import open_project

ARM = """
[robot]
model = "ur10e"
base = { position = [0, 0, 700] }
tool = "hand"
start = [0, -90, -90, -90, 90, 0]

[signals.go]
output = 1
"""
HAND = '[tools.hand]\npart = { kind = "two_finger_gripper", stroke = 100 }\n'
HEADS = {
    Use.TOOL: "[tools.hand]\n",
    Use.OBJECT: f'{HAND}[[objects]]\nname = "a"\nposition = [-1800, 0, 0]\n',
    Use.CONVEYOR: f'{HAND}[devices.a]\nkind = "conveyor"\nspeed = 100\n'
    "base = { position = [-3000, 0, 800] }\n",
    Use.TURNTABLE: f'{HAND}[devices.a]\nkind = "turntable"\nsignal = "go"\nspeed = 90\nacceleration = 90\n'
    "on = 90\nbase = { position = [-2000, 0, 400] }\n",
}
SHORT = """
program main
units mm, deg, s
set go on
lin here offset (0, 50, 0)
wait 2 s
mov home
"""


def project(tmp_path: Path, cell: str, program: str) -> Path:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(cell, "utf-8")
    (tmp_path / "programs" / "main.task").write_text(program, "utf-8")
    return tmp_path


@pytest.mark.parametrize("kind", PART_KINDS.values(), ids=lambda kind: kind.name)
def test_every_kind_runs_as_it_comes(kind: PartKind, tmp_path: Path) -> None:
    cell = f'{ARM}{HEADS[kind.use]}part = {{ kind = "{kind.name}" }}\n'
    opened = open_project(project(tmp_path, cell, SHORT))
    recording = opened.checked(opened.simulate())
    assert recording.ok
    assert [one.code for one in recording.findings] == []


def test_fingers_take_a_part_from_a_table_to_a_pallet(tmp_path: Path) -> None:
    cell = f"""{ARM}{HAND}
[[objects]]
name = "table"
part = {{ kind = "table", length = 800, width = 600, height = 600 }}
position = [0, 750, 0]

[[objects]]
name = "pallet"
part = {{ kind = "eur_pallet", model = "eur_6" }}
position = [800, 0, 0]

[[parts]]
name = "box"
size = [80, 60, 100]
mass = 2
position = [0, 700, 700]
destination = {{ position = [800, 0, 244] }}
"""
    program = """
program main
units mm, deg, s
mov (0, 700, 0) above 200
lin (0, 700, 0) speed 200 mm/s
close
lin (0, 700, 0) above 200
mov (800, 0, -456) above 400
lin (800, 0, -456) speed 200 mm/s
open
lin (800, 0, -456) above 400
"""
    opened = open_project(project(tmp_path, cell, program))
    recording = opened.checked(opened.simulate())
    assert [one.message for one in recording.findings] == []
    assert recording.ok
