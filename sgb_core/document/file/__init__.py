"""The project file: reading, checking, writing whole or not at all, and copies set aside."""
