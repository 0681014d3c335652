"""The gate, asked by hand: no server is needed to see whom it lets through."""

import asyncio
from typing import Any

import pytest
from starlette.types import Message, Receive, Scope, Send

from ropsim.studio.testing import Entry, Gate, code, content_policy

PORT = 8123
TOKEN = "s3cret"
HOST = f"127.0.0.1:{PORT}"
ENTRY = Entry(PORT, TOKEN)
OURS = {"host": HOST, "authorization": f"Bearer {ENTRY.ticket}"}


async def behind(scope: Scope, receive: Receive, send: Send) -> None:
    await send({"type": "http.response.start", "status": 299, "headers": []})
    await send({"type": "http.response.body", "body": b"through"})


def ask(
    headers: dict[str, str], path: str = "/", query: str = "", **scope: Any
) -> tuple[int, dict[str, str]]:
    """Return status and headers of the answer to a request."""
    return answered(Gate(behind, PORT, ENTRY), headers, path, query, **scope)


def answered(
    gate: Gate, headers: dict[str, str], path: str = "/", query: str = "", **scope: Any
) -> tuple[int, dict[str, str]]:
    """Return status and headers of a gate's answer to a request."""
    sent: list[Message] = []

    async def send(message: Message) -> None:
        sent.append(message)

    async def receive() -> Message:
        return {"type": "http.request", "body": b"", "more_body": False}

    pairs = [(name.encode(), value.encode("latin-1")) for name, value in headers.items()]
    whole = {
        "type": "http",
        "method": "GET",
        "path": path,
        "query_string": query.encode(),
        "headers": pairs,
        "extensions": {"websocket.http.response": {}},
        **scope,
    }
    asyncio.run(gate(whole, receive, send))
    if sent[0]["type"] == "websocket.close":
        return 0, {}
    return sent[0]["status"], {name.decode(): value.decode() for name, value in sent[0]["headers"]}


@pytest.mark.parametrize("host", [HOST, f"localhost:{PORT}", f"[::1]:{PORT}"])
def test_our_own_requests_get_through(host: str) -> None:
    assert ask({**OURS, "host": host})[0] == 299


@pytest.mark.parametrize(
    "host",
    ["", "evil.example", f"evil.example:{PORT}", "127.0.0.1", "127.0.0.1:80", f"127.0.0.1:{PORT}.evil"],
)
@pytest.mark.parametrize("path", ["/", "/assets/index.js", "/ws/studio"])
def test_another_host_is_refused_before_anything_else(host: str, path: str) -> None:
    assert ask({**OURS, "host": host}, path, f"token={TOKEN}")[0] == 400


@pytest.mark.parametrize(
    "origin", ["https://evil.example", "null", "http://127.0.0.1:9999", f"https://{HOST}", None]
)
@pytest.mark.parametrize("scope", [{"type": "websocket"}, {"method": "POST"}, {"method": "DELETE"}])
def test_sockets_and_changes_need_our_own_origin(origin: str | None, scope: dict[str, str]) -> None:
    headers = OURS if origin is None else {**OURS, "origin": origin}
    assert ask(headers, "/ws/studio", **scope)[0] == 403
    assert ask({**OURS, "origin": f"http://{HOST}"}, "/ws/studio", **scope)[0] == 299


def test_a_server_that_cannot_answer_sockets_closes_them() -> None:
    assert ask(OURS, "/ws/studio", type="websocket", extensions={})[0] == 0


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"authorization": ""},
        {"authorization": "Bearer "},
        {"authorization": f"Bearer {TOKEN}"},
        {"authorization": "Bearer \xfc"},
        {"cookie": f"ropsim-{PORT}={TOKEN}"},
        {"cookie": OURS["authorization"]},
    ],
)
def test_without_the_ticket_nothing_of_a_project_is_shown(headers: dict[str, str]) -> None:
    for path in ("/run/1.pack", "/told/1.pack", "/mesh/0.glb", "/x", "/assets", "//", "/x/../assets/"):
        assert ask({"host": HOST, **headers}, path)[0] == 401
        assert ask({"host": HOST, **headers}, path, query=f"token={TOKEN}")[0] == 401
        assert ask(OURS, path)[0] == 299
    for path in ("/", "/assets/index.js"):
        assert ask({"host": HOST, **headers}, path)[0] == 299


def test_every_answer_carries_the_headers_that_protect_it() -> None:
    for headers in (OURS, {"host": HOST}, {"host": "evil.example"}):
        _, answer = ask(headers)
        assert answer["x-content-type-options"] == "nosniff"
        assert answer["cross-origin-opener-policy"] == "same-origin"
        assert answer["referrer-policy"] == "no-referrer"
        assert answer["content-security-policy"] == content_policy()


def test_the_policy_allows_no_script_but_files_of_ours_and_style_elements_with_the_nonce_only() -> None:
    rules = dict(rule.strip().split(" ", 1) for rule in content_policy("abc").split(";"))
    assert rules["script-src"] == rules["default-src"] == "'self'"
    assert rules["style-src-elem"] == "'self' 'nonce-abc'"
    assert rules["frame-ancestors"] == rules["object-src"] == rules["base-uri"] == "'none'"


def test_the_address_that_a_browser_is_started_with_works_once() -> None:
    entry = Entry(PORT, TOKEN, "0nce", "kept")
    assert not entry.is_right("n", code("", "n", PORT))
    assert not entry.is_right("n", code("0nce", "another", PORT))  # which does not use it up
    assert entry.is_right("n", code("0nce", "n", PORT))
    assert not entry.is_right("n", code("0nce", "n", PORT))
    for key in (TOKEN, "kept"):
        assert entry.is_right("n", code(key, "n", PORT))
        assert entry.is_right("n", code(key, "n", PORT))


def test_an_answer_holds_for_its_challenge_and_its_port() -> None:
    assert ENTRY.is_right("n", code(TOKEN, "n", PORT))
    for answer in ("", TOKEN, code(TOKEN, "m", PORT), code(TOKEN, "n", PORT + 1), code("x", "n", PORT), "ü"):
        assert not ENTRY.is_right("n", answer)
