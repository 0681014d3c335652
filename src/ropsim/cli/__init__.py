"""The command line: the only place that parses arguments and prints."""

from ropsim.cli.catalogue import all_kinds as all_kinds
from ropsim.cli.main import entry as entry
from ropsim.cli.retired import RETIRED as RETIRED
