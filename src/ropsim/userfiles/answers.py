"""Answers of the compiler that are kept for the next process."""

from ropsim.core import KeptFiles

KEPT_ANSWERS = KeptFiles("answers", most=64_000_000, largest=16_000_000)
"""Bytes under the names of what they were made of; see `ropsim.core.disk.kept_files`."""
