"""The tools, each a small module: `runs(scene)` gives for every method a run by tolerance, (nanoseconds, last state)."""
