"""Capabilities that an editor declares at the start, as far as the server uses them."""

from collections.abc import Sequence

from ropsim.lsp.protocol.document import ENCODINGS


def encoding_of(params: object) -> str:
    """Return in which units positions count: the first of the editor's that is known, else UTF-16."""
    offered = _at(params, ("capabilities", "general", "positionEncodings"))
    known = (one for one in offered if one in ENCODINGS) if isinstance(offered, list) else ()
    return next(iter(known), ENCODINGS[0])


def pulls_of(params: object) -> bool:
    """Return whether the editor requests findings itself and supports a refresh request.

    An editor without refresh would not notice findings of programs that a change of the cell causes.
    """
    asks = isinstance(_at(params, ("capabilities", "textDocument", "diagnostic")), dict)
    return asks and _at(params, ("capabilities", "workspace", "diagnostics", "refreshSupport")) is True


def marks_lines_of(params: object) -> bool:
    """Return whether the editor shows which results of lines are valid for the text: it declares so."""
    return _at(params, ("capabilities", "experimental", "ropsimLineStates")) is True


def _at(value: object, path: Sequence[str]) -> object:
    for key in path:
        value = value.get(key) if isinstance(value, dict) else None
    return value
