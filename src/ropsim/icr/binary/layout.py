"""Layout of the binary form: magic, version, sections, checksum."""

from enum import IntEnum

MAGIC = b"ICB\x00"
"""The first four bytes."""
VERSION = (1, 0)
"""Major and minor version, as in the text form; a reader refuses others."""
CHECKSUM = 32
"""Bytes of the SHA-256 of all bytes before it, at the end."""
LONGEST_NAME = 255
"""Maximum bytes of a name: bounds the size of the printed form, in which numbers of names become names."""


class Section(IntEnum):
    """Sections by number, in which order they stand; an empty one is left out.

    From `NAMES` on they say nothing that a robot does.
    """

    PROGRAM = 1
    REQUIREMENTS = 2
    VARIABLES = 3
    CHANNELS = 4
    FRAMES = 5
    TOOLS = 6
    PROCEDURES = 7
    LISTS = 8
    NAMES = 128
    LINES = 129
    LIBRARIES = 130
