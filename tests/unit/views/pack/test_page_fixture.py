"""The run that the tests of the pages read: `make check` compares its keys with those of a run of today."""

import base64
import gzip
import json
from pathlib import Path

import pytest
from tools import pack_fixture


def fixture(header: dict[str, object], duration: float) -> dict[str, object]:
    text = json.dumps(header).encode()
    content = gzip.compress(b"RPK1" + len(text).to_bytes(4, "little") + text + b"columns")
    return {"pack": base64.b64encode(content).decode("ascii"), "duration": duration}


@pytest.fixture
def kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    run = fixture({"facts": {"stations": [{"name": "a"}, {"law": "b"}]}, "result": {"moves": 2}}, 4.0)
    monkeypatch.setattr(pack_fixture, "document", lambda: run)
    path = tmp_path / "kept.json"
    monkeypatch.setattr(pack_fixture, "FIXTURE", path)
    return path


def test_a_key_that_the_fixture_lacks_or_has_too_many_is_named(
    kept: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old = {"facts": {"stations": [{"name": "a"}]}, "result": {"moves": 2, "turns": 1}}
    kept.write_text(json.dumps(fixture(old, 4.0)), "utf-8")
    assert pack_fixture.main(["--check"]) == 1
    told = capsys.readouterr().out.splitlines()
    assert told[1:] == ["  lacks pack.facts.stations.law", "  has pack.result.turns"]


def test_other_numbers_of_the_same_keys_are_no_difference(kept: Path) -> None:
    kept.write_text("{}", "utf-8")
    assert pack_fixture.main([]) == 0
    assert pack_fixture.main(["--check"]) == 0
    other = {"facts": {"stations": [{"name": "x", "law": ""}]}, "result": {"moves": 7}}
    kept.write_text(json.dumps(fixture(other, 5.0)), "utf-8")
    assert pack_fixture.main(["--check"]) == 0
