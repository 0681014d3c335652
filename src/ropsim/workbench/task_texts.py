"""The texts of tasks that programs can call: those of the project, of the user, and of the library."""

import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from pathlib import Path

from ropsim.core import Diagnostic, SourceText, frozen_dataclass, read_bytes
from ropsim.userfiles import configuration_folder

KNOWLEDGE, ENDING = "kb", ".pl"
"""Name of the folder, in a project and beside the user's settings; and how names of texts in it end."""
FEW = 64
"""So many names are looked for one by one in a text."""

_TASK = re.compile(r"\btask\(\s*'?([^\W\d]\w*)")
_WORD = re.compile(r"[^\W\d]\w*")


@frozen_dataclass
class TaskTexts:
    """Texts of knowledge bases.

    Attributes:
        own: of the project, in their order.
        users: of the user's own folder.
        findings: what is wrong with the folders.
    """

    own: tuple[SourceText, ...] = ()
    users: tuple[SourceText, ...] = ()
    findings: tuple[Diagnostic, ...] = ()


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


def users_folder() -> Path:
    """Return the folder of the user's own tasks."""
    return configuration_folder() / KNOWLEDGE


def is_task_text(place: str) -> bool:
    """Return whether a place in a project is one of a text of tasks."""
    folder, _, name = place.rpartition("/")
    return folder == KNOWLEDGE and name.endswith(ENDING)


def _read(folder: Path) -> tuple[tuple[SourceText, ...], tuple[Diagnostic, ...]]:
    if not folder.is_dir():
        return (), ()
    from ropsim.tasks import read_folder  # with its engine it takes a tenth of a start

    return read_folder(folder)


def told_names(texts: Iterable[SourceText]) -> tuple[str, ...]:
    """Return what may be the names of tasks in some texts; they are not read, so comments count, too."""
    return tuple(dict.fromkeys(name for text in texts for name in _names(text.text)))


@lru_cache(maxsize=4096)
def _names(text: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(_TASK.findall(text)))


@lru_cache(maxsize=1)
def library_names() -> tuple[str, ...]:
    """Return the names of the tasks that come with ropsim, without loading what reads them."""
    folder = Path(__file__).parent.parent / "tasks" / "library"
    texts = (read_bytes(one).decode() for one in sorted(folder.glob(f"*{ENDING}")))
    return tuple(name for text in texts for name in _names(text))


def mentioned(text: str, names: Iterable[str]) -> tuple[str, ...]:
    """Return which names are words of a text, in their order."""
    wanted = tuple(names)
    if len(wanted) > FEW:
        words = frozenset(_WORD.findall(text))
        return tuple(one for one in wanted if one in words)
    return tuple(one for one in wanted if one in text and re.search(rf"\b{one}\b", text))
