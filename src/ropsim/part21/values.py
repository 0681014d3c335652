"""Values of parameters in an exchange file of ISO 10303-21."""

from enum import Enum

from ropsim.core import frozen_dataclass


class Absent(Enum):
    """A parameter without a value of its own."""

    UNSET = "$"
    DERIVED = "*"


@frozen_dataclass
class Reference:
    """The number of an instance, such as `#12`."""

    number: int


@frozen_dataclass
class Enumeration:
    """An item of an enumeration or a logical value, in capitals and without its dots."""

    name: str


@frozen_dataclass
class Binary:
    """A row of bits as encoded between quotation marks.

    Attributes:
        digits: first how many bits of the next digit do not count, 0 to 3, then hexadecimal digits.
    """

    digits: str


@frozen_dataclass
class Typed:
    """A value that names its type, such as `PLANE_ANGLE_MEASURE(0.5)`.

    Attributes:
        keyword: name of the type in capitals.
        value: value in the parentheses.
    """

    keyword: str
    value: "Value"


Value = int | float | str | Absent | Reference | Enumeration | Binary | Typed | tuple["Value", ...]
"""A parameter; a list is a tuple of values."""

TRUE, FALSE, UNKNOWN = Enumeration("T"), Enumeration("F"), Enumeration("U")
"""The three logical values."""
