"""Texts cut into pieces: what is not closed, or closes nothing, takes no more than the lines around it."""

import random
from itertools import accumulate

import pytest

from ropsim import language
from ropsim.language.testing import ENOUGH, MOST_LINES, REACH, Cut, chunks, recut
from ropsim.query import Outcome
from support.tasks import CELL

LINES = [
    line
    for k in range(1, 70)
    for line in (
        f"lin (400, {k}, 300) speed {k} mm/s",
        f"x{k % 9} = count + {k}",
        f"if x{k % 9} > {k} then print count",
        f"repeat {k}",
        "  count = count + 1",
        "endr",
        f"mov (300, 0, {k})",
    )
]
HEAD = ["program p", "units mm, deg", "count = 0"]
MIDDLE = 70
"""Place of a line between two blocks, with many lines below it."""
NEAR = MOST_LINES + REACH
"""Lines that an edit may reach."""


def sizes(lines: list[str]) -> list[int]:
    return [len(chunk.lines) for chunk in chunks(lines)]


def reached(text: list[str], edited: list[str]) -> tuple[int, list[str]]:
    """Return how many lines are read anew after an edit, and the codes of all findings."""
    cache = language.LineCache()
    db = cache.database(CELL, "t.task")
    language.compile("\n".join(text), CELL, "t.task", cache)
    db.events = []
    found = language.compile("\n".join(edited), CELL, "t.task", cache)
    assert found.diagnostics == language.compile("\n".join(edited), CELL, "t.task").diagnostics
    read = [one for one in db.events if one.function == "read_chunk" and one.outcome is not Outcome.REUSED]
    lines = {one.arguments[0] for one in read if isinstance(one.arguments[0], tuple)}
    return sum(map(len, lines)), [one.code for one in found.diagnostics if one.is_error]


@pytest.mark.parametrize(
    ("line", "codes"),
    [
        ("if count > 2", ["L106"]),
        ("repeat 3", ["L106"]),
        ("for i = 1 to 3", ["L106"]),
        ("with speed 100 mm/s", ["L106"]),
        ("endr", ["L107"]),
        ("end", ["L107"]),
        ("else", ["L107"]),
        ("task T(a: int)", ["L106", "N202"]),
    ],
)
def test_a_line_that_opens_or_closes_a_block_reaches_the_lines_around_it(line: str, codes: list[str]) -> None:
    lines, found = reached([*HEAD, *LINES], [*HEAD, *LINES[:MIDDLE], line, *LINES[MIDDLE:]])
    assert found == codes
    assert 0 < lines <= NEAR


@pytest.mark.parametrize("word", ["repeat", "endr"])
def test_an_end_of_a_block_that_is_taken_away_reaches_the_lines_around_it(word: str) -> None:
    place = next(k for k in range(MIDDLE, len(LINES)) if LINES[k].startswith(word))
    lines, found = reached([*HEAD, *LINES], [*HEAD, *LINES[:place], *LINES[place + 1 :]])
    assert len(found) == 1
    assert 0 < lines <= NEAR


def test_a_block_without_end_keeps_its_indented_lines() -> None:
    body = [f"  lin (400, i, {k})" for k in range(2 * MOST_LINES)]
    text = [*HEAD, "for i = 1 to 3", *body, *LINES]
    assert [one.code for one in language.compile("\n".join(text)).diagnostics] == ["L106"]
    assert len(body) < max(sizes(text)) <= len(body) + len(HEAD) + MOST_LINES


def test_a_task_without_end_leaves_the_control_statements_below_it() -> None:
    text = "program p\nunits mm, deg\ntask T(a: int)\n  wait a\nmov (1, 2, 3)\n"
    found = language.compile(text)
    assert [one.code for one in found.diagnostics] == ["L106"]
    assert found.program is not None
    assert len(found.program.main) == 1


@pytest.mark.parametrize("before", [0, 1, 2, 3, 6, 14, 22, 30])
def test_a_misspelt_end_of_a_block_is_mended_wherever_it_stands(before: int) -> None:
    lines = [*HEAD, *LINES[:before], *LINES[7:77]]
    for wrong in (["reapet 3", "open", "endr"], ["repeat 3", "open", "ender"]):
        text = [*lines, *wrong, *LINES[:70]]
        found = [one for one in language.compile("\n".join(text)).diagnostics if one.is_error]
        assert len(found) == 1


@pytest.mark.parametrize("seed", range(10))
def test_no_cut_lies_in_a_block_or_a_statement(seed: int) -> None:
    chance = random.Random(seed)
    lines: list[str] = []
    places: set[int] = set()

    def write(depth: int) -> None:
        indent = "  " * depth * chance.choice([0, 1])
        for _ in range(chance.randrange(1, 12)):
            if depth == 0:
                places.add(len(lines))
            number = chance.randrange(1000)
            match chance.randrange(7):
                case 0 if depth < 4:
                    lines.append(f"{indent}repeat {number}")
                    write(depth + 1)
                    lines.append(indent + chance.choice(["endr", "end", f"until x > {number}"]))
                case 1:
                    lines.extend([f"{indent}x = (1 + # {number} )", f"{indent}  y{number}", ", 3)"])
                case 2:
                    lines.extend([f"{indent}mov (1, 2, \\", f"{indent}lin{number}, 3)"])
                case _:
                    lines.append(f"{indent}lin (1, 2, {number})")

    while len(lines) < 900:
        write(0)
    found = [*accumulate(sizes(lines)[:-1], initial=0)]
    assert len(found) > 1
    assert set(found) <= places


TASKS = [
    line
    for k in range(60)
    for line in (f"task T{k}(a: loc)", f"  lin a speed {k + 1} mm/s", "endp", f"T{k} p")
]
TYPED = [
    "task again",
    "endp",
    "endr",
    "repeat 2",
    "if x",
    "end",
    "needs 3",
    "x = 1 \\",
    "lin (1,",
    "",
    "  y = 2",
]


PLAIN = [line for line in LINES if line.split()[0] not in ("repeat", "endr")]


@pytest.mark.parametrize(
    ("text", "typed"),
    [(LINES, [*TYPED, *LINES]), (TASKS, [*TYPED, *TASKS]), (PLAIN, ["", "x = 1 \\", *PLAIN])],
    ids=["flat", "of tasks", "without blocks"],
)
def test_a_text_that_was_cut_before_is_cut_as_one_that_is_new(text: list[str], typed: list[str]) -> None:
    chance = random.Random(len(text))
    lines, before = list(text), Cut()
    for _ in range(400):
        at = chance.randrange(len(lines))
        lines[at : at + chance.randrange(3)] = chance.choices(typed, k=chance.randrange(3))
        known = before
        before = recut("\n".join(lines), known)
        assert before.chunks == list(chunks(lines))
        assert before.lines == lines
        unchanged = before.unchanged
        assert unchanged.spliced(known.chunks, unchanged.between(before.chunks)) == before.chunks


def test_an_edit_cuts_the_task_around_it_and_no_other() -> None:
    before = recut("\n".join(TASKS), Cut())
    edited = [*TASKS[:121], "  lin a", "  mov a", *TASKS[122:]]
    after = recut("\n".join(edited), before)
    known = {id(chunk.lines) for chunk in before.chunks}
    new = [chunk for chunk in after.chunks if id(chunk.lines) not in known]
    assert 0 < sum(len(chunk.lines) for chunk in new) <= REACH + 12


@pytest.mark.parametrize("at", [0, 200, len(PLAIN) - 1])
@pytest.mark.parametrize("typed", [["open"], ["lin (1, 2, 3)", "close"], []])
def test_an_edit_among_statements_cuts_the_pieces_around_it_and_no_other(at: int, typed: list[str]) -> None:
    before = recut("\n".join(PLAIN), Cut())
    after = recut("\n".join([*PLAIN[:at], *typed, *PLAIN[at + 1 :]]), before)
    known = {id(chunk.lines) for chunk in before.chunks}
    new = [chunk for chunk in after.chunks if id(chunk.lines) not in known]
    assert 0 < len(new) <= 4
    words = ("lin", "if", "mov", "open", "close")  # other lines may go on with the one above them
    assert max(sum(line.startswith(words) for line in chunk.lines) for chunk in after.chunks) <= ENOUGH
