"""`ropsim part`: lists, parameters with their origins, pictures."""

import json
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.parts import PART_KINDS
from ropsim.views import part_print, png_words


def test_every_kind_is_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["part", "list"]) == 0
    rows = capsys.readouterr().out.splitlines()
    assert [row.split()[0] for row in rows[1:]] == list(PART_KINDS)


@pytest.mark.parametrize("kind", PART_KINDS.values(), ids=lambda kind: kind.name)
def test_a_kind_shows_its_parameters_models_and_sources(
    kind: object, capsys: pytest.CaptureFixture[str]
) -> None:
    name = getattr(kind, "name", "")
    assert main(["part", "show", name]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert all(one.meaning in text for one in PART_KINDS[name].parameters)
    assert all(one.name in text and one.source in text for one in PART_KINDS[name].products)


def test_the_document_has_ranges_in_si_units(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["part", "show", "fence", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    (length,) = (one for one in document["parameters"] if one["name"] == "length")
    assert (length["default"], length["low"], length["high"]) == (3.0, 0.3, 12.0)
    assert length["origin"] == "estimated"


def test_the_tcp_of_a_model_is_shown_with_its_origin(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["part", "show", "two_finger_gripper", "--model", "franka_hand"]) == 0
    text = capsys.readouterr().out
    assert "franka_hand: TCP at 103.4 mm (published)" in text
    assert "TCP at 141 mm (estimated)" in text
    assert main(["part", "show", "two_finger_gripper", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["tcp"]["origin"] == "estimated"
    (hand,) = (one for one in document["models"] if one["name"] == "franka_hand")
    assert hand["tcp"] == {"distance": pytest.approx(0.1034), "origin": "published"}
    assert main(["part", "show", "fence", "--json"]) == 0
    assert "tcp" not in json.loads(capsys.readouterr().out)


def test_a_picture_is_of_the_model(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from ropsim.parts import library_part

    file = tmp_path / "hand.png"
    words = ["part", "show", "two_finger_gripper", "--model", "franka_hand", "--png", str(file)]
    assert main(words) == 0
    assert f"wrote {file}" in capsys.readouterr().out
    drawn = png_words(file.read_bytes())
    assert drawn["Title"] == "franka_hand"
    assert drawn["Source"] == part_print(library_part("two_finger_gripper", "franka_hand"))


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["show", "fense"], "did you mean `fence`?"),
        (["show", "eur_pallet", "--model", "eur1"], "did you mean `eur_1`?"),
    ],
)
def test_an_unknown_name_is_a_finding(
    words: list[str], hint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["part", *words]) == 2
    shown = capsys.readouterr()
    assert "X925" in shown.out + shown.err
    assert hint in shown.out + shown.err


def test_a_picture_that_cannot_be_written_is_a_finding(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("", "utf-8")
    assert main(["part", "show", "fence", "--png", str(tmp_path / "file" / "a.png")]) == 2
    shown = capsys.readouterr()
    assert "a.png" in shown.out + shown.err
