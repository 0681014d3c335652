"""Messages in a byte stream: `Content-Length` headers, a blank line, the body."""

import re

from ropsim.core import frozen_dataclass

#: Longest header and longest body that are read [bytes].
MAX_HEADER = 4096
MAX_BODY = 32_000_000

_END = b"\r\n\r\n"
_LENGTH = re.compile(rb"^content-length:[ \t]*(\d{1,12})[ \t]*$", re.IGNORECASE | re.MULTILINE)
_START = re.compile(rb"content-length:", re.IGNORECASE)


@frozen_dataclass
class FrameFault:
    """Bytes that are no message; they are skipped."""

    message: str


class FrameReader:
    """Cuts a byte stream into message bodies; bytes that make no sense are skipped up to the next header."""

    __slots__ = ("_buffer", "_skip")

    def __init__(self) -> None:
        self._buffer = bytearray()
        self._skip = 0

    def feed(self, data: bytes) -> list[bytes | FrameFault]:
        """Take the next bytes and return the messages that they complete."""
        self._buffer += data
        found: list[bytes | FrameFault] = []
        while (one := self._next()) is not None:
            found.append(one)
        return found

    def _next(self) -> bytes | FrameFault | None:
        if self._skip:
            gone = min(self._skip, len(self._buffer))
            del self._buffer[:gone]
            self._skip -= gone
            if self._skip:
                return None
        end = self._buffer.find(_END)
        if end > MAX_HEADER or (end < 0 and len(self._buffer) > MAX_HEADER):
            self._resume()
            return FrameFault(f"no header within {MAX_HEADER} bytes")
        if end < 0:
            return None
        header = bytes(self._buffer[:end]).replace(b"\r\n", b"\n")
        length = _LENGTH.search(header)
        if length is None:
            del self._buffer[: end + len(_END)]
            return FrameFault("a header without `Content-Length`")
        size, start = int(length[1]), end + len(_END)
        if size > MAX_BODY:
            del self._buffer[:start]
            self._skip = size
            return FrameFault(f"a message of {size} bytes; at most {MAX_BODY} are read")
        if len(self._buffer) < start + size:
            return None
        body = bytes(self._buffer[start : start + size])
        del self._buffer[: start + size]
        return body

    def _resume(self) -> None:
        """Drop bytes up to the next header; keep a tail in which one may have begun."""
        following = _START.search(self._buffer, 1)
        del self._buffer[: following.start() if following else len(self._buffer) - len(b"content-length:")]


def framed(body: bytes) -> bytes:
    """Return a message body with its header."""
    return b"Content-Length: %d\r\n\r\n%s" % (len(body), body)
