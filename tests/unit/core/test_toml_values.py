import tomllib

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import MOST_KEY_PARTS, SourceText, toml_values


@pytest.mark.parametrize(
    "key",
    [
        "a" + ".b" * 100_000,
        "a" + ' . "b c"' * 100_000,
        "a" + ".'b.c'" * 100_000,
    ],
    ids=["bare", "quoted", "with dots"],
)
@pytest.mark.parametrize("form", ["{} = 1", "[{}]", "x = {{ {} = 1 }}"])
def test_a_key_of_too_many_parts_is_refused_with_its_place(key: str, form: str) -> None:
    with pytest.raises(tomllib.TOMLDecodeError, match=r"more than 64 parts \(at line 2, column \d+\)"):
        toml_values("y = 1\n" + form.format(key))


def test_the_longest_allowed_key_is_read() -> None:
    value: object = toml_values("a" + ".b" * (MOST_KEY_PARTS - 1) + " = 1")
    for _ in range(MOST_KEY_PARTS):
        assert isinstance(value, dict)
        (value,) = value.values()
    assert value == 1


def test_dots_elsewhere_are_no_parts_of_a_key() -> None:
    text = f'a = [{", ".join(["1.5"] * 5000)}]\nb = "{"x." * 5000}"\n# {"..." * 5000}\nc = "{"../" * 500}"'
    assert set(toml_values(text)) == {"a", "b", "c"}


def test_a_cell_file_with_such_a_key_has_a_finding_at_its_line() -> None:
    _, [finding] = read_cell(SourceText("cell.toml", "\na" + ".b" * 200 + " = 1\n"), "folder")
    assert finding.code == "X801"
    assert finding.span is not None
    assert finding.span.line == 2
    assert "more than 64 parts" in finding.message


@pytest.mark.parametrize(
    "text", ['a = "' + '\\"' * 200_000, "a = " + "'" * 200_001, 'a = "' + "x.y" * 100_000]
)
def test_a_text_that_is_not_closed_is_read_once(text: str) -> None:
    """Where it was tried anew from every quote, each of these took minutes."""
    with pytest.raises(tomllib.TOMLDecodeError):
        toml_values(text)
