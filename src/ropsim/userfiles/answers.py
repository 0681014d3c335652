"""Answers of the compiler that are kept for the next process."""

from ropsim.core import KeptFiles

KEPT_ANSWERS = KeptFiles("answers", most=64_000_000, largest=16_000_000)
"""Bytes under the digests of their inputs; see `ropsim.core.disk.kept_files`."""
