"""The Look panel: material, light, texture, painted layers and colour maps."""
