"""What an editor says of itself when it begins, as far as the server heeds it."""

from collections.abc import Sequence

from ropsim.lsp.protocol.document import ENCODINGS


def encoding_of(params: object) -> str:
    """Return in which units positions count: the first of the editor's that is known, else UTF-16."""
    offered = _at(params, ("capabilities", "general", "positionEncodings"))
    known = (one for one in offered if one in ENCODINGS) if isinstance(offered, list) else ()
    return next(iter(known), ENCODINGS[0])


def pulls_of(params: object) -> bool:
    """Return whether the editor asks for findings itself and can be told to ask again.

    One that cannot be told would not know of what a change of the cell means for its programs.
    """
    asks = isinstance(_at(params, ("capabilities", "textDocument", "diagnostic")), dict)
    return asks and _at(params, ("capabilities", "workspace", "diagnostics", "refreshSupport")) is True


def marks_lines_of(params: object) -> bool:
    """Return whether the editor shows which results of lines are those of the text: it says so itself."""
    return _at(params, ("capabilities", "experimental", "ropsimLineStates")) is True


def _at(value: object, path: Sequence[str]) -> object:
    for key in path:
        value = value.get(key) if isinstance(value, dict) else None
    return value
