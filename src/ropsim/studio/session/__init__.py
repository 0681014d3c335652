"""The open project, its tabs, and what each message of a page does."""
