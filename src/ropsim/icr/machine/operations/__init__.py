"""All operations: instructions that reach beyond the stack."""

from ropsim.icr.machine.operations.control import CONTROL
from ropsim.icr.machine.operations.io import IO
from ropsim.icr.machine.operations.modal import MODAL
from ropsim.icr.machine.operations.motion import MOTION
from ropsim.icr.machine.operations.sensing import SENSING

OPERATIONS = CONTROL | MODAL | MOTION | IO | SENSING
"""Mnemonic -> operation."""
