"""What the fields of values may be: each limit once, for constructors, files, schema and panels.

Lies under the geometry and knows only findings. A frozen value declares its fields here with what
is allowed, and checks itself by :func:`sgb_core.fields.record.check` when it is made.
"""
