"""The Measures panel: what a body holds, weighs and needs, and the numbers that making it takes."""
