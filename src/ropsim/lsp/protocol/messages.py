"""JSON-RPC: incoming messages are classified, outgoing ones formatted."""

from enum import IntEnum

import msgspec

from ropsim.core import frozen_dataclass

Id = int | str | None
Json = dict[str, object]


class ErrorCode(IntEnum):
    """Codes of JSON-RPC and of the language server protocol."""

    PARSE_ERROR = -32700
    INVALID_REQUEST = -32600
    METHOD_NOT_FOUND = -32601
    INVALID_PARAMS = -32602
    INTERNAL_ERROR = -32603
    NOT_INITIALIZED = -32002
    CONTENT_MODIFIED = -32801
    REQUEST_FAILED = -32803
    REQUEST_CANCELLED = -32800


@frozen_dataclass
class Call:
    """A request, or a notification where `is_request` is false.

    Attributes:
        method: as in the protocol.
        params: as they came.
        id: of the request.
        is_request: whether an answer is due.
    """

    method: str
    params: object
    id: Id = None
    is_request: bool = False


@frozen_dataclass
class Fault:
    """A message that cannot be understood."""

    code: ErrorCode
    message: str
    id: Id = None


@frozen_dataclass
class Refusal:
    """A request that is understood and cannot be done, with the reason."""

    message: str


def read_message(body: bytes) -> Call | Fault | None:
    """Return the content of a message body; None for responses, on which nothing depends."""
    try:
        message = msgspec.json.decode(body)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return Fault(ErrorCode.PARSE_ERROR, f"not valid JSON: {error}")
    if not isinstance(message, dict):
        return Fault(ErrorCode.INVALID_REQUEST, "a message must be an object")
    identity = message.get("id")
    known = identity if isinstance(identity, int | str) and not isinstance(identity, bool) else None
    method = message.get("method")
    if method is None and ("result" in message or "error" in message):
        return None
    if not isinstance(method, str) or (identity is not None and known is None):
        return Fault(
            ErrorCode.INVALID_REQUEST, "`method` must be a text and `id` a whole number or a text", known
        )
    return Call(method, message.get("params"), known, "id" in message)


def result(identity: Id, value: object) -> Json:
    """Return the answer to a request."""
    return {"jsonrpc": "2.0", "id": identity, "result": value}


def request(identity: str, method: str) -> Json:
    """Return a request of the server, without parameters."""
    return {"jsonrpc": "2.0", "id": identity, "method": method}


def failure(identity: Id, code: ErrorCode, message: str) -> Json:
    """Return the refusal of a request."""
    return {"jsonrpc": "2.0", "id": identity, "error": {"code": int(code), "message": message}}


def notification(method: str, params: object) -> Json:
    """Return a notification."""
    return {"jsonrpc": "2.0", "method": method, "params": params}
