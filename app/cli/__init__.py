"""The command line: one subcommand a function, on the same functions as the window.

Words for people are made here and in the core's words alone.
"""
