"""Who may talk to the studio: our own pages with a valid key in a browser of this machine."""

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ropsim.studio.web.entry import Entry
from ropsim.studio.web.refusals import REFUSALS, Refusal, refuse

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")

CONTENT_POLICY = (
    "default-src 'self'; script-src 'self'; style-src 'self'; style-src-elem 'self'{nonce}; "
    "style-src-attr 'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' blob:; "
    "connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""Sources that a page may load. Editors make style elements at run time: they carry the nonce of the page."""

ALWAYS = {
    "x-content-type-options": "nosniff",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
}


OPEN = ("/assets/",)
"""Paths served to every client of this machine, like the page itself: they contain nothing of a project."""


class Gate:
    """Lets only requests through that carry our own host, our own origin and the ticket of a page.

    The host is compared with the very port (DNS rebinding leads to others), the origin wherever a request can
    change something. Sockets prove themselves once they are open (`Entry`). No cookie is set or read.

    Args:
        app: application behind the gate.
        port: on which the server listens.
        entry: checks the ticket.
    """

    def __init__(self, app: ASGIApp, port: int, entry: Entry) -> None:
        self._app = app
        self._entry = entry
        bare = LOOPBACK if port == 80 else ()
        self._hosts = frozenset((*(f"{name}:{port}" for name in LOOPBACK), *bare))
        self._origins = frozenset(f"http://{host}" for host in self._hosts)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        sender = _with_headers(send)
        refusal = self._refusal(scope)
        if refusal is not None:
            await refuse(scope, sender, refusal)
            return
        await self._app(scope, receive, sender)

    def _refusal(self, scope: Scope) -> Refusal | None:
        headers = Headers(scope=scope)
        if headers.get("host", "") not in self._hosts:
            return REFUSALS["host"]
        reads = scope["type"] == "http" and scope["method"] in {"GET", "HEAD"}
        if not reads and headers.get("origin") not in self._origins:
            return REFUSALS["origin"]
        path: str = scope["path"]
        is_open = scope["type"] == "websocket" or path == "/" or path.startswith(OPEN)
        if is_open or self._entry.has_ticket(headers.get("authorization", "")):
            return None
        return REFUSALS["ticket"]


def content_policy(nonce: str = "") -> str:
    """Return the content policy of a response; with a nonce, style elements that carry it are allowed."""
    return CONTENT_POLICY.format(nonce=f" 'nonce-{nonce}'" if nonce else "")


def _with_headers(send: Send) -> Send:
    """Return a sender that adds the headers which every response has."""

    async def send_with_headers(message: Message) -> None:
        if message["type"] in {"http.response.start", "websocket.http.response.start"}:
            headers = MutableHeaders(scope=message)
            for name, value in ALWAYS.items():
                headers[name] = value
            headers.setdefault("content-security-policy", content_policy())
            headers.setdefault("cache-control", "no-store")
        await send(message)

    return send_with_headers
