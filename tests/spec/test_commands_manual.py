"""The manual of the commands: it names every command and option, and its examples print what it shows."""

import argparse
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from ropsim.cli.testing import build_parser, main
from support.manual import DOCS, blocks

PAGE = DOCS / "reference" / "commands.md"
ELLIPSIS = "…"


def commands(
    parser: argparse.ArgumentParser, name: str = "ropsim"
) -> Iterator[tuple[str, argparse.ArgumentParser]]:
    """Yield every command that does something, by its full name."""
    groups = [one for one in parser._actions if isinstance(one, argparse._SubParsersAction)]  # no public way
    if not groups or name == "ropsim":
        yield name, parser
    for group in groups:
        for word, inner in group.choices.items():
            yield from commands(inner, f"{name} {word}")


def sections() -> dict[str, str]:
    """Return the text under each heading."""
    parts = re.split(r"^## (.+)$", PAGE.read_text("utf-8"), flags=re.MULTILINE)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))


def test_every_command_has_its_section_and_every_section_its_command() -> None:
    assert sorted(sections()) == sorted(name for name, _ in commands(build_parser()))


@pytest.mark.parametrize("name", sorted(sections()))
def test_a_section_names_every_option_of_its_command(name: str) -> None:
    parser = dict(commands(build_parser()))[name]
    options = {option for action in parser._actions for option in action.option_strings}
    general = {"-h", "--help", "--json"}
    assert [option for option in sorted(options - general) if f"{option}" not in sections()[name]] == []


@pytest.mark.parametrize("name", sorted(sections()))
def test_the_help_of_a_command_explains_each_of_its_arguments(name: str) -> None:
    parser = dict(commands(build_parser()))[name]
    assert parser.format_help().startswith(f"usage: {name} ")
    told = [action for action in parser._actions if not isinstance(action, argparse._SubParsersAction)]
    assert [action.dest for action in told if not action.help] == []


def test_the_examples_print_what_the_manual_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for block in blocks(PAGE, "console"):
        for example in re.split(r"^\$ ropsim ", block.text, flags=re.MULTILINE)[1:]:
            words, _, shown = example.partition("\n")
            main(shlex.split(words))
            said = capsys.readouterr()
            printed = (said.out + said.err).rstrip().splitlines()
            wanted = shown.rstrip().splitlines()
            if wanted and wanted[-1] == ELLIPSIS:
                wanted.pop()
                printed = printed[: len(wanted)]
            assert printed == wanted, f"{block}: ropsim {words}"


def test_json_documents_have_the_entries_that_the_manual_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import json

    monkeypatch.chdir(tmp_path)
    found = {"schema", "version", "counts", "diagnostics"}
    expected = {
        "new my_cell": {"ok", "path"},
        "examples": {"examples"},
        "check my_cell": {"ok", "programs"} | found,
        "run my_cell --kinematic": {"ok", "messages", "result", "summary", "written"} | found,
        "icr compile my_cell": {"ok", "icr"} | found,
        "icr verify my_cell": {"ok", "id"} | found,
        "icr run my_cell": {"ok", "instructions", "steps"} | found,
        "robot list": {"robots", "files"},
        "robot show puma560": {
            *("name", "title", "conformance", "rated_payload", "tool_motion", "joints", "following"),
            *("inverse_kinematics", "origins", "path_limits", "tip"),
        },
        "robot audit puma560": {"ok", "tip"} | found,
        "robot export scara my_arm.toml": {"ok", "path", "tip"} | found,
        "robot estimate two_link arm.stp": {"ok", "path"} | found,
        "robot import my_arm.toml --to my_arm.stp": {"ok", "path", "tip"} | found,
        "robot fk two_link 0 0": {"position", "orientation"},
        "robot ik puma560 500 100 400 180 0 30": {
            *("status", "solutions", "postures", "beyond_limits", "nearest", "free", "solver"),
        },
        "task plan my_cell 'gripper(open)'": {
            *("ok", "calls", "fewest", "looked_at", "inferences", "program", "unchecked"),
            *found,
        },
        "explain": {"codes"},
        "explain M502": {"code", "slug", "severity", "summary", "explanation"},
        "run nowhere": {"ok"} | found,
    }
    for words, entries in expected.items():
        main([*shlex.split(words), "--json"])
        document = json.loads(capsys.readouterr().out)
        assert set(document) == entries, words
        for entry in entries - found - {"ok"}:
            assert f"`{entry}`" in PAGE.read_text("utf-8"), entry
