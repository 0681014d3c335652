"""Forward kinematics and Jacobians along the tree of a mechanism, and its closed chains."""
