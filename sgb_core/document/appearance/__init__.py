"""How the object looks: finishes, paint, pictures, colour maps.

Values that the file keeps and exports carry.
"""
