"""What the server says about the robot that carries out typed lines: answers, and what a line may say."""

from msgspec import Struct

from ropsim.studio.wire.content import Finding
from ropsim.studio.wire.replies import LineOutcome


class ToldLine(Struct, frozen=True):
    """A line that was told, with what was answered.

    Attributes:
        line: as it was typed, several lines where it is a block.
        outcome: what became of it.
        told: what is answered.
        findings: about it; lines in the text `session` count those of all commands.
        first: line of that text in which it begins.
        run: number of the run of all commands, at `/told/<run>.pack`; 0 where it is as before.
        since: when the motion of this command begins in that run [s].
    """

    line: str
    outcome: LineOutcome
    told: tuple[str, ...]
    findings: tuple[Finding, ...]
    first: int
    run: int
    since: float


class CommandLineState(Struct, frozen=True, tag_field="type", tag="command_line"):
    """All that was told so far; sent to a tab that opens the command line.

    Attributes:
        lines: in their order; the oldest ones may be left out.
        commands: how many commands the robot has carried out that were not taken back.
    """

    lines: tuple[ToldLine, ...]
    commands: int


class LineAnswered(Struct, frozen=True, tag_field="type", tag="line_answered"):
    """A line was carried out or refused.

    Attributes:
        id: of the line; 0 for a line of another tab.
        line: with what was answered.
        commands: how many commands the robot has carried out that were not taken back.
    """

    id: int
    line: ToldLine
    commands: int


class WordsOffered(Struct, frozen=True, tag_field="type", tag="words_offered"):
    """What can end a line.

    Attributes:
        id: of the question.
        begun: the word at the end, as far as it stands there.
        words: by name; they begin as that does.
    """

    id: int
    begun: str
    words: tuple[str, ...]
