"""`python -m ropsim` is the command `ropsim`."""

from ropsim.cli import entry

if __name__ == "__main__":
    entry()
