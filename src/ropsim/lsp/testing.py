"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.lsp.analysis.recorded_runs import MOST as MOST
from ropsim.lsp.completion import words as words
from ropsim.lsp.completion.call_place import call_place as call_place
from ropsim.lsp.completion.expected import UNITS_OF as UNITS_OF
from ropsim.lsp.protocol.attention import SupersededError as SupersededError
from ropsim.lsp.protocol.attention import nobody_calls as nobody_calls
from ropsim.lsp.protocol.document import Document as Document
from ropsim.lsp.protocol.framing import MAX_BODY as MAX_BODY
from ropsim.lsp.protocol.framing import FrameFault as FrameFault
from ropsim.lsp.protocol.framing import FrameReader as FrameReader
from ropsim.lsp.protocol.framing import framed as framed
from ropsim.lsp.protocol.inbox import CANCEL as CANCEL
from ropsim.lsp.protocol.inbox import Inbox as Inbox
from ropsim.lsp.protocol.messages import Call as Call
from ropsim.lsp.protocol.messages import ErrorCode as ErrorCode
from ropsim.lsp.protocol.messages import Fault as Fault
from ropsim.lsp.protocol.messages import read_message as read_message
from ropsim.lsp.protocol.parameters import ContentChange as ContentChange
from ropsim.lsp.protocol.parameters import Position as Position
from ropsim.lsp.protocol.parameters import Range as Range
from ropsim.lsp.requests import REQUESTS as REQUESTS
from ropsim.lsp.server import CAPABILITIES as CAPABILITIES
from ropsim.lsp.server import first_sight as first_sight
from ropsim.lsp.state import Phase as Phase
