"""Loops of standard controllers: the gains of each law and of hydraulic axes, from the model of the arm."""
