"""What a run writes, and that nothing but the input decides it."""

import math
import struct
import unittest

from program import ProgramTest

RANDOM = """
[packing]
generate = "random-dense"
count = 500
radius_spread = 0.1
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.68
"""


class Results(ProgramTest):
    def test_numbers_of_the_series_are_the_shortest_that_read_back(self):
        self.frit("run", "pair.toml", "--quiet")
        for name, column in self.series("pair").items():
            for text in column:
                if text:
                    shortest = repr(float(text))
                    self.assertEqual(struct.pack("d", float(text)), struct.pack("d", float(shortest)))
                    self.assertLessEqual(len(text.replace("e+", "e")), len(shortest) + 1, f"{name}: {text}")

    def test_the_summary_ends_with_the_last_row(self):
        self.frit("run", "lattice.toml", "--quiet")
        final, series = self.summary("lattice")["final"], self.series("lattice")
        self.assertEqual(sorted(final), sorted(series))
        for name, column in series.items():
            self.assertEqual(final[name], float(column[-1]) if column[-1] else None, name)
        self.assertTrue(math.isclose(final["relative_density"], 0.6, rel_tol=1e-7))

    def test_the_resolved_case_gives_the_same_series_from_any_folder(self):
        self.frit("run", "pair.toml", "-o", "first", "--quiet")
        (self.folder / "elsewhere").mkdir()
        self.frit("run", "first/case.toml", "-o", "elsewhere/second", "--quiet")
        self.assertEqual((self.folder / "first" / "series.csv").read_bytes(),
                         (self.folder / "elsewhere" / "second" / "series.csv").read_bytes())

    def test_threads_do_not_show(self):
        self.write("random.toml", RANDOM)
        for threads in (1, 2):
            self.frit("run", "random.toml", "--threads", threads, "-o", f"with{threads}", "--quiet")
        for name in ("series.csv", "case.toml", "snapshots.pvd", "snapshots/particles_000001.vtp",
                     "snapshots/contacts_000001.vtp"):
            self.assertEqual((self.folder / "with1" / name).read_bytes(), (self.folder / "with2" / name).read_bytes(), name)

    def test_nothing_in_the_results_tells_the_clock(self):
        for n in (1, 2):
            self.frit("run", "lattice.toml", "-o", f"run{n}", "--quiet")
        for path in (self.folder / "run1").rglob("*"):
            if path.is_file() and path.name not in ("summary.json", "report.html"):  # these tell the cost
                other = self.folder / "run2" / path.relative_to(self.folder / "run1")
                self.assertEqual(path.read_bytes(), other.read_bytes(), path.name)


class Packings(ProgramTest):
    def test_a_packing_that_is_packed_runs_like_the_generated_one(self):
        self.write("random.toml", RANDOM)
        text = self.frit("pack", "random.toml", "-o", "packed.csv").stdout
        self.assertIn("500", text)
        size = next(line for line in text.splitlines() if line.startswith("cell")).split("[")[1].split("]")[0]
        self.write("packed.toml", RANDOM.replace('generate = "random-dense"\ncount = 500\nradius_spread = 0.1',
                                                 'file = "packed.csv"')
                   .replace('kind = "periodic"', f'kind = "periodic"\nsize = [{size}]'))
        for name in ("random", "packed"):
            self.frit("run", f"{name}.toml", "--quiet", "--threads", 1)
        self.assertEqual((self.folder / "random" / "series.csv").read_bytes(),
                         (self.folder / "packed" / "series.csv").read_bytes())

    def test_snapshots_can_be_converted(self):
        self.frit("run", "pair.toml", "--quiet")
        self.frit("convert", "pair/snapshots/particles_000000.vtp", "start.csv")
        self.frit("convert", "start.csv", "start.xyz")
        self.frit("convert", "start.xyz", "again.csv")
        self.assertEqual((self.folder / "start.csv").read_bytes(), (self.folder / "again.csv").read_bytes())


if __name__ == "__main__":
    unittest.main()
