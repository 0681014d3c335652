"""Task programs at random, and what they mean by the manual, without compiler and machine."""
