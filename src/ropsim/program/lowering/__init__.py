"""From the structured program to ICR."""
