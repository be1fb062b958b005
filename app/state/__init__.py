"""What one window holds between events: presenter, view state, gestures, jobs, preferences.

Every edit reaches the screen through here; no panel or view is known.
"""
