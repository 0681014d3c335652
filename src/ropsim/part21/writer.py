"""Write an exchange file of ISO 10303-21 in its canonical form."""

from math import isfinite

from ropsim.part21.exchange_file import ExchangeFile, Instance, Record
from ropsim.part21.numbering import canonical
from ropsim.part21.strings import encoded
from ropsim.part21.values import Absent, Binary, Enumeration, Reference, Typed, Value


def write_exchange(file: ExchangeFile) -> str:
    """Return the canonical text of an exchange file, independent of the numbers of its instances.

    Each record of the header and each instance has a separate line, numbered by `canonical`; real numbers
    have the fewest digits that represent the same number. Reading the text and writing it again yields the
    same bytes.

    Args:
        file: its references lead to instances of it.

    Raises:
        ValueError: a number is not finite, or a character has no place in a string.
    """
    lines = ["ISO-10303-21;", "HEADER;"]
    lines += [f"{_record(record)};" for record in file.header]
    lines += ["ENDSEC;", "DATA;"]
    lines += [_instance(instance) for instance in canonical(file).instances]
    lines += ["ENDSEC;", "END-ISO-10303-21;", ""]
    return "\n".join(lines)


def _instance(instance: Instance) -> str:
    if len(instance.records) == 1:
        return f"#{instance.number}={_record(instance.records[0])};"
    return f"#{instance.number}=({''.join(_record(record) for record in instance.records)});"


def _record(record: Record) -> str:
    return f"{record.keyword}({','.join(value_text(value) for value in record.values)})"


def value_text(value: Value) -> str:
    """Return a parameter in the form of a file.

    Raises:
        ValueError: a number is not finite, or a character has no place in a string.
    """
    match value:
        case int():
            return str(value)
        case float():
            return _real(value)
        case str():
            return f"'{encoded(value)}'"
        case Reference(number):
            return f"#{number}"
        case Enumeration(name):
            return f".{name}."
        case Absent():
            return str(value.value)
        case Binary(digits):
            return f'"{digits}"'
        case Typed(keyword, inner):
            return f"{keyword}({value_text(inner)})"
        case tuple():
            return f"({','.join(value_text(one) for one in value)})"


def _real(number: float) -> str:
    """Return the fewest digits of a number, with a point; both zeros are one."""
    if not isfinite(number):
        raise ValueError(f"{number} cannot be written, allowed are finite numbers")
    digits, _, exponent = repr(number + 0.0).partition("e")
    digits = digits if "." in digits else f"{digits}."
    digits = digits.removesuffix("0") if digits.endswith(".0") else digits
    return f"{digits}E{int(exponent)}" if exponent else digits
