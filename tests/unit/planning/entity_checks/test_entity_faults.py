"""Faults of entities: those of a user's code are findings, those of our own are raised."""

import pytest

from ropsim.planning import Refusal, StandardInterpolator, guarded, refused
from support.motion import LINE, ptp

MOVE = ptp(None)


class Theirs:
    """An entity of a user."""


def fails() -> int:
    raise ZeroDivisionError("by nothing")


def test_what_an_entity_answers_is_handed_on() -> None:
    assert guarded(Theirs(), lambda: 3, (int,), MOVE) == 3
    refusal = refused(Theirs(), "cannot", MOVE)
    assert guarded(Theirs(), lambda: refusal, (Refusal,), MOVE) is refusal


def test_an_exception_of_a_users_entity_is_a_finding_at_the_line_with_its_place() -> None:
    refusal = guarded(Theirs(), fails, (int,), MOVE)
    assert isinstance(refusal, Refusal)
    found = refusal.diagnostics[0]
    assert (found.code, found.span) == ("C603", LINE)
    assert "`Theirs` raised ZeroDivisionError: by nothing (test_entity_faults.py, line 16)" in found.message


def test_a_function_of_a_user_is_called_by_its_name() -> None:
    refusal = guarded(fails, fails, (int,), MOVE)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].message.startswith("`fails` raised")


def test_an_answer_of_another_kind_is_a_finding() -> None:
    refusal = guarded(Theirs(), lambda: "three", (int, float), MOVE)
    assert isinstance(refusal, Refusal)
    assert refusal.diagnostics[0].message == "`Theirs` returned a `str` instead of a int or float"


def test_a_fault_of_our_own_is_not_blamed_on_the_program() -> None:
    with pytest.raises(ZeroDivisionError):
        guarded(StandardInterpolator(), fails, (int,), MOVE)
