"""The SWI-Prolog of this machine as a process of its own."""
