"""Meant contacts in a cell file: what they say, and what they cannot say."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText

CELL = """
[robot]
model = "puma560"
tool = "peg"
[tools.peg]
position = [0, 0, 60]
shapes = [{ cylinder = { radius = 10, length = 60 }, position = [0, 0, 30] }]
[[objects]]
name = "block"
position = [500, 0, 100]
size = [100, 100, 100]
[[objects]]
name = "cast"
position = [500, 300, 100]
shapes = [{ mesh = "cast.stl" }]
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [300, 300, 40]
[contacts.press]
"""


def found(section: str) -> list[tuple[str, int, str]]:
    """Return code, line in the section, and message of each finding."""
    _, findings = read_cell(SourceText("cell.toml", CELL + section), "folder")
    first = CELL.count("\n")
    return [(one.code, one.span.line - first if one.span else 0, one.message) for one in findings]


def test_a_contact_is_read_in_si_units() -> None:
    text = 'of = "peg"\nwith = ["block", "box", "floor"]\nstiffness = 50\n'
    text += "damping = 0.1\nfriction = 0.4\ndepth = 3\n"
    cell, findings = read_cell(SourceText("cell.toml", CELL + text), "folder")
    assert findings == ()
    assert cell is not None
    (one,) = cell.contacts
    assert (one.name, one.moving, one.standing) == ("press", "peg", ("block", "box", "floor"))
    assert (one.stiffness, one.damping, one.friction, one.depth) == (5e4, 100.0, 0.4, 3e-3)


@pytest.mark.parametrize(
    ("section", "code", "line", "told"),
    [
        ('of = "pin"\nwith = ["block"]\nstiffness = 50\n', "X809", 1, "`pin` is not defined"),
        ('of = "peg"\nwith = ["blok"]\nstiffness = 50\n', "X809", 2, "`blok` is not defined"),
        ('of = "peg"\nwith = ["block", "cast"]\nstiffness = 50\n', "X928", 2, "`cast` is drawn by a mesh"),
        ('of = "box"\nwith = ["box"]\nstiffness = 50\n', "X928", 2, "`box` cannot be pressed on itself"),
        ('of = "peg"\nwith = "block"\nstiffness = 50\n', "X804", 2, "needed is a list of names"),
        ('of = "peg"\nwith = ["block"]\n', "X803", 0, "needs `stiffness`"),
        ('of = "peg"\nwith = ["block"]\nstiffness = -1\n', "X806", 3, "is -1 N/mm"),
        ('of = "peg"\nwith = ["block"]\nstiffness = 50\nfriction = -0.1\n', "X806", 4, "is -0.1"),
        ('of = "peg"\nwith = ["block"]\nstiffness = 50\ndamping = 0\n', "X806", 4, "is 0 N·s/mm"),
        ('of = "peg"\nwith = ["block"]\nstiffness = 50\ndepth = 0\n', "X806", 4, "is 0 mm"),
    ],
)
def test_a_contact_that_cannot_act_is_told(section: str, code: str, line: int, told: str) -> None:
    ((seen, where, message),) = found(section)
    assert (seen, where) == (code, line)
    assert told in message
