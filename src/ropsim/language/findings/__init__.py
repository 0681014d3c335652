"""The kinds of diagnostics of the task language: syntax (L1xx), names (N2xx), types and units (T3xx)."""
