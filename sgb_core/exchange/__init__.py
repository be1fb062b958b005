"""Reading and writing the formats of other programs, one module a format."""
