"""Plates of panels for papers, the paper's figures, and the studio and fit dialog for them."""
