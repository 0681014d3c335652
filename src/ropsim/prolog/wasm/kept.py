"""The room of the cache folder in which machine code and images of SWI-Prolog are kept."""

from ropsim.core import KeptFiles

KEPT = KeptFiles("prolog", most=128_000_000, largest=64_000_000)
"""Machine code has 6 MB, an image some."""
