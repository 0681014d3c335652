"""How a page enters: it proves knowledge of a key of the studio without sending it, and gets a ticket.

Browsers send cookies to every server of this machine, on any port, so none is used. A page has its key from
the fragment of the address, which browsers never send, and keeps it for its tab. The first message on each
socket is a challenge; the page answers with a code of challenge and port under its key. A stranger that has
taken the port of a studio learns nothing from that: it holds for this challenge and port only.
"""

import asyncio
import hmac
import secrets

import msgspec
from msgspec import Struct
from starlette.websockets import WebSocket, WebSocketDisconnect

REFUSED = 4401
"""Code with which a socket is closed whose page has no valid key."""

PATIENCE = 20.0
"""How long a page may take to answer the challenge [s]."""


class Answer(Struct, frozen=True, tag_field="type", tag="enter"):
    """Answer of a page to the challenge: HMAC-SHA-256 of it under the key, in hexadecimal digits."""

    answer: str


class Challenge(Struct, frozen=True, tag_field="type", tag="challenge"):
    """The first message of a socket: a number that is used once."""

    nonce: str


class Entered(Struct, frozen=True, tag_field="type", tag="entered"):
    """The page is in.

    Attributes:
        ticket: goes with each request over HTTP until this studio ends.
        key: of the project, for the tab to keep: with it the page also enters the next studio of the project.
    """

    ticket: str
    key: str


class Entry:
    """Decides who may enter.

    Args:
        port: on which the server listens.
        token: key in the address that the terminal shows, new at each start.
        once: key that is good a single time, in the address with which a browser is started; empty for none.
            Lists of processes show that address to other users of this machine.
        kept: key of the project, never a part of an address; empty for the one of this start.
    """

    def __init__(self, port: int, token: str, once: str = "", kept: str = "") -> None:
        self._port = port
        self._token = token
        self._once = once
        self._kept = kept or token
        self.ticket = secrets.token_urlsafe(24)

    async def admits(self, socket: WebSocket) -> bool:
        """Let the page of an accepted socket prove itself; where it cannot, the socket is closed."""
        challenge = Challenge(secrets.token_urlsafe(24))
        await _send(socket, challenge)
        try:
            text = await asyncio.wait_for(socket.receive_text(), PATIENCE)
            answer = msgspec.json.decode(text, type=Answer).answer
        except (WebSocketDisconnect, TimeoutError, KeyError, ValueError, RecursionError):
            answer = ""
        if self.is_right(challenge.nonce, answer):
            await _send(socket, Entered(self.ticket, self._kept))
            return True
        await socket.close(REFUSED, "the page does not know the key")
        return False

    def is_right(self, nonce: str, answer: str) -> bool:
        """Return whether an answer to a challenge was made with a key; the one for one time is used up."""
        if any(_same(answer, code(key, nonce, self._port)) for key in (self._kept, self._token)):
            return True
        right = bool(self._once) and _same(answer, code(self._once, nonce, self._port))
        if right:
            self._once = ""
        return right

    def has_ticket(self, authorization: str) -> bool:
        """Return whether a header `Authorization` carries the ticket."""
        return _same(authorization, f"Bearer {self.ticket}")


def code(key: str, nonce: str, port: int) -> str:
    """Return the answer to a challenge."""
    return hmac.digest(key.encode(), f"{nonce} {port}".encode(), "sha256").hex()


def _same(given: str, wanted: str) -> bool:
    return secrets.compare_digest(given.encode("utf-8", "replace"), wanted.encode())


async def _send(socket: WebSocket, message: Challenge | Entered) -> None:
    await socket.send_text(msgspec.json.encode(message).decode())
