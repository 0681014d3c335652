"""What is being written at a place of a text that need be no TOML."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.tomltext import Path as TomlPath
from ropsim.tomltext import Unfinished, unfinished_at
from ropsim.tomltext.positions import offsets

EXAMPLES = Path(__file__).parents[3] / "examples"
SECTION = "[tools.jaws]\nmass = 1\n"


def at_mark(marked: str) -> Unfinished:
    """Return what is written at the first mark `|`."""
    before = marked.partition("|")[0].split("\n")
    return unfinished_at(marked.replace("|", "", 1).split("\n"), len(before) - 1, len(before[-1]))


@pytest.mark.parametrize(
    ("marked", "table"),
    [
        ("|", ()),
        (f"{SECTION}|", ("tools", "jaws")),
        (f"{SECTION}shapes = [\n  [1, 2],\n  [10, 20]\n]\n|", ("tools", "jaws")),
        (f"{SECTION}shapes = [\n  [10],\n  [true]\n]\n|", ("tools", "jaws")),
        (f'{SECTION}name = """\n[locations.a]\n"""\n|', ("tools", "jaws")),
        (f"{SECTION}name = '''\n[locations.a]\n'''\n|", ("tools", "jaws")),
        (f'{SECTION}name = """a\\"""\n[locations.a]\n"""\n|', ("tools", "jaws")),
        (f'{SECTION}[locations."over there"]\n|', ("locations", "over there")),
        (f"{SECTION}[locations . 'over.there']  # [no.header]\n|", ("locations", "over.there")),
        (f'{SECTION}[locations."\\u0041"]\n|', ("locations", "A")),
        (f'{SECTION}[locations."\\q"]\n|', ("tools", "jaws")),
        ("[[parts]]\n[[parts]]\n|\n[[parts]]\n", ("parts", 1)),
        ("[[parts]]\n[[parts]]\n[parts.grid]\n|", ("parts", 1, "grid")),
        (f"{SECTION}gripper = {{ |", ("tools", "jaws", "gripper")),
        (f"{SECTION}gripper = {{ a = {{ b = [1, 2], | }} }}", ("tools", "jaws", "gripper", "a")),
        (f"{SECTION}gripper = {{ a.b = {{ |", ("tools", "jaws", "gripper", "a", "b")),
        (f"{SECTION}gripper = {{ a = {{ b = [1, 2] }}, | }}", ("tools", "jaws", "gripper")),
        (f"{SECTION}shapes = [\n  {{ |", ("tools", "jaws", "shapes", 0)),
        (f"{SECTION}shapes = [\n  {{ box = [1, 2, 3] }},\n  {{ |\n]\n", ("tools", "jaws", "shapes", 1)),
        (f"{SECTION}shapes = [{{ box = [1, 2, 3] }} {{ | ]\n", ("tools", "jaws", "shapes", 1)),
        (f"{SECTION}shapes = [ # {{\n  {{ prism = {{ |", ("tools", "jaws", "shapes", 0, "prism")),
    ],
)
def test_its_table_is_the_innermost_that_is_open(marked: str, table: TomlPath) -> None:
    place = at_mark(marked)
    assert (place.table, place.key) == (table, None)


@pytest.mark.parametrize(
    "marked",
    [
        f"{SECTION}position = [1, 2\n[locations.a]\n|",
        f"{SECTION}shapes = [\n  {{ box = [1, 2, 3],\n[locations.a]\n|",
        f"{SECTION}gripper = {{ open_time = \n[locations.a]\n|",
        f"{SECTION}name = \"open\n[locations.a]\n|",
        f"{SECTION}[too\n[locations.a]\n|",
        f"{SECTION}shapes = [ ]]}}\n[locations.a]\n|",
        f"{SECTION}shapes = [{{ a = 1 ]\n[locations.a]\n|",
    ],
)  # fmt: skip
def test_what_is_left_open_above_swallows_nothing(marked: str) -> None:
    assert at_mark(marked).table == ("locations", "a")


def test_a_key_below_ends_a_list_that_is_left_open() -> None:
    place = at_mark(f"{SECTION}position = [1, 2\nrpy = [0, 0, 0]\n|")
    assert place.table == ("tools", "jaws")
    assert place.others == {"mass", "position", "rpy"}


@pytest.mark.parametrize(
    ("marked", "key", "typed"),
    [
        (f'{SECTION}material = "wo|od"', ("tools", "jaws", "material"), ' "wo'),
        (f"{SECTION}gripper = {{ capture = 5| }}", ("tools", "jaws", "gripper", "capture"), " 5"),
        (f'{SECTION}names = ["a", "b|"]', ("tools", "jaws", "names"), ' "b'),
        (f"{SECTION}rows = [[1, |]]", None, " "),
    ],
)
def test_behind_an_equals_sign_a_value_is_written(marked: str, key: TomlPath | None, typed: str) -> None:
    place = at_mark(marked)
    assert (place.key, place.typed) == (key, typed)


@pytest.mark.parametrize("marked", ["a = 1 # b|", 'a = """\nb|\n"""', "a = '''b|", "a = [\n  |\n]"])
def test_nothing_is_written_in_remarks_long_texts_and_between_the_items_of_a_list(marked: str) -> None:
    assert at_mark(marked).table is None


def test_others_are_all_keys_of_the_table_but_the_one_that_is_written() -> None:
    assert at_mark("a = 1\nb|\nc.d = 2\n[e]\nf = 1\n[g]\n").others == {"a", "c", "e", "g"}
    assert at_mark("a = { b = 1, c = { d = 1 }, |e = 2, f = 3 }").others == {"b", "c", "f"}
    assert at_mark("[a]\nb = 1\n[a.c]\nd = 1\n[a]\n|").others == {"b", "c"}


def test_the_rest_is_the_text_without_what_is_written() -> None:
    assert at_mark("a = 1\nb|\nc = 2").rest == "a = 1\n\nc = 2"
    assert at_mark("a = { b = 1, c|, d = 2 }\ne = 1").rest == "a = { b = 1}\ne = 1"
    assert at_mark("a = [\n  { b = 1 },\n  { c = |\n  },\n]\n[d]").rest == "a = [\n  { b = 1 },\n  {}]\n[d]"
    assert at_mark("a = [\n  { b = 1 },\n  { c = |\n\n[d]").rest == "a = [\n  { b = 1 },\n  {}]\n[d]"


def test_a_place_behind_the_text_is_in_its_last_section() -> None:
    assert unfinished_at(["[a]"], 10**9, 10**9).table == ("a",)
    assert unfinished_at(["[a]", "b"], 1, 10**9).typed == "b"


@pytest.mark.slow
def test_a_place_is_where_the_finished_text_has_it() -> None:
    """The places of finished texts are found by another pass, which needs the whole text to be right."""
    looked_at = 0
    for file in EXAMPLES.glob("*/cell.toml"):
        text = file.read_text("utf-8")
        keys, _ = offsets(SourceText("cell.toml", text))
        for path, (start, end) in keys.items():
            before = text[:end].split("\n")
            if text[start] == "[" or "[" in before[-1].split("{")[0].split("=")[0]:
                continue  # a header
            place = unfinished_at(text.split("\n"), len(before) - 1, len(before[-1]))
            assert place.table == path[:-1], path
            assert place.typed.strip() == path[-1], path
            looked_at += 1
    assert looked_at > 100


class Lines(list[str]):
    """Lines that count how often one of them is looked at."""

    looked_at = 0

    def __iter__(self) -> Iterator[str]:
        for line in super().__iter__():
            self.looked_at += 1
            yield line


def test_each_line_is_looked_at_once() -> None:
    lines = Lines(f"[locations.p{n}]" if n % 2 else "position = [1, 2, 3]" for n in range(1000))
    place = unfinished_at(lines, 999, 0)
    assert place.table is not None
    assert lines.looked_at == len(lines)


@pytest.mark.slow
@pytest.mark.parametrize(
    "sign", ["[", "{", "a={", "a=[", "a=[{", '"', "'", '"""', "a.", "[a.", "]", ",", "\\", "a=[\n"]
)
def test_hostile_texts_end_in_an_answer(sign: str) -> None:
    text = "a = " + sign * 20_000
    lines = text.split("\n")
    assert isinstance(unfinished_at(lines, len(lines) - 1, len(lines[-1])), Unfinished)
    assert isinstance(unfinished_at([sign * 20_000], 0, 7), Unfinished)
