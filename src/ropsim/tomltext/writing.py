"""Changing values of keys of a section, the rest of a TOML text unchanged."""

from collections.abc import Mapping

from ropsim.core import SourceText
from ropsim.tomltext.positions import Path, offsets


def with_values(source: SourceText, section: Path, values: Mapping[str, str]) -> str:
    """Return a TOML text in which keys of a section have other values; comments, order and line ends stay.

    A key that is not there comes right behind the header of the section, a section that is not there to the
    end of the text. Whether the result is valid is for the caller to see: a section may stand in one line.

    Args:
        source: a valid TOML text.
        section: its path.
        values: TOML values by key.
    """
    text = "\n".join(source.lines)
    keys, known = offsets(source)
    changes: list[tuple[int, int, str]] = []
    new: list[str] = []
    for key, value in values.items():
        place = known.get((*section, key))
        if place is None:
            new.append(f"{key} = {value}")
        else:
            changes.append((*place, value))
    if new:
        lines = "\n".join(new)
        start, end = keys.get(section, (len(text), len(text)))
        if text[start : start + 1] == "[":
            line_end = text.find("\n", end)
            after = len(text) if line_end < 0 else line_end
            changes.append((after, after, f"\n{lines}"))
        else:
            header = f"[{'.'.join(str(one) for one in section)}]"
            text = text.rstrip("\n")
            changes.append((len(text), len(text), f"\n\n{header}\n{lines}\n"))
    for start, end, value in sorted(changes, reverse=True):
        text = text[:start] + value + text[end:]
    return text.replace("\n", "\r\n") if "\r\n" in source.text else text
