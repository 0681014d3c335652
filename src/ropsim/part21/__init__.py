"""Exchange files of ISO 10303-21 ("STEP files"): read, numbered canonically, written."""

from ropsim.part21.exchange_file import ExchangeFile as ExchangeFile
from ropsim.part21.exchange_file import Instance as Instance
from ropsim.part21.exchange_file import Record as Record
from ropsim.part21.exchange_file import references as references
from ropsim.part21.numbering import canonical as canonical
from ropsim.part21.reader import read_exchange as read_exchange
from ropsim.part21.values import FALSE as FALSE
from ropsim.part21.values import TRUE as TRUE
from ropsim.part21.values import UNKNOWN as UNKNOWN
from ropsim.part21.values import Absent as Absent
from ropsim.part21.values import Binary as Binary
from ropsim.part21.values import Enumeration as Enumeration
from ropsim.part21.values import Reference as Reference
from ropsim.part21.values import Typed as Typed
from ropsim.part21.values import Value as Value
from ropsim.part21.writer import value_text as value_text
from ropsim.part21.writer import write_exchange as write_exchange
