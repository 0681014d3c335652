"""The open project, its tabs, and the effect of each message of a page."""
