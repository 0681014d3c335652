"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.exchange.files.packages import MOST_DEPTH as MOST_DEPTH
from ropsim.exchange.files.packages import MOST_FOLDERS as MOST_FOLDERS
from ropsim.exchange.files.read_mesh import mesh_of as mesh_of
from ropsim.exchange.files.xml_tree import MOST_ATTRIBUTE as MOST_ATTRIBUTE
from ropsim.exchange.files.xml_tree import MOST_ELEMENTS as MOST_ELEMENTS
from ropsim.exchange.files.xml_tree import Element as Element
from ropsim.exchange.files.xml_tree import read_xml as read_xml
from ropsim.exchange.losses.diagnostics import NOT_XML as NOT_XML
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION as LOST_DESCRIPTION
from ropsim.exchange.losses.notes import MOST_NOTES as MOST_NOTES
from ropsim.exchange.losses.notes import Notes as Notes
from ropsim.exchange.writing.write_losses import friction_at_joint as friction_at_joint
from ropsim.exchange.writing.write_losses import rotor_at_joint as rotor_at_joint
from ropsim.exchange.writing.written_tree import written_tree as written_tree
from ropsim.exchange.xacro.expansion import expanded as expanded
from ropsim.exchange.xacro.formulas.parser import value_of as value_of
from ropsim.exchange.xacro.formulas.values import Value as Value
from ropsim.exchange.xacro.formulas.values import XacroError as XacroError
from ropsim.exchange.xacro.formulas.values import bounded as bounded
from ropsim.exchange.xacro.formulas.values import literal as literal
from ropsim.exchange.xacro.formulas.values import truth as truth
from ropsim.exchange.xacro.scope import Scope as Scope
from ropsim.exchange.xacro.substitution import text_of as text_of
from ropsim.exchange.xacro.substitution import value_of_text as value_of_text
from ropsim.exchange.xacro.yaml_values import yaml_value as yaml_value
