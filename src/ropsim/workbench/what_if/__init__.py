"""What-if runs: a program unchanged and with changed speeds, accelerations, masses or zones, side by side."""

from ropsim.workbench.what_if.change import Change as Change
from ropsim.workbench.what_if.change import Subject as Subject
from ropsim.workbench.what_if.change import WhatIfError as WhatIfError
from ropsim.workbench.what_if.change import read_change as read_change
