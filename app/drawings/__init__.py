"""Drawings on paper: the true preview of a page, its choices, and what goes to the clipboard.

Knows what is exported and how; the pages themselves are the core's.
"""
