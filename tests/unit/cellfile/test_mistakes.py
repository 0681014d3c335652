"""What a wrong cell file is answered: code, place, words and hint of every kind of mistake."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText

ROBOT = '[robot]\nmodel = "puma560"\n'
BOX = '[[parts]]\nname = "box"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [0, 0, 0]\n'
TOOL = "[tools.jaws]\nposition = [0, 0, 100]\n"


def findings_of(text: str) -> tuple[Diagnostic, ...]:
    cell, findings = read_cell(SourceText("cell.toml", text), "folder")
    assert (cell is None) == any(found.is_error for found in findings)
    return findings


def one(text: str) -> Diagnostic:
    (found,) = findings_of(text)
    return found


def place(found: Diagnostic, text: str) -> str:
    """Return the marked characters."""
    assert found.span is not None
    line = text.split("\n")[found.span.line - 1]
    return line[found.span.column - 1 : found.span.end_column - 1]


CASES = [
    pytest.param(ROBOT + "tol = 3\n", "X802", "tol", "did you mean `tool`?", id="unknown key"),
    pytest.param(ROBOT + "[tool.a]\n", "X802", "tool", "did you mean `tools`?", id="unknown section"),
    pytest.param(ROBOT + "[zzz]\n", "X802", "[zzz]", "known here", id="nothing near"),
    pytest.param(
        "[robot]\nmodell = 'puma560'\n", "X802", "modell", "did you mean `model`?", id="misspelt key"
    ),
    pytest.param("", "X803", "", "add `robot`", id="empty file"),
    pytest.param(
        ROBOT + "[frames.f]\nrpy = [0, 0, 0]\n", "X803", "[frames.f]", "add `position`", id="no position"
    ),
    pytest.param(ROBOT + "speed_override = '1'\n", "X804", "'1'", "", id="text for number"),
    pytest.param(ROBOT + "speed_override = true\n", "X804", "true", "", id="truth for number"),
    pytest.param(ROBOT + "speed_override = 2020-01-01\n", "X804", "2020-01-01", "", id="date for number"),
    pytest.param(ROBOT + "[cell]\nname = 3\n", "X804", "3", "", id="number for text"),
    pytest.param('[[robot]]\nmodel = "puma560"\n', "X804", "[[robot]]", "", id="list for section"),
    pytest.param(ROBOT + "[parts]\n", "X804", "[parts]", "", id="section for list"),
    pytest.param(ROBOT + "[tools]\njaws = 3\n", "X804", "3", "", id="number for named section"),
    pytest.param(ROBOT + "[locations.l]\nposition = [0, 0, 0]\ndown = 1\n", "X804", "1", "", id="1 for true"),
    pytest.param(ROBOT + "[frames.f]\nposition = 3\n", "X804", "3", "", id="number for list"),
    pytest.param(ROBOT + "[frames.f]\nposition = [0, 'a', 0]\n", "X804", "'a'", "", id="text in list"),
    pytest.param(ROBOT + "[frames.f]\nposition = [0, 0]\n", "X805", "[0, 0]", "", id="two coordinates"),
    pytest.param(ROBOT + "start = [0, 0]\n", "X805", "[0, 0]", "", id="two joints of six"),
    pytest.param(ROBOT + "[controller]\nkp = [1]\n", "X805", "[1]", "", id="one gain of six"),
    pytest.param(ROBOT + "[frames.f]\nposition = [0, 2e5, 0]\n", "X806", "2e5", "`[units]`", id="200 m"),
    pytest.param(
        ROBOT + "[frames.f]\nposition = [0, 0x1" + "0" * 400 + ", 0]\n", "X806", None, "", id="huge"
    ),
    pytest.param(ROBOT + TOOL + "mass = 20000\n", "X806", "20000", "", id="20 t"),
    pytest.param(ROBOT + TOOL + "mass = -1\n", "X806", "-1", "", id="negative mass"),
    pytest.param(ROBOT + "speed_override = 0\n", "X806", "0", "", id="no speed"),
    pytest.param(ROBOT + "[controller]\ncontrol_hz = 1\n", "X806", "1", "", id="1 Hz"),
    pytest.param(ROBOT + "[controller]\ncorrection_size = 0\n", "X806", "0", "", id="no correction"),
    pytest.param(ROBOT + "[frames.f]\nposition = [nan, 0, 0]\n", "X807", "nan", "", id="nan"),
    pytest.param(ROBOT + "speed_override = inf\n", "X807", "inf", "", id="inf"),
    pytest.param(ROBOT + "[units]\nlength = 'feet'\n", "X808", "'feet'", "", id="feet"),
    pytest.param('[robot]\nmodel = "puma650"\n', "X860", '"puma650"', "did you mean `puma560`?", id="robot"),
    pytest.param('[robot]\nmodel = ""\n', "X860", '""', "choose one of these names", id="no name"),
    pytest.param(ROBOT + "tool = 'jaw'\n" + TOOL, "X809", "'jaw'", "did you mean `jaws`?", id="unknown tool"),
    pytest.param(
        ROBOT + "[locations.l]\nframe = 'f'\nposition = [0, 0, 0]\n",
        "X809",
        "'f'",
        "none",
        id="unknown frame",
    ),
    pytest.param(ROBOT + "[classic]\nframe = 'f'\n", "X809", "'f'", "none", id="unknown classic frame"),
    pytest.param(ROBOT + BOX + BOX, "X810", '"box"', "line 4", id="same part twice"),
    pytest.param(
        ROBOT + "[signals.a]\ninput = 1\n[signals.b]\ninput = 1\n", "X810", "1", "", id="same channel twice"
    ),
    pytest.param(
        ROBOT + "[frames.f]\nposition = [0, 0, 0]\nquaternion = [1, 1, 0, 0]\n",
        "X811",
        "[1, 1, 0, 0]",
        "w, x, y, z",
        id="no rotation",
    ),
    pytest.param(
        ROBOT + "[frames.f]\nposition = [0, 0, 0]\nrpy = [0, 0, 0]\nquaternion = [1, 0, 0, 0]\n",
        "X812",
        "quaternion",
        "keep one",
        id="two orientations",
    ),
    pytest.param(ROBOT + "[signals.a]\ninput = 1\noutput = 1\n", "X812", "output", "keep", id="in and out"),
    pytest.param(
        ROBOT + TOOL + "mass = 1\ninertia = [1, 1, 3, 0, 0, 0]\n",
        "X813",
        "[1, 1, 3, 0, 0, 0]",
        "kg·m²",
        id="triangle",
    ),
    pytest.param(
        ROBOT + TOOL + "mass = 1\ninertia = [1, 1, 1, 2, 0, 0]\n",
        "X813",
        "[1, 1, 1, 2, 0, 0]",
        "kg·m²",
        id="negative moment",
    ),
    pytest.param(
        ROBOT + TOOL + "inertia = [1, 1, 1, 0, 0, 0]\n",
        "X813",
        "[1, 1, 1, 0, 0, 0]",
        "kg·m²",
        id="inertia without mass",
    ),
    pytest.param(
        ROBOT + "[signals.a]\ninput = 1\nchanges = [[2, 1], [1, 0]]\n", "X814", "[1, 0]", "order", id="order"
    ),
    pytest.param(
        ROBOT + "start = [0, 90, 0, 0, 0, 270]\n", "X815", "270", "home position", id="start beyond limit"
    ),
    pytest.param(
        ROBOT + "[tools.'vacuum cup']\nposition = [0, 0, 0]\n",
        "X816",
        "[tools.'vacuum cup']",
        "letters",
        id="blank in a name",
    ),
    pytest.param(
        ROBOT + "[signals.a]\noutput = 1\nchanges = [[1, 1]]\n", "X817", "changes", "input", id="output"
    ),
    pytest.param(
        ROBOT + "[signals.a]\nchanges = [[1, 1]]\n", "X803", "[signals.a]", "input", id="no direction"
    ),
    pytest.param(ROBOT + "[signals.a]\ninput = 1\ninitial = 0.5\n", "X804", "0.5", "", id="half a bit"),
    pytest.param(
        ROBOT + BOX + "grid = { counts = [0, 2], step = [[1, 0, 0], [0, 1, 0]] }\n",
        "X806",
        "0",
        "",
        id="grid",
    ),
    pytest.param(
        ROBOT + BOX + "grid = { counts = [1, 2], step = [[1, 0, 0]] }\n", "X805", "[[1, 0, 0]]", "", id="step"
    ),
    pytest.param(
        ROBOT + BOX + "grid = { counts = [100, 100, 2], step = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }\n",
        "X805",
        "[100, 100, 2]",
        "",
        id="too many places",
    ),
    pytest.param(
        ROBOT + BOX + "grid = { counts = [101], step = [[100, 0, 0]] }\n", "X806", "101", "", id="long row"
    ),
    pytest.param(
        ROBOT + BOX + "grid = { counts = [1, 2, 3, 4], step = [[1, 0, 0]] }\n",
        "X805",
        "[1, 2, 3, 4]",
        "",
        id="four directions",
    ),
    pytest.param(
        ROBOT + "[locations.a]\nposition = [0.5, 0.3, 0.56]\n",
        "X823",
        "[0.5, 0.3, 0.56]",
        "metres",
        id="place",
    ),
    pytest.param(
        ROBOT + TOOL + "com = [0, 0, 0.095]\n", "X823", "[0, 0, 0.095]", "metres", id="centre of mass"
    ),
    pytest.param(ROBOT + TOOL + "rpy = [0, 0, 3.14159]\n", "X822", "[0, 0, 3.14159]", "180", id="radians"),
    pytest.param(
        ROBOT + BOX.replace("[60, 60, 40]", "[0.06, 0.06, 0.04]"),
        "X824",
        "[0.06, 0.06, 0.04]",
        "metres",
        id="metres",
    ),
]


@pytest.mark.parametrize(("text", "code", "marked", "hint"), CASES)
def test_each_mistake_gets_one_diagnostic_at_its_place(
    text: str, code: str, marked: str | None, hint: str
) -> None:
    found = one(text)
    assert found.code == code
    assert hint in found.hint
    if marked is not None:
        assert place(found, text) == marked


def test_the_message_names_what_was_found_and_what_is_allowed_in_units_of_the_file() -> None:
    found = one(ROBOT + '[units]\nlength = "cm"\n[frames.f]\nposition = [0, 20000, 0]\n')
    assert found.message == "item 2 of `frames.f.position` is 20000 cm, allowed is -10000 to 10000 cm"


def test_every_mistake_of_a_file_is_told_at_once_in_order_of_place() -> None:
    text = ROBOT + "speed = 1\nstart = 'home'\n" + TOOL + "mas = 3\n[sinks]\n"
    assert [found.code for found in findings_of(text)] == ["X802", "X804", "X802", "X804"]
    lines = [found.span.line for found in findings_of(text) if found.span]
    assert lines == sorted(lines)


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("[robot\n", 1, 7),
        ("a = 1\na = 2\n", 2, 6),
        ("model = puma560\n", 1, 9),
        ('x = "open\n', 1, 10),
    ],
)
def test_a_syntax_error_is_told_with_line_and_column(text: str, line: int, column: int) -> None:
    found = one(text)
    assert found.code == "X801"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (line, column)


def test_a_key_that_stands_twice_is_told_so() -> None:
    found = one(ROBOT + ROBOT)
    assert found.message == "not valid TOML: cannot declare `robot` twice"
    assert "second time" in found.hint


def test_deep_nesting_is_an_error_and_no_crash() -> None:
    assert one("a = " + "[" * 100_000).code == "X801"


def test_a_number_with_thousands_of_digits_is_an_error_and_no_crash() -> None:
    found = one("a = " + "9" * 10_000)
    assert found.code == "X801"
    assert "sys." not in found.message


def test_small_offsets_in_millimetres_and_files_in_metres_are_not_doubted() -> None:
    shapes = "shapes = [{ box = [10, 10, 10], position = [0, 0, 0.5] }]\n"
    assert findings_of(ROBOT + TOOL + shapes) == ()
    assert (
        findings_of(ROBOT + "[locations.a]\nposition = [1, 0, 2]\n[locations.b]\nposition = [0, 0, 0]\n")
        == ()
    )
    metres = '[units]\nlength = "m"\nangle = "rad"\n'
    assert (
        findings_of(metres + ROBOT + "[locations.a]\nposition = [0.5, 0.3, 0.56]\nrpy = [0, 0, 3.14159]\n")
        == ()
    )
