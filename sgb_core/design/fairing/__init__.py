"""The fairest curve that keeps what is asked for: energies, their derivatives, the search."""
