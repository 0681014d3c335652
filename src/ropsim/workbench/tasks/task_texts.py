"""The texts of tasks that programs can call, and the Prolog engine behind them."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, SourceText, configuration_folder, frozen_dataclass
from ropsim.workbench.tasks.declared_tasks import DeclaredTask, declared_tasks, library_texts

if TYPE_CHECKING:
    from ropsim.tasks import KnowledgeBase


KNOWLEDGE, ENDING = "kb", ".pl"
"""Name of the folder, in a project and next to the user's settings; and the ending of texts in it."""


@frozen_dataclass
class TaskTexts:
    """Texts of knowledge bases.

    Attributes:
        own: of the project, in their order.
        users: of the user's own folder.
        findings: errors in the folders.
    """

    own: tuple[SourceText, ...] = ()
    users: tuple[SourceText, ...] = ()
    findings: tuple[Diagnostic, ...] = ()

    @property
    def told(self) -> Mapping[str, DeclaredTask]:
        """Return the tasks in these texts and in the library, the first of each name."""
        return declared_tasks((*self.own, *self.users, *library_texts()))

    def text(self, name: str) -> SourceText | None:
        """Return the text of a name."""
        every = (*self.own, *self.users, *library_texts())
        return next((one for one in every if one.name == name), None)


NO_TASKS = TaskTexts()


def read_task_texts(
    folder: Path, unsaved: Mapping[str, str], named: Callable[[str], str] = lambda place: place
) -> TaskTexts:
    """Return the texts that a project can call.

    Args:
        folder: of the project.
        unsaved: texts by their place in the project, `kb/NAME.pl`; they count instead of the files.
        named: the name that spans are to use, by the place.
    """
    texts, findings = _read(folder / KNOWLEDGE)
    saved = {f"{KNOWLEDGE}/{Path(one.name).name}": one.text for one in texts}
    newer = {place: text for place, text in sorted(unsaved.items()) if is_task_text(place)}
    own = tuple(SourceText(named(place), text) for place, text in {**saved, **newer}.items())
    users, more = _read(users_folder())
    return TaskTexts(own, users, (*findings, *more))


def users_folder() -> Path | None:
    """Return the folder of the user's own tasks; None for a user without a home folder."""
    try:
        return configuration_folder() / KNOWLEDGE
    except OSError:
        return None


def is_task_text(place: str) -> bool:
    """Return whether a place in a project is one of a text of tasks."""
    folder, _, name = place.rpartition("/")
    return folder == KNOWLEDGE and name.endswith(ENDING)


def _read(folder: Path | None) -> tuple[tuple[SourceText, ...], tuple[Diagnostic, ...]]:
    if folder is None or not folder.is_dir():
        return (), ()
    from ropsim.tasks import read_folder  # with its engine it takes a tenth of a start

    return read_folder(folder)


class TaskEngine:
    """Knowledge bases by their texts; it saves time and changes no answer.

    One knowledge base is kept: other texts are read in its place, by the same Prolog.
    """

    def __init__(self) -> None:
        self._base: KnowledgeBase | None = None
        self._read: tuple[tuple[SourceText, ...], tuple[SourceText, ...]] | None = None

    def base(self, texts: TaskTexts) -> "KnowledgeBase":
        """Return the knowledge base of some texts, valid until it is called with other texts."""
        from ropsim.tasks import KnowledgeBase

        wanted = texts.own, texts.users
        if self._base is None:
            self._base = KnowledgeBase(texts.own, users=texts.users)
        elif self._read != wanted:
            self._base.take(texts.own, users=texts.users)
        self._read = wanted
        return self._base
