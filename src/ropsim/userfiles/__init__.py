"""Files of the user: the texts of projects, which code in them is trusted, unsaved texts, recent projects."""

from ropsim.userfiles.answers import KEPT_ANSWERS as KEPT_ANSWERS
from ropsim.userfiles.code_files import code_in as code_in
from ropsim.userfiles.diagnostics import TrustError as TrustError
from ropsim.userfiles.examples import STARTER as STARTER
from ropsim.userfiles.examples import example_names as example_names
from ropsim.userfiles.examples import example_summary as example_summary
from ropsim.userfiles.examples import examples_folder as examples_folder
from ropsim.userfiles.journal import Draft as Draft
from ropsim.userfiles.journal import Journal as Journal
from ropsim.userfiles.recent_projects import recent_projects as recent_projects
from ropsim.userfiles.recent_projects import remember_project as remember_project
from ropsim.userfiles.text_file import LARGEST as LARGEST
from ropsim.userfiles.text_file import MISSING_PATH as MISSING_PATH
from ropsim.userfiles.text_file import UNREADABLE as UNREADABLE
from ropsim.userfiles.text_file import missing_file as missing_file
from ropsim.userfiles.text_file import read_program_file as read_program_file
from ropsim.userfiles.text_file import read_project_text as read_project_text
from ropsim.userfiles.text_file import read_text_file as read_text_file
from ropsim.userfiles.trust import Trust as Trust
from ropsim.userfiles.trust import inert_code as inert_code
from ropsim.userfiles.trust import set_trust as set_trust
from ropsim.userfiles.trust import trust_in as trust_in
