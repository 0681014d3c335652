"""The system fails at any call while a text is edited, kept, saved and read again: no text is lost."""

import asyncio
import contextlib
from itertools import count
from pathlib import Path

import pytest

from ropsim.core import Diagnostic
from ropsim.studio.testing import Documents, Keeper, Overwriting
from ropsim.userfiles import Journal
from support.counted_system import counted, number

NAME, OLD, MINE = "programs/main.task", "old\n", "mine\n"


def started(folder: Path) -> tuple[Documents, Journal]:
    """Return the texts of a project, with what an earlier studio has left."""
    documents = Documents(folder)
    asyncio.run(documents.look())
    journal = Journal(folder)
    documents.recover(journal.read()[0])
    return documents, journal


def work(documents: Documents, journal: Journal) -> tuple[Diagnostic | None, list[Diagnostic]]:
    """Type, keep, save, keep, look; return why the text was not saved, and what was said of the journal."""
    told: list[Diagnostic] = []

    async def all_of_it() -> Diagnostic | None:
        keeper = Keeper(journal, lambda: documents.drafts, told.append)
        document, _ = documents.edit(NAME, MINE, 1)
        assert document is not None
        await keeper.now()
        finding = await documents.save(document, Overwriting.REFUSED)
        await keeper.now()
        with contextlib.suppress(OSError):  # said by the session, which looks again
            await documents.look()
        return finding

    return asyncio.run(all_of_it()), told


@pytest.mark.slow
@pytest.mark.parametrize("step", ["fails", "the folder goes"])
def test_no_text_is_lost_at_whatever_call_the_system_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    for at in count(1):
        home = tmp_path / f"{at}"
        folder, away = home / "cell", home / "away"
        monkeypatch.setenv("ROPSIM_STATE_HOME", str(home / "state"))
        (folder / "programs").mkdir(parents=True)
        (folder / "cell.toml").write_text("[cell]\n", "utf-8")
        (folder / NAME).write_text(OLD, "utf-8")
        documents, journal = started(folder)

        def leave(_: str, folder: Path = folder, away: Path = away) -> None:
            folder.rename(away)

        fault = counted(home, number(at)) if step == "fails" else counted(folder, number(at), leave)
        with fault as counting:
            finding, told = work(documents, journal)
        journal.close()
        if not counting.acted:
            assert at > 20
            return
        texts = {one.name: one.text for one in documents.all}
        assert texts == {"cell.toml": "[cell]\n", NAME: MINE}
        if away.exists():  # what was saved behind that made it anew
            left = (folder / NAME).read_text("utf-8") if (folder / NAME).exists() else OLD
            assert (away / NAME).read_text("utf-8") in (OLD, MINE)
        else:
            left = (folder / NAME).read_text("utf-8")
        assert left in (OLD, MINE)
        assert finding is not None or MINE in (left, *(place.read_text() for place in away.glob(NAME)))
        if counting.names[at - 1] != "unlink":
            assert list(home.rglob(".ropsim-*")) == []
        if folder.exists():
            again, other = started(folder)
            other.close()
            found = {one.name: one.text for one in again.all}.get(NAME)
            assert found == MINE or (told and told[0].code == "U959")


@pytest.mark.parametrize("kept", ["drafts", "damage"])
def test_a_journal_that_cannot_be_read_at_a_call_is_still_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kept: str
) -> None:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "cell"
    folder.mkdir()
    content = (
        b'{"version":1,"documents":{"cell.toml":{"text":"mine","base":""}}}' if kept == "drafts" else b"{"
    )
    first = Journal(folder)
    first.close()
    for at in count(1):
        first.place.write_bytes(content)
        with counted(tmp_path / "state", number(at)) as counting:
            try:
                journal = Journal(folder)
            except OSError:
                continue
            try:
                journal.read()
            except OSError:
                assert counting.acted
            finally:
                journal.close()
        copies = [one.read_bytes() for one in first.place.parent.iterdir()]
        assert content in copies
        if not counting.acted:
            break
