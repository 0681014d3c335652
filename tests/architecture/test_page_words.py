"""The editor of the page tells the words of the language apart by a list of its own."""

import re
from pathlib import Path

from tools import block_words

from ropsim.language import STATEMENT_WORDS
from ropsim.language.testing import RESERVED

LIST = Path(__file__).parents[2] / "frontend" / "src" / "editor" / "task_words.ts"


def test_the_page_knows_every_word_that_cannot_be_a_name() -> None:
    known = {word for text in re.findall(r"'([^'\n]*)'", LIST.read_text("utf-8")) for word in text.split()}
    assert (RESERVED | STATEMENT_WORDS) - known - {"end"} == set()  # `end` is a word where it ends a line


def test_the_page_has_the_words_of_blocks_of_the_language() -> None:
    assert block_words.FILE.read_text("utf-8") == block_words.text()
