"""The program's textures, and what makes them."""
