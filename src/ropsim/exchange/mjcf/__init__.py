"""MJCF, the modelling format of MuJoCo (XML reference of MuJoCo 4): its elements."""
