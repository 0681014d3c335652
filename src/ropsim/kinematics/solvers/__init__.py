"""The solvers of the inverse kinematics, one file for each class of arms; `recognition.py` lists them."""
