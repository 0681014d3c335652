"""URDF, the Unified Robot Description Format of ROS (REP 120, urdf version 1.2): its elements."""
