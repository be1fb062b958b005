"""Gives the core the textures and colour tables that the program ships; imported for that alone."""

import resources
from sgb_core.document.appearance import colour_tables, pictures

pictures.set_library(resources.texture)
colour_tables.set_tables(resources.colour_table)
