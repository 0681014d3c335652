"""The cell file in an editor: what keys mean, what can be written where, its things, their names changed."""

from pathlib import Path
from typing import Any

import pytest

from ropsim.lsp.testing import Document
from ropsim.workbench import new_project
from support.editors import Editor, applied, place, uri_of

DEVICE = """
[signals.go]
output = 1

[signals.there]
input = 1

[devices.table]
|
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell", "first_cell")


def text_of(folder: Path) -> str:
    return (folder / "cell.toml").read_text("utf-8")


def hover(folder: Path, old: str, marked: str) -> str:
    text = text_of(folder)
    assert old in text
    answer = Editor().at_mark("hover", uri_of(folder / "cell.toml"), text.replace(old, marked, 1))
    return answer["contents"]["value"] if answer else ""


def labels(folder: Path, marked: str) -> list[str]:
    answer = Editor().at_mark("completion", uri_of(folder / "cell.toml"), marked)
    return [one["label"] for one in sorted(answer["items"], key=lambda one: one["sortText"])]


def test_a_key_tells_what_it_means_its_form_and_its_default(folder: Path) -> None:
    told = hover(folder, "close_time", "clo|se_time")
    assert told.split("\n\n")[:3] == [
        "**tools.jaws.gripper.close_time**",
        "How long closing takes.",
        "number, 0 to 60 s; without it 0.2 s",
    ]
    assert "3 numbers, 0.001 to 100000 mm; needed" in hover(folder, "size = [60", "si|ze = [60")


def test_units_of_the_file_are_those_of_the_form(folder: Path) -> None:
    text = (
        text_of(folder)
        .replace("capture = 5", "cap|ture = 0.5")
        .replace("[cell]", '[units]\nlength = "cm"\n\n[cell]')
    )
    answer = Editor().at_mark("hover", uri_of(folder / "cell.toml"), text)
    assert "number, 0.0001 to 10000 cm; without it 1 cm" in answer["contents"]["value"]


def test_a_thing_tells_where_it_is(folder: Path) -> None:
    assert "(500, 300, 560) mm, roll pitch yaw (-180, 0, 0)° in the world frame" in hover(
        folder, "locations.pick_up", "locations.pi|ck_up"
    ).replace("(180,", "(-180,")
    assert "(500, 300, 560) mm" in hover(folder, '"box"', '"b|ox"')
    assert "in the mechanical interface" in hover(folder, 'tool = "jaws"', 'tool = "ja|ws"')


def test_a_location_tells_its_pose_in_its_own_frame_too(folder: Path) -> None:
    cell = folder / "cell.toml"
    frame = "\n[frames.bench]\nposition = [500, 300, 0]\n"
    near = '\n[locations.near]\nframe = "bench"\nposition = [1, 2, 3]\n'
    cell.write_text(text_of(folder) + frame + near, "utf-8")
    told = hover(folder, "locations.near", "locations.ne|ar")
    assert "(501, 302, 3) mm" in told
    assert "(1, 2, 3) mm" in told
    assert "in the frame bench" in told


def test_a_location_tells_that_its_orientation_is_free(folder: Path) -> None:
    cell = folder / "cell.toml"
    cell.write_text(
        text_of(folder) + '\n[locations.near]\nposition = [1, 2, 3]\norientation = "free"\n', "utf-8"
    )
    assert "its orientation is free" in hover(folder, "locations.near", "locations.ne|ar")
    assert "orientation is free" not in hover(folder, "locations.pick_up", "locations.pi|ck_up")
    assert "Whether the orientation of the tool counts" in hover(folder, "orientation =", "orien|tation =")


def test_keys_of_a_section_that_are_not_there_yet_are_offered_needed_ones_first(folder: Path) -> None:
    text = text_of(folder).replace("mass = 0.5\n", "|\n")
    found = labels(folder, text)
    assert found[0] == "mass"
    assert {"colour", "destination", "grid", "rpy"} <= set(found)
    assert not {"name", "size", "position", "start"} & set(found)


def test_keys_of_an_inline_table_are_offered_in_it(folder: Path) -> None:
    text = text_of(folder).replace("capture = 5 }", "|}")
    found = labels(folder, text)
    assert {"capture", "fingers"} <= set(found)
    assert "com" not in found


def test_keys_are_offered_behind_lists_over_several_lines_and_texts_with_brackets(folder: Path) -> None:
    text = text_of(folder)
    for behind in (
        "shapes = [{ prism = { outline = [\n  [0, 0], [10, 0],\n  [10, 20]\n], length = 5 } }]\n|\n",
        'name = """\n[locations.a]\n"""\n|\n',
    ):
        found = labels(folder, f"{text}\n[[objects]]\n{behind}")
        assert {"colour", "parent", "size"} <= set(found), behind


def test_keys_of_a_location_with_a_name_in_quotes_are_those_of_a_location(folder: Path) -> None:
    found = labels(folder, f'{text_of(folder)}\n[locations."over there"]\nposition = [1, 2, 3]\n|')
    assert {"down", "frame", "rpy"} <= set(found)
    assert "colour" not in found


def test_kinds_models_and_parameters_of_a_library_part_are_offered(folder: Path) -> None:
    text = text_of(folder)
    kinds = labels(folder, text.replace("[tools.jaws]\n", '[tools.jaws]\npart = { kind = "|" }\n'))
    assert {"two_finger_gripper", "vacuum_gripper", "flange"} == set(kinds)
    begun = '[tools.jaws]\npart = { kind = "two_finger_gripper", model = "|" }\n'
    assert "franka_hand" in labels(folder, text.replace("[tools.jaws]\n", begun))
    begun = '[tools.jaws]\npart = { kind = "two_finger_gripper", | }\n'
    assert {"model", "stroke", "finger_length"} <= set(labels(folder, text.replace("[tools.jaws]\n", begun)))


def test_a_parameter_of_a_library_part_tells_its_meaning_and_range(folder: Path) -> None:
    begun = '[tools.jaws]\npart = { kind = "two_finger_gripper", model = "franka_hand", stro|ke = 50 }\n'
    told = hover(folder, "[tools.jaws]\n", begun)
    assert "Distance between the open fingers; closed they touch." in told
    assert "number, 2 to 400 mm; without it 80 mm" in told


@pytest.mark.parametrize("begun", ["shapes = [\n  { |", "shapes = [{ |", "shapes = [\n  { |\n]\n"])
def test_keys_of_a_form_are_offered_in_a_list_of_forms(folder: Path, begun: str) -> None:
    text = text_of(folder).replace("[tools.jaws]\n", f"[tools.jaws]\n{begun}\n")
    assert {"box", "cylinder", "position", "colour"} <= set(labels(folder, text))


def test_keys_that_an_inline_table_has_are_not_offered_in_it_again(folder: Path) -> None:
    text = text_of(folder).replace("close_time = 0.2, capture = 5 }", "|, capture = 5 }")
    found = labels(folder, text)
    assert "close_time" in found
    assert not {"open_time", "capture"} & set(found)


def test_completion_looks_at_each_line_of_a_long_file_a_few_times(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    more = "".join(f"\n[locations.p{n}]\nposition = [400, {n % 9}, 600]\n" for n in range(200))
    editor, uri, text = Editor(), uri_of(folder / "cell.toml"), text_of(folder) + more
    editor.open(uri, text)
    count, looked_at = text.count("\n"), 0
    line = Document.line

    def counted(document: Document, number: int) -> str:
        nonlocal looked_at
        looked_at += 1
        return line(document, number)

    monkeypatch.setattr(Document, "line", counted)
    answer = editor.ask("textDocument/completion", textDocument={"uri": uri}, position=place(count, 0))
    assert "rpy" in {one["label"] for one in answer["items"]}
    assert looked_at < 3 * count


def test_sections_are_offered_by_their_brackets(folder: Path) -> None:
    assert {"signals.", "controller", "units"} <= set(labels(folder, text_of(folder) + "\n\n[|"))
    assert set(labels(folder, text_of(folder) + "\n\n[[|")) == {"objects", "parts", "sinks", "supplies"}


def test_words_and_names_are_offered_as_values(folder: Path) -> None:
    base = text_of(folder)
    assert labels(folder, base + DEVICE.replace("|", "kind = |")) == ['"conveyor"', '"slide"', '"turntable"']
    assert labels(folder, base + DEVICE.replace("|", 'kind = "|')) == ["conveyor", "slide", "turntable"]
    assert labels(folder, base + DEVICE.replace("|", 'kind = "slide"\nsignal = |')) == ['"go"', '"there"']
    assert labels(folder, base.replace('tool = "jaws"', "tool = |")) == ['"jaws"']
    assert labels(folder, base + "\n[signals.a]\nanalog = |") == ["false", "true"]
    assert '"puma560"' in labels(folder, base.replace('model = "puma560"', "model = |"))


def test_a_blank_and_a_remark_offer_nothing(folder: Path) -> None:
    base = text_of(folder)
    assert labels(folder, base + "\n[signals.a]\n# anal|") == []
    assert labels(folder, base.replace('model = "puma560"', 'model = "puma560" # |')) == []
    asked = {"context": {"triggerCharacter": " "}}
    uri, text = uri_of(folder / "cell.toml"), base + "\n[signals.a]\n |"
    assert Editor().at_mark("completion", uri, text, **asked)["items"] == []
    given = Editor().at_mark("completion", uri, text.replace(" |", "analog = |"), **asked)["items"]
    assert [one["label"] for one in given] == ["true", "false"]


def test_its_sections_are_listed_and_folded(folder: Path) -> None:
    editor, uri = Editor(), uri_of(folder / "cell.toml")
    editor.open(uri, text_of(folder))
    listed = editor.ask("textDocument/documentSymbol", textDocument={"uri": uri})
    assert [one["name"] for one in listed] == [
        "cell", "robot", "jaws", "pick_up", "set_down", "box", "stand_left", "stand_right"
    ]  # fmt: skip
    folds = editor.ask("textDocument/foldingRange", textDocument={"uri": uri})
    lines = text_of(folder).split("\n")
    assert len(folds) == len(listed)
    assert all(lines[one["startLine"]].startswith("[") and lines[one["endLine"]].strip() for one in folds)


def test_uses_of_a_name_in_the_cell_file_are_marked_and_found(folder: Path) -> None:
    uri, text = uri_of(folder / "cell.toml"), text_of(folder)
    marks = Editor().at_mark("documentHighlight", uri, text.replace("[tools.jaws]", "[tools.ja|ws]"))
    lines = text.split("\n")
    words = [
        lines[one["range"]["start"]["line"]][
            one["range"]["start"]["character"] : one["range"]["end"]["character"]
        ]
        for one in marks
    ]
    assert words == ["jaws", "jaws"]
    assert sorted(one["kind"] for one in marks) == [2, 3]


def renamed(folder: Path, name: str, marked: str, new: str) -> Any:
    return Editor().at_mark("rename", uri_of(folder / name), marked, newName=new)


def test_a_name_is_changed_in_the_cell_file_and_in_all_programs(folder: Path) -> None:
    program = folder / "programs" / "main.task"
    text, code = text_of(folder), program.read_text("utf-8")
    for name, marked in (
        ("cell.toml", text.replace("locations.pick_up", "locations.pick|_up")),
        ("programs/main.task", code.replace("Carry pick_up", "Carry pick|_up")),
    ):
        changes = renamed(folder, name, marked, "infeed")["changes"]
        assert applied(text, changes[uri_of(folder / "cell.toml")]) == text.replace("pick_up", "infeed")
        assert applied(code, changes[uri_of(program)]) == code.replace("pick_up", "infeed")


def test_a_tool_is_changed_where_stations_name_it(folder: Path) -> None:
    text = text_of(folder)
    changes = renamed(folder, "cell.toml", text.replace("[tools.jaws]", "[tools.ja|ws]"), "hand")["changes"]
    (edits,) = changes.values()
    assert applied(text, edits) == text.replace("jaws", "hand")


def test_names_that_would_change_the_meaning_are_refused(folder: Path) -> None:
    marked = text_of(folder).replace("locations.pick_up", "locations.pick|_up")
    assert renamed(folder, "cell.toml", marked, "set_down")["message"] == 'the cell has the name "set_down"'
    assert "word of the language" in renamed(folder, "cell.toml", marked, "mov")["message"]
    assert '"a" is a parameter' in renamed(folder, "cell.toml", marked, "a")["message"]
    (folder / "programs" / "other.task").write_text("lin pick_up above\n", "utf-8")
    assert "has an error" in renamed(folder, "cell.toml", marked, "infeed")["message"]


def test_a_text_that_is_no_toml_ends_in_no_answer(folder: Path) -> None:
    editor, uri = Editor(), uri_of(folder / "cell.toml")
    editor.open(uri, "[robot\nmodel = ")
    about = {"textDocument": {"uri": uri}, "position": place(0, 3)}
    assert editor.ask("textDocument/documentHighlight", **about) == []
    assert editor.ask("textDocument/documentSymbol", textDocument={"uri": uri}) == []
    assert editor.ask("textDocument/foldingRange", textDocument={"uri": uri}) == []


def test_a_value_or_section_written_in_full_is_no_list(folder: Path) -> None:
    for written in ('x = "a"\n[cell]\nname = 1|', "[cell|", "[tools.jaws.gripper]\nclose_time|"):
        assert labels(folder, written) == [], written
    assert "close_time" in labels(folder, "[tools.jaws.gripper]\nclose_tim|")
