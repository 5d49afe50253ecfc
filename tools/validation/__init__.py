"""Known answers of the whole program: cases, references and what was obtained."""
