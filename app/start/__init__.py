"""What greets: gallery of presets, hints, guided tour, and the offer of unsaved work."""
