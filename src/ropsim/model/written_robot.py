"""What a writer of robot files gives: the text, and what of the robot it could not say."""

from ropsim.core import Diagnostic, frozen_dataclass


@frozen_dataclass
class WrittenRobot:
    """A robot written as a file.

    Attributes:
        text: content of the file.
        losses: what the robot has and the format cannot hold.
    """

    text: str
    losses: tuple[Diagnostic, ...]
