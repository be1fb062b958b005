"""What can be wrong or doubtful, as frozen values, and the one place that puts it into words.

Lies under all of the core and knows nothing of it: findings name segments by number, fields by
their path in the project file, and rules by their names.
"""
