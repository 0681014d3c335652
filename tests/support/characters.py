"""The characters of texts at random."""

from hypothesis import strategies as st

ANY = st.characters(exclude_categories=["Cs"])
"""All that UTF-8 has: all but surrogates.

It is the set that hypothesis takes by itself; for that it encodes 1.1 million characters, 2.6 s in each
process that comes to it in a fresh checkout, before one has kept it on the disk.
"""
