"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.workbench.cell.collisions import CellCollisions as CellCollisions
from ropsim.workbench.cell.part_places import part_places as part_places
from ropsim.workbench.compiling.dry_arm import dry_arm as dry_arm
from ropsim.workbench.projects.first_way import first_way as first_way
from ropsim.workbench.projects.project_name import LONGEST as LONGEST
from ropsim.workbench.projects.project_name import name_from_folder as name_from_folder
from ropsim.workbench.projects.project_name import name_project as name_project
from ropsim.workbench.report import NOT_BUILT as NOT_BUILT
from ropsim.workbench.report import OTHER_ARM as OTHER_ARM
from ropsim.workbench.report import Report as Report
from ropsim.workbench.report import built_viewer as built_viewer
from ropsim.workbench.tasks.declared_tasks import declared_tasks as declared_tasks
from ropsim.workbench.what_if.change import NOTHING_COMPARED as NOTHING_COMPARED
from ropsim.workbench.what_if.comparing import content_of as content_of
from ropsim.workbench.workspace import questions as questions
from ropsim.workbench.workspace.answer_form import Translation as Translation
from ropsim.workbench.workspace.answer_form import UnknownFormError as UnknownFormError
from ropsim.workbench.workspace.answer_form import read as read
from ropsim.workbench.workspace.answer_form import written as written
from ropsim.workbench.workspace.mentions import Mentions as Mentions
from ropsim.workbench.workspace.questions import LEAST_LINES as LEAST_LINES
