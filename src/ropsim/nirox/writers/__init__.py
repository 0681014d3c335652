"""The parts of a robot to instances of an exchange file."""
