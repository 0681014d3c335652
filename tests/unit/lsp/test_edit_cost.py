"""What an edit costs the language server: what it touches, whatever else the text names."""

import shutil
from pathlib import Path

import pytest

from support.editors import Editor, uri_of
from support.large_project import PALLETIZING
from support.work import steps_of

LINES = 3_000
TASK = ("task Visit{k}(part: loc)", "  mov part above 20", "  wait 1 s", "  lin part above 20", "endp")
TOUCHED = 2
"""Line of a task that is edited."""
PER_HINT = 350
"""Lines of the interpreter that it takes to place, order and tell a hint again."""

CASES = {
    "a comment": ("# here we place one and pick another",),
    "50 calls of a library": tuple(f"place (400, 0, {200 + k})" for k in range(50)),
    "an own task with a name of the library": (
        "task place(p: loc)",
        "  lin p",
        "endp",
        "place (400, 0, 300)",
    ),
    "200 hints": tuple(f"x{k} = {k} * 2" for k in range(200)),
}


def text(more: tuple[str, ...]) -> list[str]:
    tasks = [line.format(k=k) for k in range(LINES // len(TASK)) for line in TASK]
    calls = [f"Visit{k} (400, 0, 200)" for k in range(LINES // len(TASK))]
    return ["program main", "units mm, deg, s", *tasks, *more, *calls, "mov home", ""]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("costs") / "cell"
    shutil.copytree(PALLETIZING, made, ignore=shutil.ignore_patterns("out"))
    return made


def cost(folder: Path, more: tuple[str, ...]) -> tuple[int, int]:
    """Return the lines of the interpreter that an edit of one line takes, and how many findings are told."""
    uri, lines, editor = uri_of(folder / "programs" / "main.task"), text(more), Editor()
    found = editor.open(uri, "\n".join(lines))
    assert not [one for one in found if one["severity"] == 1]
    number = LINES // 2 // len(TASK) * len(TASK) + 2 + TOUCHED

    def edit(seconds: int) -> None:
        line = f"  wait {seconds} s"
        editor.type(uri, (number, 0), (number, len(lines[number])), line)
        lines[number] = line
        editor.settle()

    for seconds in (2, 3):
        edit(seconds)
    return steps_of(lambda: edit(4)), len(found)


@pytest.fixture(scope="module")
def plain(folder: Path) -> int:
    return cost(folder, ())[0]


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_an_edit_costs_what_it_touches(folder: Path, plain: int, case: str) -> None:
    found, told = cost(folder, CASES[case])
    assert told == (100 if case == "200 hints" else 0)
    most = 1.3 * plain + (200 * PER_HINT if case == "200 hints" else 0)
    assert found <= most, f"{found} steps, {plain} without"
