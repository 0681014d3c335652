"""SDFormat 1.11, the format of Gazebo: its elements in text form."""
