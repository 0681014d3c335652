"""Lines read by their shape become what the parser makes of them."""

import random
import re
from pathlib import Path

import pytest

from ropsim.language.testing import Fault, Shapes, Statement, parse_line, parts_of, reader_of, words
from support.examples import examples

FOLDER = Path(__file__).parents[1] / "golden" / "task"
LINES = sorted(
    {
        *(line for path in FOLDER.glob("*.task") for line in path.read_text(encoding="utf-8").split("\n")),
        "lin (100, 20, 300; rpy 180 0 10) speed 150 mm/s acc 2 m/s2  # 3 parts",
        "x1 = 25mm * 3 - 20 mm/2 + x2.z - -4 deg",
        "if x1 > 40 mm and not in2 then print x1",
        "mov p1 above 20 offset (1, 2, 3) in plate2 speed 50 % blend 5",
        "circ via (400, 10, 300) to (400, 20, 300; down, rz 45) angle 270 deg store seen1",
        "lin p1 at 20 mm before end do set out3 on until in4 timeout 2 s",
        "task T1(a1: loc, dz2: length = 10 mm, n) -> int",
        "r1 = T3(4, p1, sqrt(x2))",
        "T1 (400, 0, 7), 20",
        "call T1 p1, n = 3",
        "mov joints(1, 2, 3, 4, 5, -6)",
        "for k1 = 1 to 20 step 2",
        "for each s1 in slots2",
        "pattern slots3 = grid 2 x 3 x 2 from (0, 0, 40) step (70, 50, 10)",
        "repeat 3",
        "3. task T2",
        "x3 = 1e3 + 2.5e-3 * 7",
        "load (x1, y1, z1), p1",
        "needs part at place1",
        "wait until in1 is on timeout 5 s else stop",
        "x1 = atan2(3, 4) + a1.b",
        "// 3 notes",
        "set speed 250 mm/s",
        "p1.z = 30; 4",
    }
)
NUMBERS: tuple[str, ...] = (
    "0",
    "7",
    "20",
    "300",
    "0.5",
    "12.25",
    "1e3",
    "2E-2",
    "007",
    "5.",
    "1_000",
    "3.4.5",
    "1e400",
)
NUMBERS += ("999999999999", "9999999999999", "0.00000000000001", "1234567890123.5")
NAMES = ("x1", "P2", "a_3", "_4", "long_name_56", "s2", "m2", "e5", "x1y2", "mov1", "atan2", "x٣", "é5")
OPEN = re.compile(r"(?<![\w./])([A-Za-z_]+\d\w*|\d[\d.]*)")


def changed(line: str, rng: random.Random) -> str:
    """Return a line with other numbers and names in place of some, mostly of the same sort."""

    def other(match: re.Match[str]) -> str:
        is_number = match[0][0].isdigit() is (rng.random() < 0.95)
        return rng.choice(NUMBERS if is_number else NAMES) if rng.random() < 0.8 else match[0]

    return OPEN.sub(other, line)


@pytest.mark.parametrize("seed", range(examples(8)))
def test_a_line_is_read_by_its_shape_as_the_parser_reads_it(seed: int) -> None:
    rng = random.Random(seed)
    shapes = Shapes(many=1)
    for line in LINES:
        for one in (line, *(changed(line, rng) for _ in range(12))):
            assert shapes.parsed(one) == parse_line(one)
            assert repr(shapes.parsed(one)) == repr(parse_line(one))  # 1 is no 1.0 there


@pytest.mark.parametrize(
    "line", [line for line in LINES if line.startswith(("lin (", "x1 = 25", "mov", "if x1"))]
)
def test_usual_lines_have_a_shape(line: str) -> None:
    statement, _ = parse_line(line)
    assert statement is not None
    reader = reader_of(parts_of(line), statement)
    assert reader is not None
    further = line.replace("20", "34567.5").replace("x2", "x_further_3").replace("p1", "part12345")
    assert reader(parts_of(further)) == parse_line(further)[0]


def test_a_line_with_another_statement_for_other_numbers_has_no_shape() -> None:
    """The counts of a grid are whole numbers of their own, and prose is kept as it is written."""
    for line in ("pattern slots = grid 2 x 3 from (0, 0, 4) step (70, 50, 10)", "needs part at place1"):
        statement, _ = parse_line(line)
        assert statement is not None
        assert reader_of(parts_of(line), statement) is None


def test_no_word_with_digits_means_anything() -> None:
    known = {
        *words.RESERVED,
        *words.INSIDE,
        *words.MOTION_MODIFIERS,
        *words.NOT_YET,
        *words.NOT_YET_MODIFIERS,
    }
    assert not [word for word in known if any(map(str.isdigit, word))]


def test_a_shape_is_learned_from_many_lines_only(monkeypatch: pytest.MonkeyPatch) -> None:
    parsed: list[str] = []

    def counted(line: str) -> tuple[Statement | None, Fault | None]:
        parsed.append(line)
        return parse_line(line)

    monkeypatch.setattr("ropsim.language.syntax.shapes.parse_line", counted)
    shapes = Shapes(many=3)
    lines = [f"mov (400, 0, {k})" for k in range(5)]
    for line in (*lines, "mov (400, 0, 7 % 3)", "mov (400, 0, x7)", "mov (400, 0, 8)"):
        shapes.parsed(line)
    assert parsed == [*lines[:3], "mov (400, 0, 7 % 3)", "mov (400, 0, x7)"]
