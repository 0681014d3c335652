"""Devices, signals and sensors."""
