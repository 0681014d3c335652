"""Laws from files of a project: block diagrams as compiled laws, and modules in Python."""
