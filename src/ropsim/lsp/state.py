"""State of the server between two messages."""

from collections.abc import Mapping
from dataclasses import field, replace
from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.lsp.protocol.document import Document


class Phase(Enum):
    """Where a connection stands."""

    NEW = "new"
    RUNNING = "running"
    SHUT_DOWN = "shut down"
    OVER = "over"


@frozen_dataclass
class State:
    """A connection.

    Attributes:
        phase: before `initialize`, between, after `shutdown`, after `exit`.
        documents: open documents by URI.
        stale: URIs whose findings have not been published since their last change.
        encoding: in which units the editor counts characters.
        pulls: whether the editor requests findings itself, and supports a refresh request.
        marks_lines: whether the editor shows which results of lines are valid for the text.
        unmarked: URIs whose line results have not been published since their last change.
        asks_again: whether the editor is to get a refresh request, since findings have changed of documents
            that it does not edit.
        refreshes: number of requests that the server has sent.
        exit_code: of the process, once it is over.
    """

    phase: Phase = Phase.NEW
    documents: Mapping[str, Document] = field(default_factory=dict)
    stale: frozenset[str] = frozenset()
    encoding: str = "utf-16"
    pulls: bool = False
    marks_lines: bool = False
    unmarked: frozenset[str] = frozenset()
    asks_again: bool = False
    refreshes: int = 0
    exit_code: int = 1

    def opened(self, document: Document) -> "State":
        """Return the state with a document new or changed."""
        documents = {**self.documents, document.uri: document}
        stale = self._stale_after(document, documents)
        return replace(self, documents=documents, stale=stale, asks_again=self.asks_again or len(stale) > 1)

    def closed(self, uri: str) -> "State":
        """Return the state without a document; its published results are stale."""
        documents = {name: one for name, one in self.documents.items() if name != uri}
        gone = self.documents.get(uri)
        stale = self._stale_after(gone, documents) if gone is not None else self.stale
        return replace(self, documents=documents, stale=stale | {uri} if gone is not None else stale)

    def all_stale(self) -> "State":
        """Return the state in which every document is stale."""
        return replace(self, stale=frozenset(self.documents), asks_again=True)

    def _stale_after(self, document: Document, documents: Mapping[str, Document]) -> frozenset[str]:
        """Return the documents that a change makes stale; cells, robots and tasks concern all programs."""
        path = document.path
        if (path is not None and path.name == "cell.toml") or document.is_robot_file or document.is_task_text:
            return frozenset(documents)
        return self.stale | {document.uri}
