"""The Prolog behind the tasks that programs of a workspace call: it starts with the first call."""

from typing import TYPE_CHECKING

from ropsim.core import SourceText
from ropsim.workbench.task_texts import TaskTexts

if TYPE_CHECKING:
    from ropsim.tasks import KnowledgeBase


class TaskEngine:
    """Knowledge bases by their texts; it saves time and changes no answer.

    One knowledge base is kept: other texts are read in its place, by the same Prolog.
    """

    def __init__(self) -> None:
        self._base: KnowledgeBase | None = None
        self._read: tuple[tuple[SourceText, ...], tuple[SourceText, ...]] | None = None

    def base(self, texts: TaskTexts) -> "KnowledgeBase":
        """Return the knowledge base of some texts, good until it is asked for that of others."""
        from ropsim.tasks import KnowledgeBase

        wanted = texts.own, texts.users
        if self._base is None:
            self._base = KnowledgeBase(texts.own, users=texts.users)
        elif self._read != wanted:
            self._base.take(texts.own, users=texts.users)
        self._read = wanted
        return self._base
