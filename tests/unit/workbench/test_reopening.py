"""A project that was compiled before is not compiled again, whatever happened to what was kept of it."""

import random
from pathlib import Path

import pytest

from ropsim import language
from ropsim.core import KeptFiles
from ropsim.query import is_same
from ropsim.workbench import CompiledProject, Workspace, new_project, open_project
from ropsim.workbench.testing import Translation, UnknownFormError, questions, read, written
from support.tasks import CELL

GOLDEN = sorted((Path(__file__).parents[2] / "golden" / "task").glob("*.task"))
LONG = "# a line\n" * questions.LEAST_LINES


class Reopened:
    """A project that is opened by one process after the other."""

    def __init__(self, folder: Path) -> None:
        new_project(folder / "p")
        self.folder = folder / "p"
        self.program = self.folder / "programs" / "main.task"
        self.program.write_text(self.program.read_text("utf-8") + LONG, encoding="utf-8")
        self.answers = folder / "kept"
        self.kept = KeptFiles("kept", 64_000_000, 16_000_000, lambda: folder)
        self.texts: list[str] = []

    def compiled(self) -> CompiledProject:
        """Open and compile the project as a process does that knows nothing, and keep what it found."""
        self.texts.clear()
        workspace = Workspace(self.kept)
        found = open_project(self.folder, workspace).compile()
        workspace.keep()
        return found


@pytest.fixture
def reopened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Reopened:
    """Return a project that was compiled once; `texts` tells what the compiler is given from then on."""
    made = Reopened(tmp_path)
    right = language.compile

    def noted(text: str, *rest: object) -> language.Compiled:
        made.texts.append(text)
        return right(text, *rest)  # type: ignore[arg-type]  # as they come

    monkeypatch.setattr(language, "compile", noted)
    made.compiled()
    assert len(made.texts) == 1
    return made


def test_what_was_compiled_is_not_compiled_again(reopened: Reopened) -> None:
    found = reopened.compiled()
    assert reopened.texts == []
    fresh = open_project(reopened.folder).compile()
    assert is_same(found, fresh)


@pytest.mark.parametrize("name", ["main.task", "cell.toml"])
def test_what_has_changed_is_compiled(reopened: Reopened, name: str) -> None:
    path = reopened.program if name == "main.task" else reopened.folder / name
    before = path.read_text("utf-8")
    more = "\nopen\n" if name == "main.task" else "\n[locations.more]\nposition = [300, 200, 500]\n"
    path.write_text(before + more, encoding="utf-8")
    assert is_same(reopened.compiled(), open_project(reopened.folder).compile())
    assert reopened.texts
    path.write_text(before, encoding="utf-8")
    reopened.compiled()
    assert reopened.texts == []


def test_a_program_that_calls_tasks_is_compiled_again_when_their_texts_have_changed(
    reopened: Reopened,
) -> None:
    (reopened.folder / "kb").mkdir()
    tasks = reopened.folder / "kb" / "own.pl"
    wave = "task(wave(L), [params([L-location]), body([mov(L)])]).\n"
    tasks.write_text(wave, encoding="utf-8")
    text = reopened.program.read_text("utf-8")
    reopened.program.write_text(f"{text}\nwave (400, 0, 500)\n", encoding="utf-8")
    first = reopened.compiled()
    assert len(reopened.texts) == 1
    assert is_same(reopened.compiled(), first)
    assert reopened.texts == []
    tasks.write_text(wave.replace("mov(L)", "lin(L)"), encoding="utf-8")
    assert not is_same(reopened.compiled(), first)
    assert len(reopened.texts) == 1
    tasks.rename(tasks.with_name("other.pl"))  # code names the text of each task
    reopened.compiled()
    assert len(reopened.texts) == 1


def test_another_compiler_does_not_take_the_answers(
    reopened: Reopened, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "compiler_version", lambda: ("another",))
    reopened.compiled()
    assert len(reopened.texts) == 1


def test_findings_are_kept_with_their_places(reopened: Reopened) -> None:
    text = reopened.program.read_text("utf-8")
    reopened.program.write_text(text.replace("mov home", "mov hmoe\nwiat 3"), encoding="utf-8")
    found = reopened.compiled()
    assert not all(not one.is_error for one in found.diagnostics)
    assert is_same(reopened.compiled(), found)
    assert reopened.texts == []


def test_any_damage_costs_time_only(reopened: Reopened) -> None:
    right = reopened.compiled()
    chosen = random.Random(2)
    for _ in range(4):
        for path in reopened.answers.iterdir():
            content = bytearray(path.read_bytes())
            content[chosen.randrange(len(content))] ^= 255
            path.write_bytes(content)
        assert is_same(reopened.compiled(), right)
        assert len(reopened.texts) == 1
        reopened.compiled()
        assert reopened.texts == []


def test_answers_of_other_kinds_are_not_taken(reopened: Reopened) -> None:
    right = reopened.compiled()
    for content in (
        b"",
        b"[]",
        b"3",
        b"[1,2]",
        b'["x",[0,0]]\n',
        b"[[1],[0,1,1,1]]\n\x00",
        written(("not", 1)),
        b"[" * 100_000,
    ):
        for path in list(reopened.answers.iterdir()):
            path.unlink()
            reopened.kept.keep(path.name, content)
        assert is_same(reopened.compiled(), right)


@pytest.mark.parametrize("path", GOLDEN, ids=lambda path: path.stem)
def test_an_answer_has_a_form_that_gives_it_back(path: Path) -> None:
    made = language.compile(path.read_text("utf-8"), CELL, path.name)
    answer = Translation(None, made.diagnostics, made.tasks, made.variables)
    content = written((answer, CELL, 0.0, -0.0, 1, True, 1.0, float("inf")))
    again = read(content)
    assert is_same(again, (answer, CELL, 0.0, -0.0, 1, True, 1.0, float("inf")))
    assert written(again) == content


def test_any_bytes_are_read_or_refused() -> None:
    made = language.compile(GOLDEN[0].read_text("utf-8"), CELL, "t")
    content = written(Translation(made.icr, made.diagnostics, made.tasks, made.variables))
    chosen = random.Random(3)
    refused = 0
    for _ in range(400):
        damaged = bytearray(content)
        for _ in range(chosen.randrange(1, 4)):
            at = chosen.randrange(len(damaged))
            damaged[at : at + chosen.randrange(3)] = chosen.choice((b"0", b"[", b"]", b",", b"-", b"9"))
        try:
            read(bytes(damaged))
        except UnknownFormError:
            refused += 1
    assert refused > 200


@pytest.mark.parametrize(
    "content",
    [
        b"[]",
        b"[[]]",
        b"[[[1]]]",
        b"[[{}]]",
        b"[[1],[0,1,1,1]]\n\xff",
        b"[[1],[0,1,1,1]]\n\x01",
        b"[[1],[0,1,1,1]]\n",
        b"[[1],[0,1,1,1]]\n\x00\x00",
        b"[[1],[-1,1,1,1]]\n\x00",
        b"[[1],[0,0,1,1]]\n\x00",
        b"[[1],[0,2,1,3]]\n\x00\x00\x00",
        b"[[1],[0,1,8,1]]\n\xff\xff\xff\xff\xff\xff\xff\x7f",
        b"[[1],[0,-1,1,1]]\n\x00",
        b'[[1],["a","a","a","a"]]\n\x00',
        b"[[1],[0,1,1,1.0]]\n\x00",
        b"[[1],[0,1,1,true]]\n\x00",
        b"[[1],[0,1,0,1]]\n",
        b"[[1],[0,1,3,1]]\n\x00\x00\x00",
        b"[[1],[0,1,16,1]]\n" + bytes(16),
        b"[[1],[0,1,1,100000000000000000000]]\n\x00",
        b"[[1],[0,1,1]]\n\x00",
        b"[[1],[1,2,1,2]]\n\x00\x00",
        b"[[1],[2,1,1,1]]\n\x00",
        b"[[1],0]\n",
    ],
)
def test_bytes_that_nobody_wrote_are_refused(content: bytes) -> None:
    with pytest.raises(UnknownFormError):
        read(content)


def test_bytes_that_are_refused_are_told_from_those_that_are_not() -> None:
    assert read(b"[[1],[0,1,1,1]]\n\x00") == (1,)
    assert read(b"[[1,2],[0,2,2,2]]\n\x01\x00\xff\xff") == (2, 1)
    wide = tuple(range(70_000))
    assert read(written((wide, wide[::-1]))) == (wide, wide[::-1])


def test_what_has_no_form_is_not_written() -> None:
    with pytest.raises(UnknownFormError):
        written((1, object()))
