"""The project file: reading, checking, writing whole or not at all, and copies set aside.

Knows the document's tables of fields; the disk is touched here and in the exchange only.
"""
