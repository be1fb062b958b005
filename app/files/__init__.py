"""A window's file: opening, saving, setting work aside, thumbnails.

Knows the state and the core's files; shows nothing but questions.
"""
