"""Lists of points of a project in the editor: offered, explained, and missed where they are not there."""

from pathlib import Path

import pytest

from ropsim.workbench import new_project
from support.editors import Editor, uri_of

LIST = "name,x,y,z\n,mm,mm,mm\na,500,-100,600\nb,500,0,600\nc,500,100,600\n"
HEAD = "program t\nunits mm, deg, s\npattern slots = grid 2 from (500, 0, 600) step (1, 2, 3)\n"


@pytest.fixture
def uri(tmp_path: Path) -> str:
    folder = new_project(tmp_path / "cell", "first_cell")
    (folder / "points").mkdir()
    (folder / "points" / "seam.csv").write_text(LIST, "utf-8")
    return uri_of(folder / "programs" / "main.task")


def labels(marked: str, uri: str) -> list[str]:
    items = Editor().at_mark("completion", uri, HEAD + marked)["items"]
    return [item["label"] for item in sorted(items, key=lambda item: item["sortText"])]


@pytest.mark.parametrize("verb", ["lin", "spline", "mov"])
def test_behind_along_lists_are_offered(verb: str, uri: str) -> None:
    assert labels(f"{verb} along |", uri) == ["seam"]


def test_a_loop_over_places_takes_patterns_and_lists(uri: str) -> None:
    assert labels("for each p in |", uri) == ["seam", "slots"]


def test_a_list_is_no_value(uri: str) -> None:
    assert "pick_up" in labels("lin |", uri)
    assert "seam" not in labels("lin |", uri)


def test_a_list_says_how_many_points_it_has_and_where(uri: str) -> None:
    answer = Editor().at_mark("hover", uri, f"{HEAD}lin along se|am\n")
    text = str(answer["contents"]["value"])
    assert "list of points, `points/seam.csv`" in text
    assert "3 points, 200 mm from one to the next" in text
    assert "(500, -100, 600) mm" in text


def test_a_chain_is_explained_as_a_motion(uri: str) -> None:
    answer = Editor().at_mark("hover", uri, f"{HEAD}li|n along seam\n")
    assert "along LIST" in str(answer["contents"]["value"])


@pytest.mark.parametrize(
    ("verb", "offered"), [("lin", True), ("mov", True), ("spline", True), ("circ", False)]
)
def test_along_is_offered_behind_a_verb_that_takes_a_list(verb: str, offered: bool, uri: str) -> None:
    assert ("along" in labels(f"{verb} |", uri)) is offered


def test_without_lists_along_is_not_offered(uri: str, tmp_path: Path) -> None:
    (tmp_path / "cell" / "points" / "seam.csv").unlink()
    assert "along" not in labels("lin |", uri)


def test_names_of_points_are_offered_within_the_index_of_their_list(uri: str) -> None:
    assert labels('lin seam["|"]', uri) == ["a", "b", "c"]
    assert labels('print "seam|', uri) == []
    assert labels('lin slots["|', uri) == []
