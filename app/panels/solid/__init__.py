"""The panel Solid: what the drawn surface means as an object, and the holes through its wall."""
