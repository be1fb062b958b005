"""Search for parameters instead of evaluating them."""
