"""What every package may use: spans, source texts, diagnostics and their catalogue, the file door."""

from ropsim.core.catalogue import Kind as Kind
from ropsim.core.catalogue import catalogue as catalogue
from ropsim.core.catalogue import define as define
from ropsim.core.diagnostic import Diagnostic as Diagnostic
from ropsim.core.diagnostic import Label as Label
from ropsim.core.diagnostic import Severity as Severity
from ropsim.core.diagnostic import TextEdit as TextEdit
from ropsim.core.errors import RopsimError as RopsimError
from ropsim.core.files import cache_folder as cache_folder
from ropsim.core.files import read_bytes as read_bytes
from ropsim.core.files import read_own_bytes as read_own_bytes
from ropsim.core.files import replace_file as replace_file
from ropsim.core.files import replace_private_file as replace_private_file
from ropsim.core.frozen_dataclass import frozen_dataclass as frozen_dataclass
from ropsim.core.frozen_dataclass import frozen_without_equality as frozen_without_equality
from ropsim.core.places import Places as Places
from ropsim.core.places import places_of as places_of
from ropsim.core.plural import plural as plural
from ropsim.core.source import SourceText as SourceText
from ropsim.core.span import Span as Span
from ropsim.core.suggest import did_you_mean as did_you_mean
from ropsim.core.suggest import near as near
from ropsim.core.toml_values import toml_values as toml_values
from ropsim.core.without_collection import kept_from_collection as kept_from_collection
from ropsim.core.without_collection import without_collection as without_collection
