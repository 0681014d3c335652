"""Moving the robot by hand."""
