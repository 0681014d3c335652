"""Programs call tasks of knowledge bases by name: those of the project, of the user and of the library."""

import json
import random
from functools import cache
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.core import Diagnostic, SourceText
from ropsim.flow import Recording
from ropsim.icr import disassemble, encoded, program_id, read_binary, read_text, run
from ropsim.query import Outcome
from ropsim.records import read_recording
from ropsim.spatial import Pose
from ropsim.workbench import (
    NO_TASKS,
    AtStation,
    CompiledProgram,
    TaskTexts,
    Workspace,
    new_project,
    open_overlaid,
    read_task_texts,
)
from ropsim.workbench.testing import Mentions, declared_tasks

CELL = SourceText(
    "cell.toml",
    '[cell]\nname = "c"\nprogram = "p"\n[robot]\nmodel = "puma560"\n[signals.glue]\noutput = 1\n'
    "[locations.bin]\nposition = [300, 200, 500]\n[locations.deck]\nposition = [300, -200, 500]\n",
)
WAVE = "task(wave(L, H), [params([L-location, H-length = 20*mm]), body([mov(above(L, H)), mov(L)])])."
HEAD = "program p\nunits mm, deg, s\n"
CHAIN = 400
"""So many tasks, each calling the next, are more than Python has frames for if each asks for the next one."""


@cache
def workspace() -> Workspace:
    """Return the workspace of all tests, which has one Prolog."""
    made = Workspace()
    made.watch()
    return made


def texts_of(own: tuple[str, ...], users: tuple[str, ...]) -> TaskTexts:
    return TaskTexts(
        tuple(SourceText(f"kb/t{k}.pl", text) for k, text in enumerate(own)),
        tuple(SourceText(f"home/kb/u{k}.pl", text) for k, text in enumerate(users)),
    )


def at(*own: str, users: tuple[str, ...] = ()) -> AtStation:
    """Return the station of the cell beside these texts of tasks."""
    return workspace().at(CELL, "c", "", tasks=texts_of(own, users))


def compiled(text: str, station: AtStation) -> CompiledProgram:
    head = HEAD.partition("units")[0] if text.startswith("units") else HEAD
    return workspace().compiled(SourceText("p.task", head + text), station)


def found(text: str, *own: str, users: tuple[str, ...] = ()) -> tuple[Diagnostic, ...]:
    return compiled(text, at(*own, users=users)).diagnostics


def heights(text: str, *own: str, users: tuple[str, ...] = ()) -> list[float]:
    """Return how high each move of a program goes [mm]."""
    code = compiled(text, at(*own, users=users)).icr
    assert code is not None, found(text, *own, users=users)
    targets = [one.target for one in run(code).moves]
    poses = [one for one in targets if isinstance(one, Pose)]
    assert len(poses) == len(targets)
    return [round(1000 * float(one.position[2]), 6) for one in poses]


def test_a_task_in_the_folder_of_the_project_is_called_like_one_of_the_program() -> None:
    assert heights("wave bin", WAVE) == [520, 500]
    assert heights("wave bin, 5\ncall wave(deck, h = 7)", WAVE) == [505, 500, 507, 500]


def test_a_bare_number_is_in_the_units_of_the_program_that_calls() -> None:
    assert heights("units cm\nwave bin, 5", WAVE) == [550, 500]


def test_tasks_of_project_user_and_library_are_called_in_this_order() -> None:
    def park(height: int) -> str:
        return f"task(park(L), [params([L-location]), body([mov(above(L, {height}*mm))])])."

    assert heights("park bin") == [500]
    assert heights("park bin", users=(park(1),)) == [501]
    assert heights("park bin", park(2), users=(park(1),)) == [502]
    assert heights("task park(l: loc)\n mov l above 3\nendp\npark bin", park(2)) == [503]


def test_tasks_of_a_knowledge_base_call_their_own_though_the_program_has_others_of_these_names() -> None:
    text = "task grip(a: loc)\n  mov a above 9\nendp\ngrip bin\npalletize bin, deck, 5, 1"
    assert heights(text) == [509, 500, 500]
    assert found(text) == ()


def test_calls_are_checked_by_number_and_type_of_their_arguments() -> None:
    assert [one.code for one in found("wave", WAVE)] == ["T303"]
    assert [one.code for one in found("wave bin, 3 s", WAVE)] == ["T302"]
    (near,) = found("wawe bin", WAVE)
    assert (near.code, near.hint) == ("N201", "did you mean `wave`?")


def test_a_call_of_a_task_whose_body_is_wrong_says_where_and_why() -> None:
    glue = "task(bead(L), [params([L-location]), body([mov(L), set(gule, on)])])."
    outer = "task(two(L), [params([L-location]), body([call(bead(L)), open])])."
    (one,) = found("bead bin", "", f"\n{glue}")
    assert (one.code, one.span.line if one.span else 0) == ("N240", 3)
    assert "`bead`" in one.message
    assert "kb/t1.pl:2: there is no output `gule`" in one.message
    (other,) = found("two bin", glue, outer)
    assert "`two`" in other.message
    assert "it calls `bead`" in other.message
    assert found("bead bin", glue.replace("gule", "glue")) == ()


def test_a_copy_of_a_task_in_a_program_is_told_once_the_knowledge_base_has_another() -> None:
    copy = "task wave(l: loc, h: length = 20 mm)\n  mov l above h   # first\n  mov l\nendp\nwave bin"
    assert found(copy, WAVE) == ()
    (one,) = found(copy, WAVE.replace("20*mm", "30*mm"))
    assert (one.code, one.span.line if one.span else 0) == ("P149", 3)
    assert "kb/t0.pl:1" in one.message
    assert found("task grip(a: loc)\n  mov a\nendp\ngrip bin") == ()  # those of the library may be hidden


def test_an_edit_of_a_task_compiles_again_only_the_programs_that_call_it() -> None:
    other = "task(rest(L), [params([L-location]), body([mov(L)])])."
    events = workspace().events
    assert events is not None

    def ran(*own: str) -> bool:
        events.clear()
        compiled("wave bin", at(*own))
        return any(one.function == "translated" and one.outcome is Outcome.RAN for one in events)

    assert ran(WAVE, other)
    assert not ran(WAVE, other.replace("mov(L)", "lin(L)"))
    assert ran(WAVE.replace("mov(L)", "lin(L)"), other)


@pytest.mark.slow
def test_a_long_chain_of_calls_in_a_knowledge_base_compiles_and_again_after_an_edit() -> None:
    def chain(last: str) -> str:
        calls = "\n".join(
            f"task(t{k}(L), [params([L-location]), body([call(t{k + 1}(L))])])." for k in range(CHAIN - 1)
        )
        return f"{calls}\ntask(t{CHAIN - 1}(L), [params([L-location]), body([{last}])])."

    assert heights("t0 bin", chain("mov(L)")) == [500]
    assert heights("t0 bin", chain("mov(above(L, 20*mm))")) == [520]


def test_a_program_that_names_no_task_of_others_starts_no_prolog() -> None:
    fresh = Workspace()
    station = fresh.at(CELL, "c", "", tasks=TaskTexts((SourceText("kb/a.pl", WAVE),)))
    text = SourceText("p.task", f"{HEAD}task grip(a: loc)\n  mov a\nendp\ngrip bin\nmov deck")
    assert fresh.compiled(text, station).diagnostics == ()
    assert fresh._engine._base is None


def test_what_a_task_does_is_told_at_the_line_of_its_call() -> None:
    code = compiled("mov bin\nwave bin", at(WAVE)).icr
    assert code is not None
    lines = [one.origin.span.line if one.origin.span else 0 for one in run(code).moves]
    assert lines == [3, 4, 4]


def test_code_names_the_text_of_each_task_and_its_version_and_keeps_its_identity() -> None:
    text = "wave bin\npark deck\ntask own(l: loc)\n  mov l\nendp\nown bin"
    code = compiled(text, at(WAVE)).icr
    assert code is not None
    assert [(one.procedure, one.source) for one in code.libraries] == [
        ("wave", "kb/t0.pl"),
        ("park", "library/pick.pl"),
    ]
    assert {len(one.version) for one in code.libraries} == {64}
    for again, _ in (read_text(disassemble(code)), read_binary(encoded(code))):
        assert again is not None
        assert again.libraries == code.libraries
        assert again == code
    other = compiled(text, at(WAVE.replace("20*mm", "0.02*m"))).icr
    assert other is not None
    assert program_id(other) == program_id(code)  # it means the same
    assert other.libraries[0].version != code.libraries[0].version
    lines = disassemble(code).splitlines()
    for wrong in ("TASKTEXT wave kb", 'TASKTEXT "" "a" "b"', lines[2]):
        assert read_text("\n".join([*lines[:3], wrong, *lines[3:]]))[0] is None


def test_names_are_looked_for_as_whole_words() -> None:
    many = (*(f"task{k}" for k in range(100)), "bin")
    mentions = Mentions()
    assert mentions.mentioned("t", "wave_ bin\nxwave b", ("wave", "bin")) == ("bin",)
    assert mentions.mentioned("t", "wave_ bin\ncall task7", many) == ("task7", "bin")


def test_names_are_found_in_an_edited_text_as_in_one_that_is_new() -> None:
    chance = random.Random(4)
    pieces = ("wave", "bin", "wave bin", "xwave", "", "# bin", "task7 wave", "3bin", "\r", "bin\rwave")
    few, many = ("wave", "bin"), (*(f"task{k}" for k in range(100)), "bin")
    for names in (few, many):
        mentions, lines = Mentions(), list(pieces)
        for _ in range(200):
            at = chance.randrange(len(lines))
            lines[at : at + chance.randrange(3)] = chance.choices(pieces, k=chance.randrange(3))
            lines = lines or [""]
            text = "\n".join(lines)
            assert mentions.mentioned("t", text, names) == Mentions().mentioned("t", text, names)


def test_texts_tell_at_a_glance_what_prolog_reads_in_them() -> None:
    told = NO_TASKS.told
    base = workspace().knowledge(NO_TASKS)
    assert tuple(told) == base.names
    for task in base.tasks():
        assert told[task.name].doc == task.doc
        assert len(told[task.name].parameters) == len(task.passed)
    assert str(told["pick"]) == "pick(l: location, clear: length = 50 mm)"
    span = told["pick"].span
    assert (Path(span.source).name, span.line, span.column) == ("pick.pl", 3, 6)


@pytest.mark.parametrize(
    "head",
    [
        "task(/* x */ zed(L)",
        "task( % it's\n  /* a */ (zed(L))",
        r"task('z\x65\d'(L)",
        r"task('z\145\d'(L)",
        r"task('z\u0065d'(L)",
        "task('ze\\\nd'(L)",
        "'task'(zed(L)",
        r"'t\x61\sk'(zed(L)",
        'says("/* it\'s"). task(/* x */ zed(L)',
    ],
)
def test_a_task_is_called_however_its_head_is_written(head: str) -> None:
    assert heights("zed bin", f"{head}, [params([L-location]), body([mov(L)])]).") == [500]


def test_texts_without_tasks_or_with_comments_that_do_not_end_tell_none() -> None:
    for text in ("", "a.", "task(/* zed(L)", "task('zed(L)", "'t\\x62\\sk'(zed)", "task('a b'(L))"):
        assert declared_tasks((SourceText("kb/a.pl", text),)) == {}


def test_texts_that_are_not_saved_count_and_users_have_a_folder_of_their_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "home"))
    (tmp_path / "home" / "kb").mkdir(parents=True)
    (tmp_path / "home" / "kb" / "mine.pl").write_text(WAVE)
    new_project(tmp_path / "p")
    (tmp_path / "p" / "kb").mkdir()
    (tmp_path / "p" / "kb" / "b.pl").write_text("")
    texts = read_task_texts(tmp_path / "p", {"kb/a.pl": "home(x).", "kb/b.pl": "home(y)."})
    assert [(one.name, one.text) for one in texts.own] == [("kb/b.pl", "home(y)."), ("kb/a.pl", "home(x).")]
    assert [Path(one.name).name for one in texts.users] == ["mine.pl"]
    program = {"programs/main.task": f"{HEAD}wave (400, 0, 500)\n"}
    project = open_overlaid(tmp_path / "p", program, workspace())
    assert [one for one in project.compile().diagnostics if one.is_error] == []
    (tmp_path / "p" / "programs" / "main.task").write_text(f"{HEAD}wave\n")
    assert main(["check", str(tmp_path / "p")]) == 1
    assert "task `wave` takes 1 to 2 arguments" in capsys.readouterr().err


def test_a_run_says_which_versions_of_which_tasks_it_was_made_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "home"))
    folder = new_project(tmp_path / "p")
    (folder / "kb").mkdir()
    (folder / "programs" / "main.task").write_text(f"{HEAD}wave (400, 0, 500), 5\npark (400, 100, 500)\n")

    def ran(wave: str, *more: str) -> tuple[str, Recording]:
        (folder / "kb" / "own.pl").write_text(wave)
        assert main(["run", str(folder), "--kinematic", "--record", str(tmp_path / "run.npz"), *more]) == 0
        return capsys.readouterr().out, read_recording(tmp_path / "run.npz")

    page = tmp_path / "run.html"
    text, recording = ran(WAVE, "--report", str(page))
    wave, park = recording.facts.stations[0].called
    assert [(one.name, one.source) for one in (wave, park)] == [
        ("wave", "kb/own.pl"),
        ("park", "library/pick.pl"),
    ]
    words = f"tasks of knowledge bases: wave {wave.version[:8]} of kb/own.pl; park {park.version[:8]} of"
    assert words in " ".join(text.split())
    assert [one.version in page.read_text("utf-8") for one in (wave, park)] == [True, True]
    other, changed = ran(WAVE.replace("mov(L)", "lin(L)"), "--json")
    called = changed.facts.stations[0].called
    assert (called[0].version == wave.version, called[1]) == (False, park)
    (station,) = json.loads(other)["summary"]["facts"]["stations"]
    assert station["called"] == [
        {"name": one.name, "source": one.source, "version": one.version} for one in called
    ]


def test_tasks_that_take_the_place_of_others_are_told_in_each_layer() -> None:
    mine = "task(park(L), [params([L-location]), body([mov(above(L, 1*mm))])])."

    def clashes(own: tuple[str, ...], users: tuple[str, ...]) -> list[tuple[str, str, str]]:
        found = workspace().knowledge(texts_of(own, users)).findings
        return [(one.code, one.span.source if one.span else "", one.message) for one in found]

    hidden = "`park` takes the place of the task of the"
    assert clashes((), (mine,)) == [("P146", "home/kb/u0.pl", f"{hidden} library")]
    assert clashes((mine,), (mine,)) == [
        ("P146", "kb/t0.pl", f"{hidden} {whose}") for whose in ("library", "user's own tasks")
    ]
    twice = clashes((mine, mine), ())
    assert ("P135", "kb/t1.pl", "there is a task `park` already") in twice
