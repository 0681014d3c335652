"""The key `kind` of a TOML file, which determines the other keys of its table."""

from collections.abc import Sequence

from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.diagnostics import MISSING_KEY
from ropsim.tomltext.question import Question, Sort


def read_kind(table: TomlTable, known: Sequence[str]) -> str:
    """Return the kind that a table describes; empty where it is missing or unknown, which is noted.

    Nothing else in that table is to be read.
    """
    kind = table.text("kind", "")
    if kind or table.values.get("kind") == "":
        return table.choice("kind", known, "")
    table.ask("kind", Question(Sort.TEXT, choices=tuple(known)))
    if "kind" in table:
        return ""
    if table.present:
        words = ", ".join(f'`"{kind}"`' for kind in known)
        message = f"`{table.name_of('kind').rpartition('.')[0]}` needs `kind`"
        span = table.findings.places.key(table.path)
        table.findings.add(MISSING_KEY, span, message, f"add it: one of {words}")
    return ""
