"""Films of the object turning or changing, as GIF, MP4 or pictures."""
