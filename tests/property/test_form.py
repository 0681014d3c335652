"""The form of a text means the same, is its own form, and does not depend on how the text was written."""

import re
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import icr
from ropsim.core import SourceText
from ropsim.language import formatted
from ropsim.language.testing import RESERVED, logical_lines, tokens
from support.characters import ANY
from support.examples import examples
from support.manual import DOCS, blocks
from support.programs.making import program
from support.programs.text import written
from support.tasks import compiled

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("examples/*/programs/*.task"), *ROOT.glob("tests/golden/*/*.task")])
TEXTS = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in FILES}
TEXTS |= {str(block): block.text for block in blocks(DOCS / "reference" / "language.md", "task")}
SIGNS = [
    "(",
    ")",
    "[",
    ",",
    ";",
    ".",
    '"',
    "\\",
    "\\  ",
    "-",
    "#",
    "//",
    "\t",
    "\r",
    "\ufeff",
    "é",
    "\n",
    " ",
]
WORDS = sorted({*" ".join(TEXTS.values()).split(), *SIGNS})
COMMENT = re.compile(r'"(?:[^"\\\n]|\\.)*"|(#.*|//.*)')


def comments(text: str) -> list[str]:
    return [match[1].rstrip(" \t\r") for match in COMMENT.finditer(text) if match[1]]


def assert_means_the_same(text: str) -> str:
    """Return the form of a text, which means the same."""
    form = formatted(text)
    assert formatted(form) == form
    assert comments(form.replace("\r", "\n")) == comments(text.replace("\r", "\n"))
    before, after = compiled(text), compiled(form)
    assert [(d.code, d.message) for d in after.diagnostics] == [
        (d.code, d.message) for d in before.diagnostics
    ]
    assert (after.icr is None) == (before.icr is None)
    if before.icr is not None and after.icr is not None:
        assert icr.program_id(after.icr) == icr.program_id(before.icr)
    return form


@pytest.mark.parametrize("name", sorted(TEXTS))
def test_programs_of_examples_and_manuals_mean_the_same_in_their_form(name: str) -> None:
    assert_means_the_same(TEXTS[name])


@pytest.mark.parametrize("name", [one for one in sorted(TEXTS) if one.startswith("examples/")])
def test_the_examples_have_their_form(name: str) -> None:
    is_as_printed = "fig5" in name  # exactly as in the paper
    assert (formatted(TEXTS[name]) == TEXTS[name]) != is_as_printed


def rewritten(text: str, random: Random) -> str:
    """Return a program with other blanks, cases of its words and empty lines, and some comments."""
    result = []
    for number, line in enumerate(text.splitlines()):
        parts = [" " * random.randrange(9)]
        end = 0
        for token in tokens(line):
            gap = line[end : token.start]
            parts.append(" " * random.randint(1, 3) if gap else "")
            is_word = token.word in RESERVED
            parts.append(token.text.upper() if is_word and random.random() < 0.3 else token.text)
            end = token.end
        comment = random.choice(["", "", "  ", f" # note {number}", f"// {number}", " ."])
        result += ["".join(parts) + comment, *[" " * random.randrange(3)] * random.choice((0, 0, 0, 1, 3))]
    return "\n".join(result)


def bare(text: str) -> list[str]:
    """Return the lines with something on them, without comments and final full stops."""
    lines = (COMMENT.sub(lambda match: "" if match[1] else match[0], line) for line in text.splitlines())
    return [line.rstrip(" .") for line in lines if line.strip()]


@pytest.mark.parametrize("first", range(0, examples(100), 20))
def test_the_form_does_not_tell_how_a_program_was_written(first: int) -> None:
    for seed in range(first, first + 20):
        text = written(program(seed))
        other = rewritten(text, Random(seed))
        assert bare(assert_means_the_same(other)) == bare(assert_means_the_same(text))


@settings(max_examples=examples(150), derandomize=True, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=60), st.randoms(use_true_random=False))
def test_any_words_mean_the_same_in_their_form(words: list[str], random: Random) -> None:
    assert_means_the_same("".join(word + random.choice((" ", "", "\n", "  ")) for word in words))


@settings(max_examples=examples(150), derandomize=True, deadline=None)
@given(st.text(ANY, max_size=300))
def test_any_text_has_a_form(text: str) -> None:
    form = formatted(text)
    assert formatted(form) == form
    assert (
        len(list(logical_lines(SourceText("", form)))) <= len(list(logical_lines(SourceText("", text)))) + 1
    )


@settings(max_examples=examples(150), derandomize=True, deadline=None)
@given(st.sampled_from(sorted(TEXTS)), st.data())
def test_a_damaged_program_means_the_same_in_its_form(name: str, data: st.DataObject) -> None:
    text = TEXTS[name]
    at = data.draw(st.integers(0, len(text)))
    damage = data.draw(st.sampled_from(SIGNS))
    assert_means_the_same(text[:at] + damage + text[at + data.draw(st.integers(0, 3)) :])
