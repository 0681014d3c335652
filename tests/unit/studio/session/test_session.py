"""A session with its tabs; a toy stands in for the simulator."""

import os
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from support.session_pages import Page, in_session


def test_a_page_is_told_everything_and_the_first_run_begins_by_itself(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        welcome = await first.hear("welcome")
        assert welcome["editing"] is True
        assert (welcome["project"], welcome["programs"], welcome["program"]) == ("cell", ["main"], "main")
        assert [(one["name"], one["text"]) for one in welcome["documents"]] == [
            ("cell.toml", "[cell]\n"),
            ("programs/main.task", "x\n"),
        ]
        assert welcome["documents"][1]["uri"] == (folder / "programs" / "main.task").as_uri()
        assert welcome["trust"] == {"trusted": False, "code": ["controllers/evil.py"]}
        await first.hear("run", state="done", id=1)

    in_session(folder, play)


def test_an_edit_is_known_to_all_and_simulated(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first, second = await page("a"), await page("b")
        await second.hear("welcome", editing=False)
        await first.say(type="edit", document="programs/main.task", text="new\n", version=5)
        mine, theirs = await first.hear("documents"), await second.hear("documents")
        assert [mine["documents"][0][key] for key in ("text", "version", "unsaved")] == [None, 5, True]
        assert theirs["documents"][0]["text"] == "new\n"
        done = await first.hear("run", state="done", id=2)
        assert first.session.runs.pack(done["id"]) == b"new\n|0"
        assert (folder / "programs" / "main.task").read_text("utf-8") == "x\n"  # nothing was saved

    in_session(folder, play)


def test_a_tab_that_comes_later_hears_of_scene_and_run(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.hear("run", state="done", id=1)
        for name, kind in (("b", "scene"), ("c", "run")):  # a tab each: either may come first
            await (await page(name)).hear(kind)

    in_session(folder, play)


def test_steps_of_a_page_are_answered_and_then_timed_and_a_lost_worker_is_told(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="edit", document="cell.toml", text="[cell]\n#\n", version=1)
        await first.say(type="open_tasks")
        assert (await first.hear("task_list"))["unsaved"] == ["cell.toml"]
        steps: list[dict[str, object]] = [
            {"name": name, "points": [], "values": []} for name in ("pick", "place")
        ]
        await first.say(type="check_tasks", id=4, steps=steps)
        assert (await first.hear("tasks_checked", id=4))["text"] == "pick place"
        assert (await first.hear("tasks_estimated", id=4))["program"] == "pick place"
        await first.say(type="check_tasks", id=5, steps=[{**steps[0], "name": "crash"}])
        assert "exit code 3" in (await first.hear("tasks_checked", id=5))["problem"]
        await first.say(type="check_tasks", id=6, steps=steps)
        await first.hear("tasks_checked", id=6)

    in_session(folder, play)


def test_the_time_of_a_program_gives_way_to_the_question_of_another_tab(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first, second = await page("a"), await page("b")
        await first.say(type="check_tasks", id=1, steps=[{"name": "slow", "points": [], "values": []}])
        await first.hear("tasks_checked", id=1)
        await second.say(type="check_tasks", id=1, steps=[{"name": "pick", "points": [], "values": []}])
        await second.hear("tasks_estimated", program="pick")
        await first.hear("tasks_estimated", program="slow")

    in_session(folder, play)


def test_what_a_page_says_in_a_live_run_reaches_the_worker(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="live_start", program="main", speed=2.0)
        await first.hear("layout")
        await first.say(type="signal", name="gate", value=1)
        await first.say(type="live_speed", speed=0.5)
        await first.say(type="live_control", action="stop")
        assert (await first.hear("run", state="done"))["inputs"] == 1

    in_session(folder, play)


def test_a_live_run_that_is_to_be_held_at_its_start_is_started_so(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="live_start", program="main", speed=2.0, begin="held")
        await first.hear("live", state="held")
        await first.say(type="live_control", action="stop")

    in_session(folder, play)


def test_a_request_that_fails_is_told_and_the_next_one_is_answered(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: object) -> None:
        raise ZeroDivisionError("made up")

    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        with monkeypatch.context() as patch:
            patch.setattr("ropsim.studio.session.runs.Runs.cancel", fail)
            await first.say(type="cancel")
        assert "ZeroDivisionError: made up" in (await first.hear("notice"))["text"]
        await first.say(type="run", program="main", fidelity="kinematic")
        await first.hear("run", state="done", id=2)

    in_session(folder, play)


def test_a_viewer_changes_nothing_until_it_takes_over(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first, second = await page("a"), await page("b")
        await second.say(type="edit", document="programs/main.task", text="new\n", version=1)
        assert (await second.hear("notice"))["code"] == "U954"
        await second.say(type="take_over")
        await first.hear("editing", editing=False)
        await second.hear("editing", editing=True)
        await second.say(type="edit", document="programs/main.task", text="new\n", version=1)
        await second.say(type="save", document="programs/main.task", overwrite=False)
        await first.hear("documents")
        assert (folder / "programs" / "main.task").read_text("utf-8") == "new\n"

    in_session(folder, play)


def test_a_viewer_edits_when_the_tab_that_edits_has_stayed_away(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("session", "tabs"):
        monkeypatch.setattr(f"ropsim.studio.session.{module}.GRACE", 0.0)

    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first, second = await page("a"), await page("b")
        await second.hear("welcome", editing=False)
        await first.leave()
        await second.hear("editing", editing=True)

    in_session(folder, play)


def test_an_edit_of_the_cell_file_makes_the_scene_anew(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="edit", document="cell.toml", text="[cell]\n\n", version=1)
        await first.hear("scene", scene={"unsaved": ["cell.toml"]})
        assert first.session.scenes.mesh("abc") == b"glTF"
        assert first.session.scenes.mesh("nothing") is None

    in_session(folder, play)


def test_unsaved_text_comes_back_in_the_next_session_and_goes_with_a_revert(folder: Path) -> None:
    async def before(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="edit", document="programs/main.task", text="unsaved\n", version=1)
        await first.leave()

    async def after(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        document = (await first.hear("welcome"))["documents"][1]
        assert [document[key] for key in ("text", "recovered", "unsaved")] == ["unsaved\n", True, True]
        await first.say(type="revert", document="programs/main.task")
        reverted = (await first.hear("documents"))["documents"][0]
        assert [reverted[key] for key in ("text", "recovered", "unsaved")] == ["x\n", False, False]

    async def at_last(page: Callable[[str], Awaitable[Page]]) -> None:
        assert (await (await page("a")).hear("welcome"))["documents"][1]["text"] == "x\n"

    for play in (before, after, at_last):
        in_session(folder, play)


def test_a_file_that_another_program_writes_is_shown(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        (folder / "programs" / "main.task").write_text("written elsewhere\n", "utf-8")
        changed = await first.hear("documents")
        assert changed["documents"][0]["text"] == "written elsewhere\n"
        (folder / "programs" / "second.task").write_text("y\n", "utf-8")
        assert (await first.hear("welcome"))["programs"] == ["main", "second"]

    in_session(folder, play)


def test_nonsense_is_told_and_harms_nothing(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        for text in ("", "{", '{"type":"sing"}', b"\xff"):
            await first.session.receive(first.tab, text)
            assert (await first.hear("notice"))["code"] == "U953"
        await first.say(type="edit", document="../x.task", text="", version=1)
        assert (await first.hear("notice"))["code"] == "U958"
        await first.say(type="signal", name="gate", value=1)  # no live run: nothing happens
        await first.say(type="run", program="main", fidelity="dynamic")
        await first.hear("run", state="done")

    in_session(folder, play)


def test_a_jog_is_answered_to_the_tab_that_asked(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first, second = await page("a"), await page("b")
        await first.say(type="jog_joints", id=4, station="robot", q=[0.5, 1], tool="")
        answer = await first.hear("jogged")
        assert (answer["id"], answer["q"], answer["reached"]) == (4, [0.5, 1.0], True)
        assert answer["words"] == [{"level": "info", "text": "all is well"}]
        await first.say(type="jog_tcp", id=5, station="robot", q=[0.5], tool="", target=[1, 0, 0, 1, 0, 0, 0])
        refused = await first.hear("jogged")
        assert (refused["reached"], refused["words"][0]["level"]) == (False, "error")
        assert [one for one in second.got if one["type"] == "jogged"] == []

    in_session(folder, play)


def test_trust_is_given_and_taken(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.say(type="trust", trusted=True)
        await first.hear("trust", trusted=True, code=["controllers/evil.py"])
        await first.say(type="trust", trusted=False)
        await first.hear("trust", trusted=False)

    in_session(folder, play)


def test_a_worker_that_dies_is_told_and_replaced(folder: Path) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        await first.hear("run", state="done")
        await first.say(type="run", program="crash", fidelity="dynamic")
        await first.hear("run", state="failed")
        await first.say(type="run", program="main", fidelity="dynamic")
        await first.hear("run", state="done")

    in_session(folder, play)


def test_a_journal_that_cannot_be_is_told_and_the_rest_works(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder.parent / "file").write_text("")
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(folder.parent / "file"))

    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        assert (await first.hear("notice"))["code"] == "U959"
        await first.say(type="edit", document="programs/main.task", text="new\n", version=1)
        await first.say(type="save", document="programs/main.task", overwrite=False)
        assert (folder / "programs" / "main.task").read_text("utf-8") == "new\n"

    in_session(folder, play)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")
def test_a_file_whose_name_is_no_text_takes_nothing_from_the_others(folder: Path) -> None:
    (folder / "programs" / os.fsdecode(b"\xff.task")).write_text("x\n", "utf-8")

    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        assert [one["name"] for one in (await first.hear("welcome"))["documents"]] == [
            "cell.toml",
            "programs/main.task",
            "programs/\ufffd.task",
        ]
        await first.hear("run", state="done")

    in_session(folder, play)


def test_files_are_watched_on_after_a_fault(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def play(page: Callable[[str], Awaitable[Page]]) -> None:
        first = await page("a")
        documents = first.session.editing.documents
        look = documents.look

        async def fail() -> None:
            monkeypatch.setattr(documents, "look", look)
            raise ValueError("once")

        monkeypatch.setattr(documents, "look", fail)
        assert (await first.hear("notice"))["code"] == "U961"
        (folder / "programs" / "main.task").write_text("written elsewhere\n", "utf-8")
        await first.hear("documents")

    in_session(folder, play)
