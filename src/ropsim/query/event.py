"""Outcome of a request: whether its function ran."""

from enum import Enum

from ropsim.core import frozen_dataclass


class Outcome(Enum):
    """How an answer came to be."""

    RAN = "ran"
    """The function was called and its answer differs from the one before, or there was none before."""
    SAME = "same"
    """The function was called and gave the answer that it gave before: no change goes beyond it."""
    REUSED = "reused"
    """No dependency of the function has changed: the cached answer was used."""


@frozen_dataclass
class Event:
    """One question that was answered in the present state of the inputs.

    Attributes:
        function: name of the function.
        arguments: its arguments.
        outcome: how the answer came to be.
    """

    function: str
    arguments: tuple[object, ...]
    outcome: Outcome
