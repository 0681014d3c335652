"""Findings of one kind become one finding: losses and lacks of many links and joints, by their names."""

from collections.abc import Iterable, Mapping

from ropsim.core import Diagnostic, Kind, Span, frozen_dataclass

_LONGEST = 400  # characters of a text that are processed, to show sixty of them
NAMED = 6
"""Number of entities named in a message."""
_FEW = 3  # topics of which two names are in the message, one otherwise


@frozen_dataclass
class Topic:
    """A loss or lack that many elements of a file can have.

    Attributes:
        kind: of the finding; topics of one kind become one finding.
        what: noun for it, as in a list of topics.
        words: a sentence on it, with `{}` for the names of the elements.
        hint: next action.
    """

    kind: Kind
    what: str
    words: str
    hint: str = ""


class Gathered:
    """Topics of one kind, with the names of their elements in order."""

    def __init__(self, kind: Kind, span: Span | None) -> None:
        self._kind, self._span = kind, span
        self._names: dict[Topic, dict[str, None]] = {}
        self._details: dict[Topic, str] = {}

    def add(self, topic: Topic, names: Iterable[str], detail: str) -> None:
        """Add elements to a topic; the detail of the first ones is kept."""
        self._names.setdefault(topic, {}).update(dict.fromkeys(names))
        self._details.setdefault(topic, detail)

    def finding(self) -> Diagnostic:
        """Return the finding: the sentence of the only topic, or the topics in a row with a note on each."""
        data: Mapping[str, object] = {topic.what: tuple(names) for topic, names in self._names.items()}
        sentences = [self._sentence(topic) for topic in self._names]
        hint = next((topic.hint for topic in self._names if topic.hint), "")
        if len(sentences) == 1:
            return self._kind.at(self._span, sentences[0], hint=hint, data=data)
        most = 2 if len(sentences) <= _FEW else 1
        parts = [
            f"{topic.what} ({listed(names, most)})" if names else topic.what
            for topic, names in self._names.items()
        ]
        message = f"{self._kind.summary}: {', '.join(parts)}"
        return self._kind.at(self._span, message, hint=hint, notes=tuple(sentences), data=data)

    def _sentence(self, topic: Topic) -> str:
        sentence = topic.words.replace("{}", listed(self._names[topic]), 1)
        detail = self._details[topic]
        return f"{sentence}: {detail}" if detail else sentence


def shown(text: str) -> str:
    """Return a text of the file in the form quoted in a message: on one line, and not too long."""
    line = " ".join(text[:_LONGEST].split())
    return line if len(line) <= 60 else line[:57] + "..."


def listed(names: Iterable[str], most: int = NAMED) -> str:
    """Return names in words: the first few, and how many more."""
    unique = list(dict.fromkeys(names))
    words = ", ".join(f"`{shown(name)}`" for name in unique[:most])
    return words + (f" and {len(unique) - most} more" if len(unique) > most else "")
