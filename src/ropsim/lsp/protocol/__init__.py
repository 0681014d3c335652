"""Messages, their parameters, and documents as the protocol describes them."""
