"""Laws from files of a project: block diagrams as compiled laws, and the choice between these and modules."""
