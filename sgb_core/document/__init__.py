"""The saved truth of a project and the ways to change it."""
