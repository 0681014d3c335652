"""The binary form of ICR: bytes that say the same as the canonical text, and nothing else."""

from ropsim.icr.binary.reading import read_binary as read_binary
from ropsim.icr.binary.writing import encoded as encoded
