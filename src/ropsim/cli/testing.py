"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.cli.commands.icr import instruction_text as instruction_text
from ropsim.cli.main import main as main
from ropsim.cli.parser import build_parser as build_parser
from ropsim.cli.terminal import watch as watch
from ropsim.cli.terminal.line_editor import LineEditor as LineEditor
from ropsim.cli.terminal.output import Output as Output
from ropsim.cli.terminal.progress import Progress as Progress
from ropsim.cli.terminal.stamps import SETTLED as SETTLED
from ropsim.cli.terminal.stamps import contents as contents
from ropsim.cli.terminal.stamps import stamps as stamps
from ropsim.cli.terminal.streams import OutputLostError as OutputLostError
from ropsim.cli.terminal.streams import prepare_streams as prepare_streams
from ropsim.cli.terminal.streams import say as say
