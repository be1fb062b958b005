"""The geometry of SGB Studio, usable without the window: ``import sgb_core as sgb``."""
