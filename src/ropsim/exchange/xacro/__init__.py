"""Xacro: the macros in which robot files of ROS are written, expanded without running anything of theirs."""
