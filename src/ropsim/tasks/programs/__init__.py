"""Programs from tasks: compiled bodies, drafts of an operator, and task text."""
