"""Texts of tasks in the editor: findings as one types, names and places, and calls from programs."""

from pathlib import Path
from typing import Any

import pytest

from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of

WAVE = """\
task(wave(L, H), [
  doc("Waves over a location."),
  params([L-location, H-length = 20*mm]),
  body([mov(above(L, H)), mov(L)])]).
"""


class Desk:
    """An editor with a project: a text of tasks and a program that calls one of them."""

    def __init__(self, folder: Path) -> None:
        new_project(folder)
        (folder / "kb").mkdir()
        self.tasks, self.program = uri_of(folder / "kb" / "own.pl"), uri_of(folder / "programs" / "main.task")
        self.editor = Editor()

    def found(self, text: str) -> list[tuple[str, int, int, str]]:
        """Return the findings of the text of tasks: code, line, column from 1, first line of the words."""
        found = self.editor.open(self.tasks, text)
        starts = [one["range"]["start"] for one in found]
        return [
            (one["code"], at["line"] + 1, at["character"] + 1, one["message"].partition("\n")[0])
            for one, at in zip(found, starts, strict=True)
        ]

    def proposed(self, marked: str) -> list[str]:
        answer = self.editor.at_mark("completion", self.tasks, marked)
        return [one["label"] for one in answer["items"]]

    def at(self, method: str, uri: str, line: int, character: int) -> Any:
        return self.editor.ask(
            f"textDocument/{method}", textDocument={"uri": uri}, position=place(line - 1, character - 1)
        )


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Desk:
    return Desk(tmp_path_factory.mktemp("project") / "p")


def test_findings_are_told_as_one_types_and_the_rest_of_the_text_goes_on(desk: Desk) -> None:
    assert desk.found(WAVE) == []
    broken = f"task(two(L), [params([L-locaton])\n{WAVE}"
    assert [one[:2] for one in desk.found(broken)] == [("P101", 1)]
    assert desk.found(WAVE.replace("L-location", "L-locaton"))[0][:3] == ("P132", 3, 11)
    body = WAVE.replace("mov(L)]", "set(nosuch, on)]")
    (found,) = desk.found(body)
    assert found[:3] == ("P147", 1, 1)
    assert "there is no output `nosuch`" in found[3]
    (unknown,) = desk.found(WAVE.replace("mov(L)]", "call(piick(L))]"))
    assert unknown == ("P133", 4, 27, "Task not defined: `piick`")


def test_a_program_is_looked_at_again_when_a_task_is_typed(desk: Desk) -> None:
    desk.editor.open(desk.program, "program p\nunits mm\nwave (400, 0, 500), 5\n")
    desk.editor.open(desk.tasks, "")
    desk.editor.type(desk.tasks, (0, 0), (0, 0), WAVE)
    assert desk.editor.settle() == {desk.tasks: [], desk.program: []}
    desk.editor.type(desk.tasks, (0, 5), (0, 9), "weave")
    told = desk.editor.settle()
    assert [(one["code"], one["data"]["hint"]) for one in told[desk.program]] == [
        ("N201", "did you mean `weave`?")
    ]


def test_a_call_leads_to_the_task_and_shows_what_it_is_for(desk: Desk) -> None:
    desk.editor.open(desk.tasks, f"\n{WAVE}task(two(L), [params([L-location]), body([call(wave(L))])]).\n")
    desk.editor.open(desk.program, "program p\nunits mm\nwave (400, 0, 500), 5\ncall pick (400, 0, 500)\n")
    there = {"uri": desk.tasks, "range": {"start": place(1, 5), "end": place(1, 9)}}
    assert desk.at("definition", desk.program, 3, 2) == there
    assert desk.at("definition", desk.tasks, 6, 50) == there
    library = desk.at("definition", desk.program, 4, 7)
    assert Path(library["uri"]).name == "pick.pl"
    assert library["range"]["start"] == place(2, 5)
    told = desk.at("hover", desk.program, 3, 2)["contents"]["value"]
    assert "wave(l: loc, h: length" in told
    assert "Waves over a location" in told
    assert "kb/own.pl, line 2" in told
    assert "Waves over a location" in desk.at("hover", desk.tasks, 6, 50)["contents"]["value"]
    assert [one["name"] for one in desk.at("documentSymbol", desk.tasks, 1, 1)] == ["wave", "two"]
    assert "message" in desk.at("prepareRename", desk.program, 3, 2)


def test_words_are_proposed_where_they_fit(desk: Desk) -> None:
    begin = 'task(go(L), [doc("a) b"), '
    assert desk.proposed(f"{begin}|")[:3] == ["doc", "params", "words"]
    assert {"location", "part"} <= set(desk.proposed(f"{begin}params([L-lo|"))
    assert {"mov", "wait_until"} <= set(desk.proposed(f"{begin}body([mov(L), repeat(3, [|"))
    assert "palletize" in desk.proposed(f"{begin}body([call(pa|")
    assert {"held", "enough", "filled"} <= set(desk.proposed(f"{begin}pre([|"))
    assert "in_rows" in desk.proposed(f"{begin}eff([+|")
    assert desk.proposed(f"{begin}geo([|") == ["reachable", "collision_free", "in_rows"]
    assert desk.proposed(f"{begin}body([mov(|") == []
    items = desk.editor.at_mark("completion", desk.program, "program p\nunits mm\n|")["items"]
    pick = next(one for one in items if one["label"] == "pick")
    assert pick["detail"] == "(l: location, clear: length = 50 mm)"
    assert "from above" in pick["documentation"]["value"]
