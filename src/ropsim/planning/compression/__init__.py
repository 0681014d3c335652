"""Compression: short lines one after the other are flown as one curve."""
