"""Who may talk to the studio: a browser of this machine that knows the address, and our own pages only."""

import secrets
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ropsim.studio.refusals import REFUSALS, Refusal, refuse

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")

CONTENT_POLICY = (
    "default-src 'self'; script-src 'self'; style-src 'self'; style-src-elem 'self'{nonce}; "
    "style-src-attr 'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' blob:; "
    "connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""What a page may load. Editors make style elements at run time: they carry the nonce of the page."""

ALWAYS = {
    "x-content-type-options": "nosniff",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
}


class Gate:
    """Lets only requests through that carry our own host, our own origin and the secret of the project.

    The host is compared with the very port (DNS rebinding gives others), the origin wherever a request can
    change something. The first address, which is new at each start, brings the secret: it stays in a cookie
    that scripts cannot see.

    Args:
        app: what is behind the gate.
        port: on which the server listens.
        token: the secret.
        once: opens the first address too, a single time; empty for none. Lists of processes show other users
            of this machine with which address a browser was started.
        kept: what the cookie holds, never a part of an address; empty for the secret of this start.
    """

    def __init__(self, app: ASGIApp, port: int, token: str, once: str = "", kept: str = "") -> None:
        self._app = app
        self._token = token
        self._once = once
        self._kept = kept or token
        self._cookie = f"ropsim-{port}"
        bare = LOOPBACK if port == 80 else ()
        self._hosts = frozenset((*(f"{name}:{port}" for name in LOOPBACK), *bare))
        self._origins = frozenset(f"http://{host}" for host in self._hosts)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        sender = _with_headers(send)
        if self._is_first(scope):
            cookie = f"{self._cookie}={self._kept}; HttpOnly; SameSite=Strict; Path=/"
            await refuse(scope, sender, Refusal(303, "", {"location": "/", "set-cookie": cookie}))
            return
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
        cookies = cookie_parser(headers.get("cookie", ""))  # those of other servers on this machine, too
        return None if _same(cookies.get(self._cookie, ""), self._kept) else REFUSALS["token"]

    def _is_first(self, scope: Scope) -> bool:
        """Return whether this is the address that the terminal shows."""
        if scope["type"] != "http" or scope["method"] != "GET" or scope["path"] != "/":
            return False
        if Headers(scope=scope).get("host", "") not in self._hosts:
            return False
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])
        return self._is_ours(given[0]) or self._is_once(given[0])

    def _is_ours(self, secret: str) -> bool:
        return _same(secret, self._token)

    def _is_once(self, secret: str) -> bool:
        right = bool(self._once) and _same(secret, self._once)
        if right:
            self._once = ""
        return right


def _same(secret: str, other: str) -> bool:
    return secrets.compare_digest(secret.encode("utf-8", "replace"), other.encode())


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
