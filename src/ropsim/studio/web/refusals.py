"""Answers to requests that do not get through the gate, in words."""

from collections.abc import Mapping
from dataclasses import field

from starlette.types import Scope, Send

from ropsim.core import frozen_dataclass

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>ropsim studio</title></head>
<body><h1>ropsim studio</h1><p>{words}</p></body></html>
"""


@frozen_dataclass
class Refusal:
    """A short answer.

    Attributes:
        status: of HTTP.
        words: shown to the user.
        headers: further ones.
    """

    status: int
    words: str
    headers: Mapping[str, str] = field(default_factory=dict)


REFUSALS = {
    "host": Refusal(400, "The studio answers to 127.0.0.1 and localhost only, with its own port."),
    "origin": Refusal(403, "This request comes from another site. Only the studio's own pages may make it."),
    "ticket": Refusal(401, "This is for the pages of the studio only, which have a ticket of it."),
}


async def refuse(scope: Scope, send: Send, refusal: Refusal) -> None:
    """Answer a request of any kind, including sockets."""
    if scope["type"] == "websocket":
        if "websocket.http.response" not in scope.get("extensions", {}):
            await send({"type": "websocket.close", "code": 1008, "reason": ""})
            return
        prefix = "websocket.http.response"
    else:
        prefix = "http.response"
    body = PAGE.format(words=refusal.words).encode() if refusal.words else b""
    headers = {
        "content-type": "text/html; charset=utf-8",
        "content-length": str(len(body)),
        **refusal.headers,
    }
    pairs = [(name.encode(), value.encode()) for name, value in headers.items()]
    await send({"type": f"{prefix}.start", "status": refusal.status, "headers": pairs})
    await send({"type": f"{prefix}.body", "body": body})
