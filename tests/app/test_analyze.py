"""frit analyze and frit compare: what they print and write, and what they say of wrong input."""

import json
import unittest
import xml.etree.ElementTree

from program import ProgramTest

RANDOM = """
[packing]
generate = "random-dense"
count = 200
[cell]
kind = "periodic"
[material]
use = "copper"
[contact]
sliding_resistance = 0.01
[stop]
relative_density = 0.68
"""
A = "id,x,y,z,radius\n7,0,0,0,1\n8,1.9,0,0,1\n9,0,1.9,0,1\n10,0,0,1.9,1\n11,1.9,1.9,1.9,1\n"


def table(path):
    """Columns of a CSV file by name, as text."""
    rows = [line.split(",") for line in path.read_text().splitlines()]
    return {name: [row[n] for row in rows[1:]] for n, name in enumerate(rows[0])}


class Analyze(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("random.toml", RANDOM)

    def test_a_run_again(self):
        self.frit("run", "random.toml", "--quiet")
        text = self.frit("analyze", "random").stdout
        self.assertIn("pair ratio", text)
        self.assertIn("random/analysis", text)
        written, found = table(self.folder / "random/series.csv"), table(self.folder / "random/analysis/series.csv")
        self.assertEqual(list(written), list(found))
        for name in ("relative_density", "contacts", "rearrangement_deviation_q50", "rolling_mean [rad]", "sliding_mean"):
            for one, other in zip(written[name], found[name]):
                self.assertAlmostEqual(float(one), float(other), delta=1e-11 * abs(float(one)), msg=name)
        self.assertEqual(set(found["steps"]), {""})
        network = table(self.folder / "random/analysis/network.csv")
        self.assertTrue(0.05 < float(network["clustering"][-1]) < 0.5)
        moments = json.loads((self.folder / "random/analysis/distributions.json").read_text())["moments"]
        self.assertEqual(len(moments), len(written["contacts"]))

    def test_another_reference_and_folder(self):
        self.frit("run", "random.toml", "--quiet")
        self.frit("analyze", "random", "--reference", "1", "-o", "found")
        deviation = table(self.folder / "found/series.csv")["rearrangement_deviation_mean"]
        self.assertGreater(float(deviation[0]), 1e-6)
        self.assertLess(float(deviation[1]), 1e-12)
        self.assertFalse((self.folder / "random/analysis").exists())

    def test_a_new_run_takes_the_old_analysis_away(self):
        self.frit("run", "random.toml", "--quiet")
        self.frit("analyze", "random")
        self.frit("run", "random.toml", "--quiet", "--force")
        self.assertFalse((self.folder / "random/analysis/series.csv").exists())

    def test_threads_do_not_show(self):
        self.frit("run", "random.toml", "--quiet")
        for threads in (1, 3):
            self.frit("analyze", "random", "--threads", threads, "-o", f"with{threads}")
        for name in ("series.csv", "network.csv", "distributions.json"):
            self.assertEqual((self.folder / "with1" / name).read_bytes(), (self.folder / "with3" / name).read_bytes())

    def test_measured_centres(self):
        self.write("a.csv", A)
        self.write("b.csv", "\n".join(reversed(A.replace("1.9", "1.71").strip().splitlines()[1:])).join(
            ("id,x,y,z,radius\n", "\n")))
        text = self.frit("analyze", "--centres", "a.csv", "b.csv", "--times", "0", "60").stdout
        self.assertIn("60", text)
        found = table(self.folder / "analysis/series.csv")
        self.assertAlmostEqual(float(found["linear_strain_x"][1]), -0.10536, places=4)
        self.assertAlmostEqual(float(found["rearrangement_deviation_q90"][1]), 0.0, places=12)
        self.assertEqual(found["contacts"], ["3", "3"])
        self.assertEqual(set(found["neck_ratio_mean"] + found["theta [m^5 s/(N s)]"]), {""})

    def test_wrong_input(self):
        self.write("a.csv", A)
        self.write("b.csv", A.replace("11,", "12,"))
        self.write("short.csv", "\n".join(A.splitlines()[:-1]) + "\n")
        fault = self.frit("analyze", "--centres", "a.csv", "b.csv", code=2)
        self.assert_fault(fault, "b.csv", "lacks 1 of the 5", "11")
        self.assert_fault(fault, "a.csv", "lacks 1 of the 5", "12")
        self.assert_fault(fault, "--common")
        self.assert_fault(self.frit("analyze", "--centres", "a.csv", "short.csv", code=2), "short.csv", "lacks 1 of the 5")
        self.assert_fault(self.frit("analyze", "--centres", "a.csv", code=2), "two times")
        self.assert_fault(self.frit("analyze", code=2), "folder of a result", "--centres")
        self.assert_fault(self.frit("analyze", "x", "--gap", "0.1", code=2), "--gap", "belong to --centres")
        self.assert_fault(self.frit("analyze", "nowhere", code=2), "nowhere", "no such folder")
        self.frit("run", "pair.toml", "--quiet", "--set", "output.snapshots=false")
        self.assert_fault(self.frit("analyze", "pair", code=2), "pair", "no snapshots", "output.snapshots")
        self.assertEqual(self.names(), ["a.csv", "b.csv", "pair", "random.toml", "short.csv"])


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("random.toml", RANDOM)

    def test_two_runs(self):
        for eta in ("0.01", "0.1"):
            self.frit("run", "random.toml", "--quiet", "-o", f"eta{eta}", "--set", f"contact.sliding_resistance={eta}",
                      "--set", "output.snapshots=false")
        text = self.frit("compare", "eta0.01", "eta0.1").stdout
        self.assertIn("contact.sliding_resistance", text)
        self.assertIn("rearrangement (pair ratio)", text)
        self.assertIn(" %)", text)
        lines = (self.folder / "comparison/compare.csv").read_text().splitlines()
        self.assertEqual(lines[0], 'figure,relative_density,"eta0.01","eta0.1","eta0.1: difference [%]"')
        ratio = [line.split(",") for line in lines if line.startswith("rearrangement_pair_ratio,0.68")][-1]
        self.assertLess(float(ratio[3]), float(ratio[2]))
        self.assertAlmostEqual(float(ratio[4]), 100 * (float(ratio[3]) / float(ratio[2]) - 1), places=9)
        for name in ("density", "rearrangement", "necks", "coordination"):
            xml.etree.ElementTree.parse(self.folder / f"comparison/{name}.svg")
        text = self.frit("compare", "eta0.01", "eta0.1", "--at", "time", "-o", "out").stdout
        self.assertIn("relative density\n", text)

    def test_the_same_run_does_not_differ(self):
        self.frit("run", "random.toml", "--quiet", "-o", "a")
        text = self.frit("compare", "a", "a").stdout
        self.assertIn("the cases do not differ", text)
        self.assertIn("(+0.00 %)", text)

    def test_nothing_in_common_is_said(self):
        self.frit("run", "pair.toml", "--quiet")
        self.frit("run", "lattice.toml", "--quiet")
        text = self.frit("compare", "pair", "lattice").stdout
        self.assertIn("no common relative_density", text)
        self.assertIn("pair: has no relative_density", text)
        self.assertIn("lattice: relative_density from 0.52", text)
        self.assertIn("packing.generate", text)
        self.assertIn("neck ratio", self.frit("compare", "pair", "lattice", "--at", "time").stdout)

    def test_wrong_input(self):
        self.frit("run", "pair.toml", "--quiet")
        (self.folder / "empty").mkdir()
        fault = self.frit("compare", "pair", "nowhere", "empty", code=2)
        self.assert_fault(fault, "nowhere", "no such folder")
        self.assert_fault(fault, "empty", "series.csv")
        self.assert_fault(self.frit("compare", "pair", code=2), "at least two")
        self.assert_fault(self.frit("compare", "pair", "pair", "--at", "noon", code=2), "--at")
        summary = self.folder / "pair/summary.json"
        summary.write_text(summary.read_text().replace("mean_radius_m", "something"))
        self.assert_fault(self.frit("compare", "pair", "pair", "--at", "time", code=2), "pair", "mean_radius_m")
        self.assertFalse((self.folder / "comparison").exists())


if __name__ == "__main__":
    unittest.main()
