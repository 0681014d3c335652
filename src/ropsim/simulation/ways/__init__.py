"""Collisions of a run: every body against all else on all its ways, found in the recording."""

from ropsim.simulation.ways.findings import contact_findings as contact_findings
from ropsim.simulation.ways.findings import without_contact_findings as without_contact_findings
from ropsim.simulation.ways.run_collisions import RunCollisions as RunCollisions
from ropsim.simulation.ways.run_collisions import needs_check as needs_check
from ropsim.simulation.ways.run_collisions import run_collisions as run_collisions
from ropsim.simulation.ways.run_collisions import with_collisions as with_collisions
