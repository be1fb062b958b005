"""A window's file: opening, saving, setting work aside, thumbnails."""
