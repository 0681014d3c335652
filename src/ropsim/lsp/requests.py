"""The table of requests: their parameters, and their handlers; one file for each kind."""

from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeVar

from ropsim.core import frozen_dataclass
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.changes.code_actions import actions
from ropsim.lsp.changes.formatting import formatting
from ropsim.lsp.changes.pulled import pulled
from ropsim.lsp.completion.call_place import signature_help
from ropsim.lsp.completion.offers import completions
from ropsim.lsp.display.folding import folding_ranges
from ropsim.lsp.display.hover import hover
from ropsim.lsp.display.inlay_hints import code_lenses, inlay_hints
from ropsim.lsp.display.semantic_tokens import all_tokens, tokens_in, tokens_since
from ropsim.lsp.display.symbols import symbols, workspace_symbols
from ropsim.lsp.names.places import definition, highlights, references
from ropsim.lsp.names.rename import prepare_rename, rename
from ropsim.lsp.protocol import parameters
from ropsim.lsp.protocol.document import Document, within
from ropsim.lsp.state import State


class _AboutDocument(Protocol):
    """Parameters that name a document."""

    @property
    def text_document(self) -> parameters.VersionedDocument: ...


P = TypeVar("P", bound=_AboutDocument)


@frozen_dataclass
class Method:
    """A message: the form of its parameters, and the handler that returns the answer, or the next state."""

    params: type[Any]
    run: Callable[[State, Any, Workshop], object]


def _about(
    params: type[P],
    run: Callable[[Document, P, Mapping[str, Document], Workshop], object],
    otherwise: Callable[[], object],
) -> Method:
    """Return a request about one document, and the answer for a document that is not open."""

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


REQUESTS: dict[str, Method] = {
    "textDocument/completion": _about(parameters.CompletionAt, completions, _no_items),
    "textDocument/hover": _about(parameters.AtPosition, hover, _nothing),
    "textDocument/signatureHelp": _about(parameters.AtPosition, signature_help, _nothing),
    "textDocument/definition": _about(parameters.AtPosition, definition, _nothing),
    "textDocument/references": _about(parameters.ReferencesAt, references, list),
    "textDocument/documentHighlight": _about(parameters.AtPosition, highlights, list),
    "textDocument/prepareRename": _about(parameters.AtPosition, prepare_rename, _nothing),
    "textDocument/rename": _about(parameters.RenameAt, rename, _nothing),
    "textDocument/documentSymbol": _about(parameters.OfDocument, symbols, list),
    "textDocument/foldingRange": _about(parameters.OfDocument, folding_ranges, list),
    "textDocument/semanticTokens/full": _about(parameters.OfDocument, all_tokens, _nothing),
    "textDocument/semanticTokens/full/delta": _about(parameters.TokensSince, tokens_since, _nothing),
    "textDocument/semanticTokens/range": _about(parameters.InRange, tokens_in, _nothing),
    "textDocument/inlayHint": _about(parameters.InRange, inlay_hints, list),
    "textDocument/codeLens": _about(parameters.OfDocument, code_lenses, list),
    "textDocument/diagnostic": _about(parameters.FindingsSince, pulled, _no_findings),
    "textDocument/formatting": _about(parameters.OfDocument, formatting, list),
    "textDocument/codeAction": _about(parameters.ActionsIn, actions, list),
    "workspace/symbol": Method(
        parameters.SymbolQuery,
        lambda state, params, workshop: workspace_symbols(params, state.documents, workshop),
    ),
}
