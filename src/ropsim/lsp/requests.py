"""The table of requests: their parameters, and what answers them; one file for each kind."""

from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeVar

from ropsim.core import frozen_dataclass
from ropsim.lsp import protocol
from ropsim.lsp.code_actions import actions
from ropsim.lsp.code_lens import code_lenses
from ropsim.lsp.completion import completions
from ropsim.lsp.definition import definition
from ropsim.lsp.document import Document
from ropsim.lsp.folding import folding_ranges
from ropsim.lsp.formatting import formatting
from ropsim.lsp.highlight import highlights
from ropsim.lsp.hover import hover
from ropsim.lsp.inlay_hints import inlay_hints
from ropsim.lsp.pulled import pulled
from ropsim.lsp.references import references
from ropsim.lsp.rename import prepare_rename, rename
from ropsim.lsp.semantic_tokens import all_tokens, tokens_in, tokens_since
from ropsim.lsp.signature_help import signature_help
from ropsim.lsp.state import State
from ropsim.lsp.symbols import symbols
from ropsim.lsp.within import within
from ropsim.lsp.workshop import Workshop
from ropsim.lsp.workspace_symbols import workspace_symbols


class _AboutDocument(Protocol):
    """Parameters that name a document."""

    @property
    def text_document(self) -> protocol.VersionedDocument: ...


P = TypeVar("P", bound=_AboutDocument)


@frozen_dataclass
class Method:
    """A message: the form of its parameters, and what makes the answer, or the state after it."""

    params: type[Any]
    run: Callable[[State, Any, Workshop], object]


def _about(
    params: type[P],
    run: Callable[[Document, P, Mapping[str, Document], Workshop], object],
    otherwise: Callable[[], object],
) -> Method:
    """Return a request about one document, and what is said of one that is not open."""

    def answered(state: State, given: P, workshop: Workshop) -> object:
        document = state.documents.get(given.text_document.uri)
        if document is None:
            return otherwise()
        return run(document, within(document, given), state.documents, workshop)

    return Method(params, answered)


def _nothing() -> None:
    return None


def _no_findings() -> object:
    return {"kind": "full", "items": []}


def _no_items() -> object:
    return {"isIncomplete": False, "items": []}


ASKED: dict[str, Method] = {
    "textDocument/completion": _about(protocol.CompletionAt, completions, _no_items),
    "textDocument/hover": _about(protocol.AtPosition, hover, _nothing),
    "textDocument/signatureHelp": _about(protocol.AtPosition, signature_help, _nothing),
    "textDocument/definition": _about(protocol.AtPosition, definition, _nothing),
    "textDocument/references": _about(protocol.ReferencesAt, references, list),
    "textDocument/documentHighlight": _about(protocol.AtPosition, highlights, list),
    "textDocument/prepareRename": _about(protocol.AtPosition, prepare_rename, _nothing),
    "textDocument/rename": _about(protocol.RenameAt, rename, _nothing),
    "textDocument/documentSymbol": _about(protocol.OfDocument, symbols, list),
    "textDocument/foldingRange": _about(protocol.OfDocument, folding_ranges, list),
    "textDocument/semanticTokens/full": _about(protocol.OfDocument, all_tokens, _nothing),
    "textDocument/semanticTokens/full/delta": _about(protocol.TokensSince, tokens_since, _nothing),
    "textDocument/semanticTokens/range": _about(protocol.InRange, tokens_in, _nothing),
    "textDocument/inlayHint": _about(protocol.InRange, inlay_hints, list),
    "textDocument/codeLens": _about(protocol.OfDocument, code_lenses, list),
    "textDocument/diagnostic": _about(protocol.FindingsSince, pulled, _no_findings),
    "textDocument/formatting": _about(protocol.OfDocument, formatting, list),
    "textDocument/codeAction": _about(protocol.ActionsIn, actions, list),
    "workspace/symbol": Method(
        protocol.SymbolQuery,
        lambda state, params, workshop: workspace_symbols(params, state.documents, workshop),
    ),
}
