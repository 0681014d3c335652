"""Postures that serve the paths behind them."""
