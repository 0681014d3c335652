"""Write the instruction table of docs/reference/icr.md, between its markers, from the opcode table.

python tools/icr_table.py           write the table
python tools/icr_table.py --check   compare only; exit 1 where it differs
"""

import sys
from pathlib import Path

from ropsim.icr import OPCODES, Opcode, OperandKind, Type

PAGE = Path(__file__).parent.parent / "docs" / "reference" / "icr.md"
BEGIN = "<!-- instructions: written by tools/icr_table.py -->"
END = "<!-- end of instructions -->"

CLASSES = {
    0x00: "Control",
    0x01: "Data",
    0x02: "Arithmetic and logic",
    0x03: "Flow",
    0x04: "Geometry",
    0x05: "Modal state",
    0x06: "Motion",
    0x07: "Inputs, outputs, time",
    0x08: "Conditions and poses of the arm",
}
OPERANDS = {
    OperandKind.CONSTANT: "*type value*",
    OperandKind.COUNT: "*n*",
    OperandKind.INDEX: "*i*",
    OperandKind.NUMBER: "*n*",
}
DEPENDS = {
    "PUSH": ("", "T"),
    "LOAD": ("", "T"),
    "STORE": ("T", ""),
    "DUP": ("T", "T T"),
    "POP": ("T", ""),
    "SWAP": ("T U", "U T"),
    "CALL": ("parameters", "results"),
    "RET": ("results", ""),
    "MKJ": ("REAL … n times", "JOINTS"),
    "MKEXT": ("POSE REAL … n times", "POSE"),
    "TURNS": ("POSE INT … n times", "POSE"),
    "MOVE.SPL": ("POSE … n times", ""),
    "GUARD": ("T REAL", ""),
    "TRIG.DIST": ("T REAL", ""),
    "TRIG.TIME": ("T REAL", ""),
    "GETC": ("T", "REAL"),
    "SETC": ("T REAL", "T"),
    "IN": ("", "T"),
    "OUT": ("T", ""),
    "FMT": ("T", "STR"),
}
"""Stack effects that depend on an operand or on the stack; T and U stand for any type."""


def effect(opcode: Opcode) -> str:
    """Return what an instruction takes from the stack and leaves there, the top last.

    Raises:
        KeyError: the effect depends on something that `DEPENDS` does not tell.
    """
    if opcode.pops is None or opcode.pushes is None:
        before, after = DEPENDS[opcode.mnemonic]
    else:
        before, after = words(opcode.pops), words(opcode.pushes)
    return f"{before} → {after}".strip() if before or after else ""


def words(types: tuple[Type, ...]) -> str:
    """Return the names of types with blanks between."""
    return " ".join(one.value for one in types)


def row(opcode: Opcode) -> str:
    """Return the row of one instruction."""
    operands = " ".join(OPERANDS.get(kind, f"*{kind.value}*") for kind in opcode.operands)
    form = f"`{opcode.mnemonic}` {operands}".rstrip()
    return (
        f"| {opcode.code:04X} | {form} | {effect(opcode)} | {opcode.meaning} | {opcode.capability} |".replace(
            "  |", " |"
        )
    )


def table() -> str:
    """Return all instructions by class."""
    lines: list[str] = []
    for number, title in CLASSES.items():
        lines += [f"### {number:02X} {title}", "", "| code | instruction | stack | meaning | needs |"]
        lines += ["|---|---|---|---|---|"]
        lines += [row(opcode) for opcode in OPCODES.values() if opcode.code >> 8 == number]
        lines += [""]
    return "\n".join(lines)


def page(text: str) -> str:
    """Return the page with the table of today between its markers.

    Raises:
        ValueError: a marker is missing.
    """
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    return f"{before}{BEGIN}\n\n{table()}\n{END}{after}"


def main(arguments: list[str]) -> int:
    """Write or check the page; return the exit code."""
    text = PAGE.read_text("utf-8")
    wanted = page(text)
    if arguments == ["--check"]:
        if text != wanted:
            print(f"stale: {PAGE.name}; run python tools/icr_table.py")
        return int(text != wanted)
    PAGE.write_text(wanted, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
