"""Instances of an exchange file to the parts of a robot."""
