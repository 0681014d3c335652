"""The command line of a session: lines of all tabs in one order, and a lost worker loses none."""

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path

from support.session_pages import Page, in_session

Opened = Callable[[str], Awaitable[Page]]


def test_a_line_is_answered_to_all_tabs_and_its_run_can_be_fetched(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first, second = await page("a"), await page("b")
        await first.say(type="open_command_line")
        begun = await first.hear("command_line")
        assert [one["told"] for one in begun["lines"]] == [["it stands"]]
        await first.say(type="tell_robot", id=3, line="mov a")
        mine, theirs = await first.hear("line_answered"), await second.hear("line_answered")
        assert (mine["id"], theirs["id"], mine["commands"]) == (3, 0, 1)
        assert mine["line"] == theirs["line"]
        assert first.session.command_line.pack(mine["line"]["run"]) == b"mov a"
        await second.say(type="tell_robot", id=1, line="mov b")
        run = (await first.hear("line_answered"))["line"]["run"]
        assert first.session.command_line.pack(run) == b"mov a mov b"
        await second.say(type="open_command_line")
        known = await second.hear("command_line", commands=2)
        assert [one["line"] for one in known["lines"]] == ["", "mov a", "mov b"]

    in_session(folder, play)


def test_an_open_block_is_between_the_tab_and_the_server(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first, second = await page("a"), await page("b")
        await first.say(type="tell_robot", id=1, line="repeat 2")
        assert (await first.hear("line_answered"))["line"]["outcome"] == "open"
        await first.say(type="tell_robot", id=2, line="mov a")
        assert (await second.hear("line_answered"))["line"]["line"] == "mov a"

    in_session(folder, play)


def test_a_lost_worker_loses_no_command(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first = await page("a")
        for number, line in enumerate(("mov a", "crash", "mov b")):
            await first.say(type="tell_robot", id=number + 1, line=line)
        assert (await first.hear("line_answered", id=1))["commands"] == 1
        lost = await first.hear("line_answered", id=2)
        assert (lost["line"]["outcome"], lost["commands"]) == ("refused", 1)
        assert "exit code 3" in lost["line"]["told"][0]
        after = await first.hear("line_answered", id=3)
        assert first.session.command_line.pack(after["line"]["run"]) == b"mov a mov b"

    in_session(folder, play)


def test_a_line_that_takes_too_long_is_given_up(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first = await page("a")
        await first.say(type="tell_robot", id=1, line="endless")
        await asyncio.sleep(0)  # it has gone to the worker
        await first.say(type="give_up_line")
        assert (await first.hear("line_answered", id=1))["line"]["told"] == ["given up"]

    in_session(folder, play)


def test_a_saved_program_is_a_text_of_the_project_where_one_may_edit(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first, second = await page("a"), await page("b")
        await first.say(type="tell_robot", id=1, line="mov a")
        await second.say(type="tell_robot", id=2, line="save again")
        refused = await second.hear("line_answered", id=2)
        assert (refused["line"]["outcome"], "another tab edits" in refused["line"]["told"][0]) == (
            "refused",
            True,
        )
        await first.say(type="tell_robot", id=3, line="save again")
        kept = await first.hear("line_answered", id=3)
        assert kept["line"]["told"] == ["wrote programs/again.task"]
        assert (folder / "programs" / "again.task").read_text("utf-8") == "mov a"
        await first.say(type="tell_robot", id=4, line="save again")
        assert (await first.hear("line_answered", id=4))["line"]["outcome"] == "refused"

    in_session(folder, play)


def test_words_are_offered_for_the_commands_and_texts_of_now(folder: Path) -> None:
    async def play(page: Opened) -> None:
        first = await page("a")
        await first.say(type="edit", document="cell.toml", text="[cell]\n#\n", version=1)
        await first.say(type="tell_robot", id=1, line="mov a")
        await first.hear("line_answered")
        await first.say(type="complete_line", id=5, line="mo")
        offered = await first.hear("words_offered", id=5)
        assert (offered["begun"], offered["words"]) == ("mo", ["mov a", "cell.toml"])

    in_session(folder, play)
