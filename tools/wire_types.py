"""Write the types of what pages and server say to each other, in `frontend/src/wire`, from its records.

python tools/wire_types.py           write the files
python tools/wire_types.py --check   compare only; exit 1 and name the files that differ

A record becomes an interface, its docstring a comment, what is under `Attributes:` comments of its fields, an
enum its words. A number that is not finite travels as null: a field with such a default may be null.
"""

import inspect
import math
import re
import sys
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Literal, TypeGuard, Union, get_args, get_origin, get_type_hints

from msgspec import Meta, Struct

from ropsim.flow import RunFacts
from ropsim.studio import Command, Message
from ropsim.views import ResultFigures

FOLDER = Path(__file__).parent.parent / "frontend" / "src" / "wire"
UNIONS = {"commands.ts": ("Command", Command), "messages.ts": ("Message", Message)}
"""Name of the union in each file, and the union."""

RECORDS = {"facts.ts": RunFacts, "result.ts": ResultFigures}
"""The record in each file of what a pack carries; the files have those that it holds, too."""

HOMES = {
    "Destinations": "./facts",
    "Finding": "../run/run",
    "Pose": "../scene/description",
    "ResultFigures": "./result",
    "RunEvent": "../run/run",
    "SceneDescription": "../scene/description",
    "WayFacts": "./facts",
}
"""Types that the pages define themselves, or that several files need, and where."""

POSE = tuple[float, float, float, float, float, float, float]
SIMPLE = {str: "string", int: "number", float: "number", bool: "boolean", NoneType: "null", object: "unknown"}
WIDTH = 110


def is_record(hint: object) -> TypeGuard[type]:
    """Tell whether a type is one of records."""
    return isinstance(hint, type) and (issubclass(hint, Struct) or is_dataclass(hint))


def typescript(hint: object) -> str:
    """Return a type of a field as TypeScript.

    Raises:
        TypeError: no rule says what it is there.
    """
    origin, arguments = get_origin(hint), get_args(hint)
    if hint == POSE:
        return "Pose"
    if is_record(hint):
        return hint.__name__
    if isinstance(hint, type) and issubclass(hint, Enum):
        return " | ".join(f"'{one.value}'" for one in hint)
    if isinstance(hint, type) and hint in SIMPLE:
        return SIMPLE[hint]
    if origin is Annotated:
        titles = [one.title for one in arguments[1:] if isinstance(one, Meta) and one.title]
        return titles[0] if titles else typescript(arguments[0])
    if origin is Literal:
        return " | ".join(f"'{one}'" for one in arguments)
    if origin in (Union, UnionType):
        return " | ".join(typescript(one) for one in arguments)
    if origin is tuple and arguments[1:] == (...,):
        element = typescript(arguments[0])
        return f"readonly ({element})[]" if " " in element else f"readonly {element}[]"
    if origin is tuple:
        return f"readonly [{', '.join(typescript(one) for one in arguments)}]"
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return f"Readonly<Record<{typescript(arguments[0])}, {typescript(arguments[1])}>>"
    raise TypeError(f"no TypeScript for {hint!r}")


def comment(text: str, indent: str = "") -> list[str]:
    """Return a text as a comment, in one line where it fits."""
    if not text:
        return []
    lines = [
        line for part in text.split("\n\n") for line in (*textwrap.wrap(part, WIDTH - len(indent) - 3), "")
    ][:-1]
    if len(lines) == 1 and len(indent) + len(lines[0]) + 7 <= WIDTH:
        return [f"{indent}/** {lines[0]} */"]
    return [f"{indent}/**", *(f"{indent} * {line}".rstrip() for line in lines), f"{indent} */"]


def told(kind: type) -> tuple[str, dict[str, str]]:
    """Return what the docstring of a record says of it and of its fields."""
    text, _, attributes = (inspect.getdoc(kind) or "").partition("\n\nAttributes:\n")
    entries = re.findall(r"^    (\w+): (.*(?:\n        .*)*)", attributes, re.MULTILINE)
    said = {name: re.sub(r"\s+", " ", words) for name, words in entries}
    said = {name: re.sub(r"\bNone\b|\bNaN\b|-?\binf\b", "null", words) for name, words in said.items()}
    return text, {name: words[0].upper() + words[1:] for name, words in said.items()}


def members(kind: type) -> dict[str, object]:
    """Return the types of the fields of a record as they travel."""
    known = fields(kind) if is_dataclass(kind) else ()
    endless = {one.name for one in known if isinstance(one.default, float) and not math.isfinite(one.default)}
    hints = get_type_hints(kind, include_extras=True)
    return {name: hint | None if name in endless else hint for name, hint in hints.items()}


def interface(kind: type) -> str:
    """Return a record as an interface."""
    text, said = told(kind)
    lines = [*comment(text), f"export interface {kind.__name__} {{"]
    if issubclass(kind, Struct) and kind.__struct_config__.tag:
        lines.append(f"  readonly type: '{kind.__struct_config__.tag}'")
    for name, hint in members(kind).items():
        lines += [*comment(said.get(name, ""), "  "), f"  readonly {name}: {typescript(hint)}"]
    return "\n".join([*lines, "}"])


def parts(hint: object) -> Iterator[type]:
    """Yield the records in a type, each after those that its fields hold."""
    if is_record(hint):
        for field in members(hint).values():
            yield from parts(field)
        yield hint
    else:
        for argument in get_args(hint):
            yield from parts(argument)


def file(place: str, hint: object) -> str:
    """Return the text of a file with the records in a type.

    Args:
        place: name of the file.
        hint: the type: a record, or a union of records.
    """
    here = f"./{place.removesuffix('.ts')}"
    kinds = [one for one in dict.fromkeys(parts(hint)) if HOMES.get(one.__name__, here) == here]
    home = sys.modules[kinds[-1].__module__]
    body = "\n\n".join(interface(kind) for kind in kinds)
    about = f"Written by `tools/wire_types.py` from `{home.__name__}`: change the records there."
    needed: dict[str, list[str]] = {}
    for one, other in HOMES.items():
        if other != here and re.search(rf"\b{one}\b", re.sub(r"/\*\*.*?\*/", "", body, flags=re.DOTALL)):
            needed.setdefault(other, []).append(one)
    lines = comment(f"{(inspect.getdoc(home) or '').partition(chr(10))[0]}\n\n{about}")
    lines += [
        f"import type {{ {', '.join(names)} }} from '{other}'" for other, names in sorted(needed.items())
    ]
    return "\n".join(lines) + f"\n\n{body}\n"


def choice(name: str, union: object) -> str:
    """Return a union of records with tags, without the mappings in it: messages that are put together."""
    named = "\n".join(f"  | {one.__name__}" for one in get_args(union) if is_record(one))
    return f"\nexport type {name} =\n{named}\n"


def texts() -> dict[str, str]:
    """Return the text of each file by its name."""
    unions = {place: file(place, union) + choice(name, union) for place, (name, union) in UNIONS.items()}
    return unions | {place: file(place, record) for place, record in RECORDS.items()}


def main(arguments: list[str]) -> int:
    """Write or check the files; return the exit code."""
    if not FOLDER.is_dir():
        print("no sources of pages here: an sdist carries them built")
        return 0
    wanted = {FOLDER / place: text for place, text in texts().items()}
    if arguments == ["--check"]:
        stale = [
            path.name
            for path, text in wanted.items()
            if not path.is_file() or path.read_text("utf-8") != text
        ]
        if stale:
            print(f"stale: {', '.join(stale)}; run python tools/wire_types.py")
        return int(bool(stale))
    for path, text in wanted.items():
        path.write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
