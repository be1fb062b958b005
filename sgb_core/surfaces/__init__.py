"""What turning a profile about an axis gives: surfaces, meshes, measures."""
