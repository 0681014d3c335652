"""The replay's part of a report: data that stay data, scripts that the content policy knows."""

import base64
import hashlib
import json
import re
from html.parser import HTMLParser

import pytest

from ropsim.views import NoReplay, Replay, html_report, summarize
from ropsim.views.testing import inline_script, inline_style
from support.recordings import SOURCE, pick_and_place

HOSTILE = '</script><script>alert("x")</script><!--<script>'


class Scripts(HTMLParser):
    """Gathers the script elements of a page by type and id."""

    def __init__(self) -> None:
        super().__init__()
        self.running: list[str] = []
        self.data: dict[str, str] = {}
        self._now: dict[str, str | None] | None = None

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "script":
            self._now = dict(attrs)
            if "type" not in self._now:
                self.running.append("")

    def handle_data(self, data: str) -> None:
        if self._now is None:
            return
        if "type" in self._now:
            ident = str(self._now["id"])
            self.data[ident] = self.data.get(ident, "") + data
        else:
            self.running[-1] += data

    def handle_endtag(self, tag: str) -> None:
        if tag == "script":
            self._now = None


def page(replay: Replay | NoReplay | None) -> str:
    recording = pick_and_place()
    return html_report(recording, summarize(recording), {SOURCE.name: SOURCE}, replay)


def scripts(text: str) -> Scripts:
    found = Scripts()
    found.feed(text)
    return found


@pytest.fixture
def replay() -> Replay:
    texts = json.dumps({"main.task": HOSTILE})
    return Replay(f"const text = '{HOSTILE}'", ".a {}", '{"a": 1}', "UlBLMQ==", texts, {"f00": "Z0xURg=="})


def test_data_come_back_as_they_were(replay: Replay) -> None:
    data = scripts(page(replay)).data
    assert json.loads(data["replay-texts"]) == {"main.task": HOSTILE}
    assert json.loads(data["replay-scene"]) == {"a": 1}
    assert data["replay-pack"] == "UlBLMQ=="
    assert data["replay-mesh-f00"] == "Z0xURg=="


def test_the_policy_allows_just_the_scripts_of_the_page(replay: Replay) -> None:
    text = page(replay)
    running = scripts(text).running
    assert len(running) == 2
    digests = [base64.b64encode(hashlib.sha256(one.encode()).digest()).decode() for one in running]
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)
    assert policy is not None
    allowed = re.search(r"script-src ([^;]*)$", policy[1].replace("&#39;", "'"))
    assert allowed is not None
    assert allowed[1].split() == [f"'sha256-{digest}'" for digest in digests]


def test_a_script_cannot_end_its_element() -> None:
    safe = inline_script("a = '</script>'; b = /<!--/u; c = `</SCRIPT`")
    assert safe == r"a = '\x3c/script>'; b = /\x3c!--/u; c = `\x3c/SCRIPT`"
    assert inline_style("a::after { content: '</style>' }") == r"a::after { content: '<\/style>' }"


def test_the_replay_stands_above_the_figures(replay: Replay) -> None:
    text = page(replay)
    assert text.index('id="replay"') < text.index('class="figures"')


def test_a_report_without_replay_says_why() -> None:
    text = page(NoReplay("No 3-D replay: <reason>."))
    assert '<p class="quiet screen">No 3-D replay: &lt;reason&gt;.</p>' in text
    assert 'id="replay"' not in text
    assert len(scripts(text).running) == 1


def test_a_report_of_a_bare_recording_does_not_speak_of_it() -> None:
    assert "eplay" not in page(None)
