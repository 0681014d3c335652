"""Programs that wait for ever, for signals or held."""
