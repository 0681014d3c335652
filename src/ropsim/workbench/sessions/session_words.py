"""Words to a session of commands: their meanings, near names, and completions."""

from dataclasses import replace

from ropsim.core import Diagnostic, near
from ropsim.language import STATEMENT_WORDS, UNKNOWN_TASK

SESSION_WORDS = ("undo", "restart", "list", "save", "help", "quit", "exit")


def words_for(line: str) -> tuple[str, ...]:
    """Return the commands to the session that complete an empty or incomplete line."""
    begun = line.strip().lower()
    return tuple(word for word in SESSION_WORDS if word.startswith(begun))


def with_hints(found: tuple[Diagnostic, ...], command: str) -> tuple[Diagnostic, ...]:
    """Return the findings of a command; where it begins like a misspelt word to the session, one says so."""
    head = command.split(maxsplit=1)[0] if command.strip() else ""
    meant = near(head, (*SESSION_WORDS, *STATEMENT_WORDS), limit=1)
    if not head.isalpha() or not meant or meant[0] not in SESSION_WORDS:
        return found
    hint = f"did you mean `{meant[0]}`?"
    return tuple(
        replace(one, hint=hint) if one.code == UNKNOWN_TASK.code and f"`{head}`" in one.message else one
        for one in found
    )
