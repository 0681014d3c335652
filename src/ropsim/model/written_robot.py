"""What a writer of robot files gives: the text, and what of the robot it does not hold."""

from ropsim.core import Diagnostic, frozen_dataclass


@frozen_dataclass
class WrittenRobot:
    """A robot written in a format of files.

    Attributes:
        text: of the file, in its one canonical form.
        losses: what the model holds and the format cannot say, in the order of the model.
    """

    text: str
    losses: tuple[Diagnostic, ...]
