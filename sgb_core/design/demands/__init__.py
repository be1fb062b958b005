"""What can be demanded of a profile, as equations with exact derivatives, and how they are met.

Fairing, targets and locks all change the same unknowns under the same kinds of equations; these
live here, and know nothing of what is wanted of them.
"""
