"""Responses and margins of the loops of a station as one HTML page."""
