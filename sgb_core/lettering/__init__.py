"""Text in a font as outlines, exact curves taken apart, and how far places are from them."""
