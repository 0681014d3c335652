"""Core of the server: a pure function from a message and a state to the next state and the answers."""

from collections.abc import Callable
from dataclasses import replace

import msgspec

from ropsim.lsp.analysis.line_states import states_message
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.changes.code_actions import KINDS
from ropsim.lsp.changes.findings import diagnostic
from ropsim.lsp.changes.pulled import findings_of
from ropsim.lsp.display.semantic_tokens import LEGEND
from ropsim.lsp.protocol import parameters
from ropsim.lsp.protocol.abilities import encoding_of, marks_lines_of, pulls_of
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import (
    Call,
    ErrorCode,
    Json,
    Refusal,
    failure,
    notification,
    request,
    result,
)
from ropsim.lsp.requests import REQUESTS, Method
from ropsim.lsp.state import Phase, State
from ropsim.version import __version__

CAPABILITIES: Json = {
    "textDocumentSync": {"openClose": True, "change": 2, "save": {"includeText": False}},
    "completionProvider": {"triggerCharacters": [".", ":", "(", ",", " ", '"']},
    "hoverProvider": True,
    "signatureHelpProvider": {"triggerCharacters": ["(", ",", " ", "="]},
    "definitionProvider": True,
    "referencesProvider": True,
    "documentHighlightProvider": True,
    "renameProvider": {"prepareProvider": True},
    "documentSymbolProvider": True,
    "workspaceSymbolProvider": True,
    "foldingRangeProvider": True,
    "diagnosticProvider": {
        "identifier": "ropsim",
        "interFileDependencies": True,
        "workspaceDiagnostics": False,
    },
    "semanticTokensProvider": {"legend": LEGEND, "full": {"delta": True}, "range": True},
    "inlayHintProvider": True,
    "documentFormattingProvider": True,
    "codeLensProvider": {"resolveProvider": False},
    "codeActionProvider": {"codeActionKinds": list(KINDS)},
}
_IDENTITY: Json = {"name": "ropsim", "version": __version__}

Answer = tuple[State, tuple[Json, ...]]


def answer(state: State, call: Call, workshop: Workshop) -> Answer:
    """Take one message.

    Args:
        state: before it.
        call: request or notification.
        workshop: remembers results for texts; does not change answers.

    Returns:
        The state after it, and the answer to a request. Findings are published by `settle`.
    """
    if call.method == "exit":
        return replace(state, phase=Phase.OVER, exit_code=0 if state.phase is Phase.SHUT_DOWN else 1), ()
    refusal = _refusal(state, call)
    if refusal is not None:
        return state, (refusal,) if call.is_request else ()
    if call.method in _LIFE:
        state, value = _LIFE[call.method](state, call.params)
        return state, (result(call.id, value),) if call.is_request else ()
    table: dict[str, Method] = REQUESTS if call.is_request else _NOTIFICATIONS
    method = table.get(call.method)
    if method is None:
        unknown = failure(call.id, ErrorCode.METHOD_NOT_FOUND, f"`{call.method[:80]}` is not supported")
        return state, (unknown,) if call.is_request else ()
    try:
        params = msgspec.convert(call.params if call.params is not None else {}, method.params)
    except (msgspec.ValidationError, ValueError) as error:
        wrong = failure(call.id, ErrorCode.INVALID_PARAMS, str(error))
        return state, (wrong,) if call.is_request else ()
    made = method.run(state, params, workshop)
    if not call.is_request:
        assert isinstance(made, State)
        return made, ()
    if isinstance(made, Refusal):
        plain = made.message.replace("`", '"')  # clients show the message of an error as it is
        return state, (failure(call.id, ErrorCode.REQUEST_FAILED, plain),)
    return state, (result(call.id, made),)


def settle(state: State, workshop: Workshop) -> Answer:
    """Publish the findings of all changed documents; called when no message is waiting.

    An editor that requests findings itself gets a refresh request if other texts than the open one have
    changed.
    """
    unmarked = state.unmarked | state.stale if state.marks_lines else frozenset()
    settled = replace(state, stale=frozenset(), asks_again=False, unmarked=unmarked)
    if not state.pulls:
        return settled, tuple(_published(state, uri, workshop) for uri in sorted(state.stale))
    if not state.asks_again:
        return settled, ()
    identity = f"ropsim-{state.refreshes}"
    return replace(settled, refreshes=state.refreshes + 1), (
        request(identity, "workspace/diagnostic/refresh"),
    )


def first_sight(state: State, workshop: Workshop) -> tuple[Json, ...]:
    """Publish the findings in single lines of long texts before their first check.

    The findings of `settle` for the same version of the text replace them.
    """
    published = []
    for uri in () if state.pulls else sorted(state.stale):
        document = state.documents.get(uri)
        found = workshop.at_first_sight(document) if document is not None else None
        if document is not None and found:
            published.append(_findings(document, [diagnostic(one, document) for one in found]))
    return tuple(published)


def mark(state: State, workshop: Workshop) -> Answer:
    """Publish which line results of one document are valid for its text; called when all else is published.

    Only for an editor that declares this capability at `initialize`.
    """
    uri = min(state.unmarked)
    document = state.documents.get(uri)
    marked = replace(state, unmarked=state.unmarked - {uri})
    if document is None or not is_program(document):
        return marked, ()
    return marked, (states_message(document, state.documents, workshop),)


def _published(state: State, uri: str, workshop: Workshop) -> Json:
    document = state.documents.get(uri)
    if document is None:  # closed: nothing of it is shown any more
        return notification("textDocument/publishDiagnostics", {"uri": uri, "diagnostics": []})
    return _findings(document, findings_of(document, state.documents, workshop))


def _findings(document: Document, found: list[Json]) -> Json:
    published = {"uri": document.uri, "version": document.version, "diagnostics": found}
    return notification("textDocument/publishDiagnostics", published)


def _refusal(state: State, call: Call) -> Json | None:
    if state.phase is Phase.NEW and call.method != "initialize":
        return failure(call.id, ErrorCode.NOT_INITIALIZED, "`initialize` comes first")
    if state.phase is Phase.SHUT_DOWN:
        return failure(call.id, ErrorCode.INVALID_REQUEST, "after `shutdown` only `exit` is allowed")
    if state.phase is Phase.RUNNING and call.method == "initialize":
        return failure(call.id, ErrorCode.INVALID_REQUEST, "`initialize` came before")
    return None


def _initialize(state: State, params: object) -> tuple[State, object]:
    encoding = encoding_of(params)
    running = replace(state, phase=Phase.RUNNING, encoding=encoding, pulls=pulls_of(params))
    running = replace(running, marks_lines=marks_lines_of(params))
    capabilities = {**CAPABILITIES, "positionEncoding": encoding}
    return running, {"capabilities": capabilities, "serverInfo": _IDENTITY}


def _shut_down(state: State, _: object) -> tuple[State, object]:
    return replace(state, phase=Phase.SHUT_DOWN), None


def _open(state: State, params: parameters.DidOpen, _: Workshop) -> State:
    item = params.text_document
    return state.opened(Document(item.uri, item.version, item.text, state.encoding))


def _change(state: State, params: parameters.DidChange, _: Workshop) -> State:
    document = state.documents.get(params.text_document.uri)
    if document is None:
        return state
    version = params.text_document.version
    return state.opened(
        document.changed(params.content_changes, document.version + 1 if version is None else version)
    )


def _close(state: State, params: parameters.OfDocument, workshop: Workshop) -> State:
    workshop.forget(params.text_document.uri)
    return state.closed(params.text_document.uri)


def _reread(state: State, _: parameters.Anything, workshop: Workshop) -> State:
    workshop.workspace.keep()
    return state.all_stale()


_LIFE: dict[str, Callable[[State, object], tuple[State, object]]] = {
    "initialize": _initialize,
    "shutdown": _shut_down,
}
_NOTIFICATIONS = {
    "textDocument/didOpen": Method(parameters.DidOpen, _open),
    "textDocument/didChange": Method(parameters.DidChange, _change),
    "textDocument/didClose": Method(parameters.OfDocument, _close),
    "textDocument/didSave": Method(parameters.Anything, _reread),
    "workspace/didChangeWatchedFiles": Method(parameters.Anything, _reread),
}
