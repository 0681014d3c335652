"""Random histories of the texts of a project: what users, other programs and crashes do, in any order.

One or two studios, each with a page, and other programs work on one project folder. The machine keeps
books and holds the studios to the law after each step: no text is lost that somebody has typed, and no file
is written over whose content the user has neither worked on nor been shown as a conflict.
"""

import asyncio
import json
import random
import shutil
from contextlib import nullcontext
from pathlib import Path
from typing import NamedTuple

from ropsim.core import Diagnostic
from ropsim.studio.testing import Document, Documents, Keeper, Overwriting
from ropsim.userfiles import Journal
from support.counted_system import counted, number

NAMES = ("cell.toml", "programs/main.task", "programs/other.task", "robots/arm.toml", "kb/own.pl")
MOST_CALLS = 30
"""A look makes about so many calls of the system."""


class Work(NamedTuple):
    """What a user has done to a text.

    Attributes:
        typed: the newest text, where it is neither saved nor given up.
        basis: content of the file on which it was written, None for no file.
    """

    typed: str | None
    basis: str | None


class User:
    """A studio and the one who works with it; the folder must be a project."""

    def __init__(self, folder: Path, runner: asyncio.Runner) -> None:
        self.documents = Documents(folder)
        self._runner = runner
        runner.run(self.documents.look())
        self.journal = Journal(folder)
        drafts, findings = self.journal.read()
        assert findings == ()
        self.documents.recover(drafts)
        self.keeper = Keeper(self.journal, lambda: self.documents.drafts, _complain)
        self.bases: dict[str, str] = {}
        """Of the documents, as the page has them."""
        self.books: dict[str, Work] = {}
        self.kept: dict[str, Work] = {}
        """The books when the journal was written last."""

    def keep(self) -> None:
        """Write the journal."""
        self.settle()
        self._runner.run(self.keeper.now())
        self.kept = {name: work for name, work in self.books.items() if work.typed is not None}

    def look(self) -> None:
        """Meet the files; where their folder is gone, all texts must be there as before."""
        before = self.texts
        self._runner.run(self.documents.look())
        if self.documents.gone:
            assert self.texts == before, "texts went with their folder"
        self.settle()

    def save(self, document: Document, overwriting: Overwriting) -> Diagnostic | None:
        """Save a text and return what was in the way."""
        return self._runner.run(self.documents.save(document, overwriting))

    def revert(self, document: Document) -> Diagnostic | None:
        """Give up a text and return what was in the way."""
        return self._runner.run(self.documents.revert(document))

    @property
    def texts(self) -> dict[str, str]:
        """Return what the page shows."""
        return {one.name: one.text for one in self.documents.all}

    def settle(self) -> None:
        """Hold the texts to the books, and enter what the page shows by now."""
        texts = self.texts
        for name, work in self.books.items():
            assert work.typed is None or texts.get(name) == work.typed, f"a text of `{name}` was lost"
        books = {}
        for one in self.documents.all:
            before = self.books.get(one.name, Work(None, None))
            disk = None if one.disk is None else one.disk.decode()
            books[one.name] = Work(one.text, before.basis) if one.unsaved else Work(None, disk)
        self.books = books
        self.bases = {one.name: one.base for one in self.documents.all}


class TextMachine:
    """One history.

    Args:
        home: empty folder for the project.
        seed: of the steps.
    """

    def __init__(self, home: Path, seed: int) -> None:
        self._random = random.Random(seed)
        self._folder, self._away = home / "cell", home / "away"
        self._count = 0
        self._runner = asyncio.Runner()
        self._users: list[User] = []
        self._left: dict[Path, dict[str, Work]] = {}
        """What killed studios have left in journals that no studio has taken since."""
        self.history: list[str] = []
        for name in NAMES:
            self._write(name, self._new("start"))
        self._open()

    def run(self, steps: int) -> None:
        """Take random steps, and hold the texts to the law after each.

        Raises:
            AssertionError: a text was lost or written over.
        """
        own = [
            *[self._edit] * 4,
            *[self._save] * 3,
            *[self._look] * 4,
            self._overwrite,
            self._revert,
            self._keep,
        ]
        races = [self._late_edit, self._edit_behind_save, self._foreign_in_save, self._goes_in_look]
        others = [self._foreign, self._foreign, self._foreign_back, self._unlink, self._move]
        rare = [
            self._rename_folder,
            self._remove_folder,
            self._empty_folder,
            self._kill,
            self._kill,
            self._second,
        ]
        try:
            for _ in range(steps):
                step = self._random.choice([*own, *races, *others, *rare])
                self.history.append(step.__name__)
                step()
                self._check()
        finally:
            for user in self._users:
                user.journal.close()
            self._runner.close()

    def _check(self) -> None:
        for user in self._users:
            user.settle()
        for place, works in self._left.items():
            drafts = json.loads(place.read_bytes())["documents"]
            assert {name: one["text"] for name, one in drafts.items()} == {
                name: work.typed for name, work in works.items()
            }, "a text of a killed studio was lost"

    # what users do

    def _edit(self) -> None:
        user, document = self._one()
        self._type(user, document, user.bases[document.name], user.books[document.name].basis)

    def _late_edit(self) -> None:
        """Type, and the file is written and read before the edit arrives."""
        user, document = self._one()
        base, basis = user.bases[document.name], user.books[document.name].basis
        self._write(document.name, self._new("foreign"))
        user.look()
        self._type(user, document, base, basis)

    def _edit_behind_save(self) -> None:
        """Save, and an edit arrives that was sent before the page has heard of that."""
        user, document = self._one()
        base, before = user.bases[document.name], user.books[document.name].basis
        was_written = self._saved(user, document, Overwriting.REFUSED)
        basis = user.books[document.name].basis if was_written else before
        self._type(user, document, base, basis)
        assert not (was_written and document.conflict), "a text is in conflict with itself"

    def _type(self, user: User, document: Document, base: str, basis: str | None) -> None:
        kinds = [self._new("typed")] * 3 + [self._content(document.name) or "\n"]
        text = self._random.choice(kinds)
        taken, _ = user.documents.edit(document.name, text, document.version + 1, base)
        assert taken is document, "an edit was refused"
        user.books[document.name] = Work(text, basis)

    def _save(self) -> None:
        self._saved(*self._one(), Overwriting.REFUSED)

    def _overwrite(self) -> None:
        self._saved(*self._one(), Overwriting.WANTED)

    def _foreign_in_save(self) -> None:
        """Save, and the file is written by another program at any time until it is compared the last time."""
        self._saved(*self._one(), self._random.choice(list(Overwriting)), self._new("foreign"))

    def _saved(self, user: User, document: Document, overwriting: Overwriting, foreign: str = "") -> bool:
        """Save a text and return whether it was written; what it was written over must be known."""
        name, work = document.name, user.books[document.name]
        before = self._content(name)
        shown = document.disk.decode() if document.conflict and document.disk is not None else None
        chosen = self._random.randrange(1, MOST_CALLS)
        meddling = (
            counted(
                self._folder.parent,
                lambda at, call: at == chosen or call == "fsync",
                lambda _: self._write(name, foreign),
            )
            if foreign
            else nullcontext()
        )
        with meddling as counting:
            finding = user.save(document, overwriting)
        if counting is not None and counting.acted:
            before = foreign
        after = self._content(name)
        was_written = after != before
        if was_written:
            assert after == document.text
            is_known = before in (None, work.basis)
            was_wanted = overwriting is Overwriting.WANTED and before == shown
            assert is_known or was_wanted, f"{before!r} was written over"
            user.books[name] = Work(None, after)
        elif document.unsaved:
            assert finding is not None, "a save did nothing and said nothing"
        if before == work.basis:
            assert finding is None, "a save was refused for nothing"
        if self._random.random() < 0.7:
            user.keep()
        return was_written

    def _revert(self) -> None:
        user, document = self._one()
        if user.revert(document) is None:
            del user.books[document.name]

    def _keep(self) -> None:
        self._random.choice(self._users).keep()

    def _look(self) -> None:
        self._random.choice(self._users).look()

    # what other programs do

    def _foreign(self) -> None:
        self._write(self._random.choice(NAMES), self._new("foreign"))

    def _foreign_back(self) -> None:
        """Write what a user has worked on: with that no conflict is left."""
        user, document = self._one()
        basis = user.books[document.name].basis
        if basis is not None:
            self._write(document.name, basis)
            user.look()
            assert not document.conflict

    def _unlink(self) -> None:
        (self._folder / self._random.choice(NAMES)).unlink(missing_ok=True)

    def _move(self) -> None:
        source, target = (self._folder / name for name in self._random.sample(NAMES, 2))
        if source.exists() and target.parent.exists():
            source.replace(target)

    def _rename_folder(self) -> None:
        """Move the project away, or back over what has come into its place."""
        if self._folder.exists() and not self._away.exists():
            self._folder.rename(self._away)
        elif self._away.exists():
            shutil.rmtree(self._folder, ignore_errors=True)
            self._away.rename(self._folder)

    def _remove_folder(self) -> None:
        """Remove the project file by file, slower than a studio looks."""
        user = self._settled()
        before = user.texts
        files = [one for one in self._folder.rglob("*") if one.is_file()]
        for file in files:
            file.unlink()
            if self._random.random() < 0.5:
                user.look()
        shutil.rmtree(self._folder, ignore_errors=True)
        user.look()
        if files:
            assert user.texts.items() >= before.items(), "texts went with their folder, file by file"

    def _empty_folder(self) -> None:
        """Leave an empty folder, as when a disk is taken away."""
        if self._folder.exists():
            shutil.rmtree(self._folder)
            self._folder.mkdir()

    def _goes_in_look(self) -> None:
        """Let the project go between any two questions of a look."""
        user = self._settled()
        if not self._folder.exists() or self._away.exists():
            return
        before = user.texts
        turn = number(self._random.randrange(1, MOST_CALLS))
        with counted(self._folder.parent, turn, lambda _: self._rename_folder()) as counting:
            user.look()
        user.look()
        if counting.acted:
            assert user.documents.gone
            assert user.texts.keys() >= before.keys(), "texts went with their folder, in the middle of a look"

    def _settled(self) -> User:
        """Return a user whose studio has met what happened until now."""
        user = self._random.choice(self._users)
        for _ in range(3):
            user.look()
        return user

    # crashes

    def _kill(self) -> None:
        user = self._random.choice(self._users)
        self._users.remove(user)
        user.journal.close()  # the system frees the lock
        if user.kept:
            self._left[user.journal.place] = user.kept
        if not self._users:
            self._open()

    def _second(self) -> None:
        if len(self._users) < 2:
            self._open()

    def _open(self) -> None:
        """Start a studio; what an earlier one has left in its journal must be there."""
        if not self._folder.exists() and self._away.exists():
            self._away.rename(self._folder)
        if not (self._folder / NAMES[0]).exists():
            self._write(NAMES[0], self._new("start"))
        user = User(self._folder, self._runner)
        user.books = user.kept = self._left.pop(user.journal.place, {})
        for name, work in user.books.items():
            assert work.typed in (user.texts.get(name), self._content(name)), f"`{name}` was not recovered"
        user.books = {name: work for name, work in user.books.items() if name in user.documents.drafts}
        self._users.append(user)
        user.settle()

    # the ground

    def _one(self) -> tuple[User, Document]:
        user = self._random.choice(self._users)
        if not user.documents.all:
            self._write(NAMES[0], self._new("foreign"))
            user.look()
        return user, self._random.choice(user.documents.all)

    def _new(self, whose: str) -> str:
        self._count += 1
        return f"{whose} {self._count}\n"

    def _write(self, name: str, text: str) -> None:
        path = self._folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8", newline="")

    def _content(self, name: str) -> str | None:
        try:
            return (self._folder / name).read_text("utf-8")
        except FileNotFoundError:
            return None


def _complain(finding: Diagnostic) -> None:
    raise AssertionError(finding.message)
