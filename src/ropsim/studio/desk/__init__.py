"""The worker process of the studio: it opens, simulates and jogs; the web process never computes."""

from ropsim.studio.desk.main import main as main
