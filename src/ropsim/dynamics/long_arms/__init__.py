"""Equations of motion of long chains, joint by joint in loops."""
