"""Named benchmarks of the whole program: what is run, what is measured and how it is told."""
