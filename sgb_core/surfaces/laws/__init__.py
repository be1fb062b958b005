"""Laws over the angle: what a law is, and a module for each of their shapes."""
