"""A description of bodies and connections, and the robot that it becomes."""
