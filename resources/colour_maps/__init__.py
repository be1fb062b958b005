"""The colour tables of the maps, and what makes them."""
