"""The panel of dimensions and locks."""
