from hypothesis import given
from hypothesis import strategies as st

from ropsim.studio.testing import plain_lines, restored

MIXED = "a\r\nb\nc\rd\r\n"


def test_a_text_that_did_not_change_comes_back_byte_for_byte() -> None:
    assert restored(plain_lines(MIXED), MIXED) == MIXED


def test_lines_around_a_change_keep_their_ends_and_new_ones_take_the_usual_one() -> None:
    assert restored("a\nB\nnew\nc\nd\n", MIXED) == "a\r\nB\r\nnew\r\nc\rd\r\n"


def test_a_last_line_without_end_stays_without() -> None:
    assert restored("a\nx", "a\r\nb") == "a\r\nx"
    assert restored("a\nb\n", "a\r\nb") == "a\r\nb\r\n"


def test_lines_do_not_become_one_in_a_row() -> None:
    assert restored("\n" * 6 + "aa", "a\n\n\r\r\raa") == "\n\n\n\r\r\raa"


def test_half_a_character_becomes_a_question_mark() -> None:
    assert plain_lines("x\ud800y") == "x?y"


TEXTS = st.lists(st.sampled_from(["a", "b", "", "\n", "\r\n", "\r"]), max_size=12).map("".join)


@given(TEXTS, TEXTS)
def test_pages_see_the_same_text_again_whatever_the_file_was(text: str, former: str) -> None:
    new = plain_lines(text)
    assert plain_lines(restored(new, former)) == new


@given(TEXTS)
def test_saving_without_a_change_never_changes_a_byte(former: str) -> None:
    assert restored(plain_lines(former), former) == former
