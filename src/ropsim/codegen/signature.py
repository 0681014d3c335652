"""What a compiled function takes: arrays of float64 without gaps, whole numbers and floats."""

from ropsim.codegen.caller import calling
from ropsim.codegen.direct import Compiled
from ropsim.codegen.direct_text import REAL
from ropsim.core import frozen_dataclass

_AXES = {"f8[::1]": 1, "f8[:,::1]": 2, "f8[:,:,::1]": 3}
_WHOLE, _FLOAT = "i8", "f8"


@frozen_dataclass
class Signature:
    """The arguments of a compiled function, which returns nothing.

    Attributes:
        arguments: a word each, as numba writes them: `i8`, `f8`, `f8[::1]`, `f8[:,::1]` or `f8[:,:,::1]`.
    """

    arguments: tuple[str, ...]

    @classmethod
    def parse(cls, text: str) -> "Signature":
        """Return the signature of a text such as `void(f8[:,::1], i8)`.

        Raises:
            ValueError: it returns something, or takes what compiled code cannot.
        """
        head, _, rest = text.partition("(")
        words = rest.removesuffix(")").replace(" ", "").replace("],", "];").replace("8,", "8;")
        arguments = tuple(filter(None, words.split(";")))
        known = (*_AXES, _WHOLE, _FLOAT)
        if head != "void" or not set(arguments) <= set(known):
            raise ValueError(f"`{text}` is not void(…) of {', '.join(known)}")
        return cls(arguments)

    def entry_text(self, name: str) -> str:
        """Return the source of `entry`, which calls the function `name` with what two blocks tell.

        The first block holds whole numbers, for an array its address and lengths; the second one floats. Two
        addresses are handed over sooner than fifty numbers.
        """
        values: list[str] = []
        whole = real = 0
        for word in self.arguments:
            axes = _AXES.get(word)
            if axes is not None:
                lengths = "".join(f"whole[{whole + 1 + axis}], " for axis in range(axes))
                values.append(f"array_at(whole[{whole}], ({lengths}))")
                whole += 1 + axes
            elif word == _WHOLE:
                values.append(f"whole[{whole}]")
                whole += 1
            else:
                values.append(f"real[{real}]")
                real += 1
        return f"def entry(whole, real):\n    {name}({', '.join(values)})\n"

    def caller(self, address: int) -> Compiled:
        """Return the Python function for the machine code at an address.

        The code has numba's own calling convention: it returns a status, 0 for success, and takes two more
        addresses before the arguments, for a result and for what an exception says. It runs without the
        interpreter lock. Arrays that do not fit are refused with a TypeError.
        """
        takes = tuple(_AXES.get(word, 0 if word == _WHOLE else REAL) for word in self.arguments)
        return calling(address, takes)
