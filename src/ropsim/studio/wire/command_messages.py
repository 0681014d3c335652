"""Messages of the server on the robot that executes typed lines: answers, and completions."""

from msgspec import Struct

from ropsim.studio.wire.content import Finding
from ropsim.studio.wire.replies import LineOutcome


class ToldLine(Struct, frozen=True):
    """An executed line with its answer.

    Attributes:
        line: as typed, several lines where it is a block.
        outcome: its outcome.
        told: lines of the answer.
        findings: about it; lines in the text `session` count lines of all commands.
        first: line of that text in which it begins.
        run: number of the run of all commands, at `/told/<run>.pack`; 0 if it is unchanged.
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
    """The dialogue so far; sent to a tab that opens the command line.

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
        line: with its answer.
        commands: how many commands the robot has carried out that were not taken back.
    """

    id: int
    line: ToldLine
    commands: int


class WordsOffered(Struct, frozen=True, tag_field="type", tag="words_offered"):
    """Completions of a line.

    Attributes:
        id: of the question.
        begun: the incomplete word at the end.
        words: by name; they begin as that does.
    """

    id: int
    begun: str
    words: tuple[str, ...]
