"""Grips, hand-overs and supplies of parts."""
