"""The server on two byte streams; it reads while it works, so of waiting changes the last is compiled."""

import gc
import queue
import threading
from dataclasses import replace
from typing import BinaryIO, Protocol

import msgspec

from ropsim.core import collect_seldom, kept_from_collection, shortage
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.attention import SupersededError, nobody_calls
from ropsim.lsp.protocol.framing import FrameFault, FrameReader, framed
from ropsim.lsp.protocol.inbox import Ended, Inbox
from ropsim.lsp.protocol.messages import Call, ErrorCode, Fault, Json, failure, notification, read_message
from ropsim.lsp.server import answer, first_sight, mark, settle
from ropsim.lsp.state import Phase, State
from ropsim.userfiles import KEPT_ANSWERS

_CHUNK = 65536


class _Source(Protocol):
    def read(self, size: int, /) -> bytes: ...


def serve(source: _Source, sink: BinaryIO) -> int:
    """Serve one editor until it says `exit` or its stream ends, and return the exit code.

    Args:
        source: messages of the editor; `read` returns the available bytes, so an unbuffered stream.
        sink: takes the answers.
    """
    gc.freeze()
    collect_seldom()
    inbox: queue.SimpleQueue[bytes | FrameFault | None] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(source, inbox), daemon=True).start()
    state, workshop, waiting = State(), Workshop(KEPT_ANSWERS), Inbox()
    is_open = True

    def is_changed() -> bool:
        _receive_what_is_there(inbox, waiting)
        return waiting.changes_wait

    def is_wanted() -> bool:
        return not (waiting.is_empty and inbox.empty())

    try:
        while state.phase is not Phase.OVER and is_open:
            _receive(inbox, waiting)
            workshop.attention.is_called = nobody_calls
            if state.stale and waiting.asks_next and not waiting.changes_wait:
                state = _tell_findings(state, workshop, sink)  # a request may take long
            message, is_cancelled = waiting.next()
            said: tuple[Json, ...] = ()
            is_open = not isinstance(message, Ended)
            with kept_from_collection():  # the texts of an editor and the results for them stay
                if is_cancelled and isinstance(message, Call):
                    words = "the request has been cancelled"
                    said = (failure(message.id, ErrorCode.REQUEST_CANCELLED, words),)
                elif not isinstance(message, Ended):
                    workshop.attention.is_called = is_changed
                    state, said = _step(state, message, workshop)
            _write(sink, said)
            workshop.attention.is_called = nobody_calls
            if state.stale and (not is_open or (waiting.is_empty and inbox.empty())):
                state = _tell_findings(state, workshop, sink)
            workshop.attention.is_called = is_wanted if is_open else nobody_calls
            while state.unmarked and (not is_open or not is_wanted()):
                state = _tell_lines(state, workshop, sink)
    except _GoneError:
        return state.exit_code
    return state.exit_code


class _GoneError(Exception):
    """The editor has closed the connection."""


def _write(sink: BinaryIO, said: tuple[Json, ...]) -> None:
    try:
        for one in said:
            sink.write(framed(msgspec.json.encode(one)))
        if said:
            sink.flush()
    except (OSError, ValueError) as error:
        raise _GoneError from error


def _tell_findings(state: State, workshop: Workshop, sink: BinaryIO) -> State:
    """Publish the findings of changed texts; return the next state."""
    with kept_from_collection():
        _write(sink, _at_first_sight(state, workshop))
        state, said = _settled(state, workshop)
    _write(sink, said)
    return state


def _tell_lines(state: State, workshop: Workshop, sink: BinaryIO) -> State:
    """Publish which line results of a text are valid for it; return the next state."""
    with kept_from_collection():
        state, said = _marked(state, workshop)
    _write(sink, said)
    return state


def _receive(source: "queue.SimpleQueue[bytes | FrameFault | None]", waiting: Inbox) -> None:
    """Take all messages that have arrived; wait for one if there is none."""
    if waiting.is_empty:
        _put(source.get(), waiting)
    _receive_what_is_there(source, waiting)


def _receive_what_is_there(source: "queue.SimpleQueue[bytes | FrameFault | None]", waiting: Inbox) -> None:
    """Take all messages that have arrived."""
    while not source.empty():
        _put(source.get(), waiting)


def _put(body: bytes | FrameFault | None, waiting: Inbox) -> None:
    if body is None:
        waiting.put(Ended())
        return
    waiting.put(
        Fault(ErrorCode.PARSE_ERROR, body.message) if isinstance(body, FrameFault) else read_message(body)
    )


def _step(state: State, message: Call | Fault | None, workshop: Workshop) -> tuple[State, tuple[Json, ...]]:
    if message is None:
        return state, ()
    if isinstance(message, Fault):
        return state, (failure(message.id, message.code, message.message),)
    try:
        return answer(state, message, workshop)
    except SupersededError:
        words = "the text has been changed while it was looked at"
        return state, (failure(message.id, ErrorCode.CONTENT_MODIFIED, words),) if message.is_request else ()
    except Exception as error:  # a fault of ours must not take the editor's other documents with it
        return state, (_own_fault(error, message),)


def _settled(state: State, workshop: Workshop) -> tuple[State, tuple[Json, ...]]:
    try:
        return settle(state, workshop)
    except Exception as error:  # as above; the next change tries again
        nothing_stale = replace(state, stale=frozenset(), asks_again=False)
        return nothing_stale, (_own_fault(error, None),)


def _at_first_sight(state: State, workshop: Workshop) -> tuple[Json, ...]:
    try:
        return first_sight(state, workshop)
    except Exception:  # the check that follows meets the same fault, and reports it
        return ()


def _marked(state: State, workshop: Workshop) -> tuple[State, tuple[Json, ...]]:
    try:
        return mark(state, workshop)
    except SupersededError:  # the document stays stale
        return state, ()
    except Exception as error:  # as above
        return replace(state, unmarked=frozenset()), (_own_fault(error, None),)


def _own_fault(error: Exception, call: Call | None) -> Json:
    lacking = shortage(error)
    fault = f"this is a bug in ropsim, not in your input: {type(error).__name__}: {error}"
    words = lacking.message if lacking else fault
    if call is not None and call.is_request:
        return failure(call.id, ErrorCode.INTERNAL_ERROR, words)
    return notification("window/logMessage", {"type": 1, "message": words})


def _read(source: _Source, inbox: "queue.SimpleQueue[bytes | FrameFault | None]") -> None:
    reader = FrameReader()
    try:
        while data := source.read(_CHUNK):
            for one in reader.feed(data):
                inbox.put(one)
    except (OSError, ValueError):  # the stream was closed under our hands
        pass
    inbox.put(None)
