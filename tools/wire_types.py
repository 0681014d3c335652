"""Write the types of the studio's wire for the pages, in `frontend/src/wire`, from the records of the server.

python tools/wire_types.py           write the files
python tools/wire_types.py --check   compare only; exit 1 and name the files that differ

A record becomes an interface, its docstring a comment, what is under `Attributes:` comments of its fields.
"""

import inspect
import re
import sys
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Literal, Union, get_args, get_origin, get_type_hints

from msgspec import Meta, Struct

from ropsim.studio import Command, Message

FOLDER = Path(__file__).parent.parent / "frontend" / "src" / "wire"
UNIONS = {"commands.ts": ("Command", Command), "messages.ts": ("Message", Message)}
"""Name of the union in each file, and the union."""

HOMES = {"Finding": "../run/run", "Pose": "../scene/description", "SceneDescription": "../scene/description"}
"""Types that the pages define themselves, and where."""

POSE = tuple[float, float, float, float, float, float, float]
SIMPLE = {str: "string", int: "number", float: "number", bool: "boolean", NoneType: "null", object: "unknown"}
WIDTH = 110


def typescript(hint: object) -> str:
    """Return a type of a field as TypeScript.

    Raises:
        TypeError: no rule says what it is there.
    """
    origin, arguments = get_origin(hint), get_args(hint)
    if hint == POSE:
        return "Pose"
    if isinstance(hint, type) and issubclass(hint, Struct):
        return hint.__name__
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


def told(kind: type[Struct]) -> tuple[str, dict[str, str]]:
    """Return what the docstring of a record says of it and of its fields."""
    text, _, attributes = (inspect.getdoc(kind) or "").partition("\n\nAttributes:\n")
    entries = re.findall(r"^    (\w+): (.*(?:\n        .*)*)", attributes, re.MULTILINE)
    fields = {name: re.sub(r"\s+", " ", words).replace("None", "null") for name, words in entries}
    return text, {name: words[0].upper() + words[1:] for name, words in fields.items()}


def interface(kind: type[Struct]) -> str:
    """Return a record as an interface."""
    text, fields = told(kind)
    hints = get_type_hints(kind, include_extras=True)
    lines = [*comment(text), f"export interface {kind.__name__} {{"]
    if kind.__struct_config__.tag:
        lines.append(f"  readonly type: '{kind.__struct_config__.tag}'")
    for name in kind.__struct_fields__:
        lines += [*comment(fields.get(name, ""), "  "), f"  readonly {name}: {typescript(hints[name])}"]
    return "\n".join([*lines, "}"])


def parts(hint: object) -> Iterator[type[Struct]]:
    """Yield the records in a type, each after those that its fields hold."""
    if isinstance(hint, type) and issubclass(hint, Struct):
        for field in get_type_hints(hint, include_extras=True).values():
            yield from parts(field)
        yield hint
    else:
        for argument in get_args(hint):
            yield from parts(argument)


def file(name: str, union: object) -> str:
    """Return the text of the file of one direction.

    Args:
        name: of the union in the file.
        union: of records with tags, and of what is left out: mappings of messages that are put together.
    """
    members = [one for one in get_args(union) if isinstance(one, type) and issubclass(one, Struct)]
    home = sys.modules[members[0].__module__]
    body = "\n\n".join(interface(kind) for kind in dict.fromkeys(parts(union)))
    about = f"Written by `tools/wire_types.py` from `{home.__name__}`: change the records there."
    needed: dict[str, list[str]] = {}
    for one, place in HOMES.items():
        if re.search(rf"\b{one}\b", re.sub(r"/\*\*.*?\*/", "", body, flags=re.DOTALL)):
            needed.setdefault(place, []).append(one)
    lines = comment(f"{(inspect.getdoc(home) or '').partition(chr(10))[0]}\n\n{about}")
    lines += [f"import type {{ {', '.join(names)} }} from '{place}'" for place, names in needed.items()]
    choice = "\n".join(f"  | {one.__name__}" for one in members)
    return "\n".join(lines) + f"\n\n{body}\n\nexport type {name} =\n{choice}\n"


def main(arguments: list[str]) -> int:
    """Write or check the files; return the exit code."""
    if not FOLDER.is_dir():
        print("no sources of pages here: an sdist carries them built")
        return 0
    wanted = {FOLDER / place: file(*union) for place, union in UNIONS.items()}
    if arguments == ["--check"]:
        stale = [path.name for path, text in wanted.items() if path.read_text("utf-8") != text]
        if stale:
            print(f"stale: {', '.join(stale)}; run python tools/wire_types.py")
        return int(bool(stale))
    for path, text in wanted.items():
        path.write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
