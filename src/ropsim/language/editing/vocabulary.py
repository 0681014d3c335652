"""The words of the language by the place where they may stand, for editors and manuals."""

from ropsim.language.check.expressions.functions import NAMES
from ropsim.language.syntax.lexer import UNITS
from ropsim.language.syntax.readers.declarations import TYPES
from ropsim.language.syntax.words import (
    END,
    EXTERNAL,
    FREE,
    HEADS,
    INSIDE,
    MOTION_MODIFIERS,
    NOT_YET,
    RESERVED,
    VIA,
)

_REFUSED_TYPES = frozenset(["frame", "tool", "signal"])

STATEMENT_WORDS = (HEADS - NOT_YET) | {END}
"""Words that start a statement of this version; `end` does so alone only and may be a name elsewhere."""

INNER_WORDS = RESERVED - HEADS
"""Words that stand inside statements and cannot be names."""

RESERVED_WORDS = RESERVED | NOT_YET | {END}
"""Words that are offered for no name, those of later versions included."""

NO_LIST_NAMES = RESERVED_WORDS | MOTION_MODIFIERS | frozenset(INSIDE)
"""Words that no list of points may have as its name: behind `along` some of them go on with the motion."""

LOCATION_WORDS = frozenset([EXTERNAL, FREE])
"""Words that stand behind a location only and may be names elsewhere."""

BEHIND_TARGETS = MOTION_MODIFIERS
"""Words behind the target of a motion that no other statement has; they may be names elsewhere."""

MOTION_WORDS = MOTION_MODIFIERS | {VIA}
"""Words that stand in a motion only and may be names elsewhere."""

TYPE_WORDS = frozenset(TYPES) - _REFUSED_TYPES
"""Types of parameters, constants and variables."""

UNIT_WORDS = frozenset(UNITS)
"""Units behind a number."""

FUNCTIONS = NAMES
"""Functions of expressions."""
