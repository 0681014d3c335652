"""The built-in robots that are written in Python: between them all kinds of joints, drives and couplings.

Those that come as files are serial arms of turning joints; tests/unit/robots/test_stored.py is theirs.
"""

WRITTEN = ("palletizer", "puma560", "scara", "two_link")
