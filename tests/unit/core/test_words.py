import difflib

import pytest

from ropsim.core import did_you_mean, near, plural, words
from ropsim.core.words import MANY


def test_a_misspelt_name_finds_the_right_one() -> None:
    assert did_you_mean("relase", ["grip", "release", "Palletize"]) == "did you mean `release`?"


def test_case_does_not_matter_and_the_known_spelling_is_kept() -> None:
    assert near("palletise", ["Palletize", "grip"]) == ("Palletize",)


def test_nothing_near_gives_an_empty_hint() -> None:
    assert did_you_mean("xyz", ["grip", "release"]) == ""


def test_nobody_is_asked_whether_they_mean_what_they_wrote() -> None:
    assert did_you_mean("grip", ["grip", "release"]) == ""
    assert did_you_mean("grip", ["Grip", "grip"]) == "did you mean `Grip`?"


def test_a_huge_name_is_answered_quickly() -> None:
    assert did_you_mean("a" * 1_000_000, ["release"] * 3) == ""


def test_a_word_that_begins_with_a_known_one_means_that() -> None:
    assert did_you_mean("degrees", ["deg", "deg/s", "deg/s2"]) == "did you mean `deg`?"
    assert did_you_mean("pal", ["Palletize", "grip"]) == "did you mean `Palletize`?"


def test_letters_in_another_order_are_the_same_word() -> None:
    assert did_you_mean("mvo", ["mode", "mov", "move"]) == "did you mean `mov`?"


@pytest.fixture
def compared(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """With how many names each word is compared letter by letter, as that goes on."""
    counts: list[int] = []
    matches = difflib.get_close_matches

    def counted(word: str, possibilities: list[str], n: int, cutoff: float) -> list[str]:
        counts.append(len(possibilities))
        return matches(word, possibilities, n, cutoff)

    monkeypatch.setattr(difflib, "get_close_matches", counted)
    return counts


def test_among_very_many_names_the_nearest_is_found_by_a_bounded_number_of_comparisons(
    compared: list[int],
) -> None:
    names = [f"{letter}{number}" for letter in ("gap", "slot", "way") for number in range(20_000)]
    assert did_you_mean("stakc", [*names, "stack"]) == "did you mean `stack`?"
    assert did_you_mean("kstack", [*names, "stack"]) == "did you mean `stack`?"
    assert max(compared) <= MANY


@pytest.mark.slow
def test_many_words_are_looked_for_among_the_same_names_in_time_linear_in_both(compared: list[int]) -> None:
    def comparisons(count: int) -> int:
        compared.clear()
        words._index.cache_clear()
        names = tuple(f"slot{number}" for number in range(count))
        assert all(did_you_mean(f"sloot{number}", names) for number in range(count))
        assert words._index.cache_info().misses == 1
        return sum(compared)

    assert comparisons(800) <= 2 * comparisons(400)


def test_a_noun_is_singular_for_one_alone() -> None:
    assert [plural(count, "error") for count in (0, 1, 2)] == ["0 errors", "1 error", "2 errors"]
