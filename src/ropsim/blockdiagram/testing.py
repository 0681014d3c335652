"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.blockdiagram.checks.check import faults_of as faults_of
from ropsim.blockdiagram.discrete import tustin_filter as tustin_filter
from ropsim.blockdiagram.fields import BlockForm as BlockForm
from ropsim.blockdiagram.fields import FieldKind as FieldKind
from ropsim.blockdiagram.fields import Trait as Trait
from ropsim.blockdiagram.forms import BLOCK_FORMS as BLOCK_FORMS
from ropsim.blockdiagram.forms import FORM_OF as FORM_OF
from ropsim.blockdiagram.schema_text import control_schema as control_schema
from ropsim.blockdiagram.schema_text import control_schema_text as control_schema_text
