"""The Turn panel: axis, angles, unit and size, and where the finished object stands."""
