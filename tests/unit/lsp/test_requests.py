"""Requests: each one is announced, described and asked at random; what is announced is answered."""

import re
from typing import Any

import pytest

from ropsim.lsp.testing import CAPABILITIES, REQUESTS
from support.fuzzing.server import SESSION
from support.manual import DOCS

CAPABILITY: dict[str, tuple[str, ...]] = {
    "textDocument/prepareRename": ("renameProvider", "prepareProvider"),
    "textDocument/semanticTokens/full": ("semanticTokensProvider", "full"),
    "textDocument/semanticTokens/full/delta": ("semanticTokensProvider", "full", "delta"),
    "textDocument/semanticTokens/range": ("semanticTokensProvider", "range"),
    "textDocument/formatting": ("documentFormattingProvider",),
    "workspace/symbol": ("workspaceSymbolProvider",),
}
"""Where the protocol has the capability of a method, if that is not its name with `Provider` behind it."""


def capability(method: str) -> tuple[str, ...]:
    return CAPABILITY.get(method, (f"{method.rpartition('/')[2]}Provider",))


def described() -> set[str]:
    """Return the methods of the table; others of a row go on from some part of its first."""
    found = set()
    page = (DOCS / "reference" / "language-server.md").read_text("utf-8")
    for row in re.findall(r"^\| (`\w+/.*?) \|", page, re.MULTILINE):
        first, *others = re.findall(r"`([^`]+)`", row)
        found.add(first)
        parts = first.split("/")[:-1]
        for other in others:
            begins = ["/".join((*parts[:count], other)) for count in range(len(parts) + 1)]
            found.add(next((one for one in begins if one in REQUESTS), other))
    return found


@pytest.mark.parametrize("method", REQUESTS)
def test_a_request_is_announced_among_the_capabilities(method: str) -> None:
    value: Any = CAPABILITIES
    for key in capability(method):
        assert key in value
        value = value[key]
    assert value


@pytest.mark.parametrize("method", REQUESTS)
def test_a_request_is_described_in_the_manual_and_asked_at_random(method: str) -> None:
    assert method in described()
    assert method in {message["method"] for message in SESSION}


def test_nothing_is_announced_that_is_not_answered() -> None:
    providers = {key for key in CAPABILITIES if key.endswith("Provider")}
    assert providers == {capability(method)[0] for method in REQUESTS}
