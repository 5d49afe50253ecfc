"""Results, packings and plots."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

import frit
from samples import CASE, PAIR, TOUCHING, FolderTest


class Results(FolderTest):
    @classmethod
    def setUpClass(cls):
        cls._results = tempfile.TemporaryDirectory(prefix="frit-python-")
        cls.out = pathlib.Path(cls._results.name, "out")
        cls.case = frit.parse_case(CASE)
        cls.run_ = frit.run(cls.case, cls.out)

    @classmethod
    def tearDownClass(cls):
        cls._results.cleanup()

    def setUp(self):
        super().setUp()
        self.result = frit.read_result(self.out)

    def test_series_have_the_bits_of_the_run(self):
        self.assertEqual(list(self.result.series), list(self.run_.series))
        for name, values in self.run_.series.items():
            self.assertTrue(numpy.array_equal(values, self.result.series[name], equal_nan=True), name)

    def test_units_may_be_left_out_and_near_names_are_told(self):
        self.assertIs(self.result.series["time"], self.result.series["time [s]"])
        with self.assertRaisesRegex(KeyError, "relative_density"):
            self.result.series["relative_densty"]

    def test_the_last_snapshot_is_the_last_state(self):
        snapshot, state = self.result.snapshots[-1], self.run_.state
        self.assertEqual(len(self.result.snapshots), len(self.result.series["time"]))
        self.assertEqual(snapshot.time, state.time)
        self.assertEqual(snapshot.whole["time"], state.time)
        self.assertTrue(numpy.array_equal(snapshot.particles["position"], state.positions))
        self.assertTrue(numpy.array_equal(snapshot.particles["radius"], state.radii))
        self.assertTrue(numpy.array_equal(snapshot.contacts["neck_radius"], state.neck_radii))
        self.assertTrue(numpy.array_equal(snapshot.contacts["i"], state.contact_i))
        self.assertTrue(numpy.array_equal(snapshot.whole["cell_size"], state.cell_size))

    def test_fields_of_a_state_are_those_of_its_snapshot(self):
        snapshot, state = self.result.snapshots[-1], self.run_.state
        for fields, arrays in ((state.particle_fields(), snapshot.particles), (state.contact_fields(), snapshot.contacts)):
            self.assertGreater(len(fields), 5)
            for name, values in fields.items():
                self.assertTrue(numpy.array_equal(values, arrays[name], equal_nan=True), name)

    def test_case_and_summary(self):
        self.assertEqual(self.result.case["packing"]["count"], 300)
        self.assertEqual(self.result.summary["steps"], self.run_.counts["steps"])

    def test_results_are_not_replaced_by_mistake(self):
        with self.assertRaisesRegex(frit.InputError, "holds results already"):
            frit.run(self.case, self.out)
        for relative_density in (0.65, 0.66):
            case = self.case.with_overrides({"stop.relative_density": relative_density})
            frit.run(case, self.folder / "out", replace=True)
        self.assertAlmostEqual(frit.read_result(self.folder / "out").series["relative_density"][-1], 0.66, 6)

    def test_particles_of_a_snapshot_become_a_packing(self):
        first = self.result.snapshots[0]
        packing = frit.Packing(first.particles["position"], first.particles["radius"], size=first.whole["cell_size"])
        text = CASE[CASE.index("[material]"):]
        again = frit.run(frit.parse_case(text, packing=packing))
        self.assertTrue(numpy.array_equal(again.state.positions, self.run_.state.positions))

    def test_plots(self):
        axes = frit.plot([self.run_, self.out], labels=["run", "folder"])
        self.assertEqual([line.get_label() for line in axes.lines], ["run", "folder"])
        self.assertEqual(axes.get_xlabel(), "time [s]")
        for line in axes.lines:
            self.assertTrue(numpy.array_equal(line.get_ydata(), self.run_.series["relative_density"]))
        axes.figure.savefig(self.folder / "plot.png")
        self.assertTrue((self.folder / "plot.png").read_bytes().startswith(b"\x89PNG"))


class Faults(FolderTest):
    def test_faults_of_a_case_come_together_with_the_programs_words(self):
        (self.folder / "case.toml").write_text("[packing]\ncolour = 1\n[stop]\ntime = \"2 kg\"\n")
        with self.assertRaises(frit.InputError) as caught:
            frit.load_case(self.folder / "case.toml")
        done = subprocess.run([frit_program(), "check", "case.toml"], cwd=self.folder, capture_output=True, text=True)
        theirs = [line.removeprefix("frit: ") for line in done.stderr.splitlines()]
        ours = [fault.replace(str(self.folder) + "/", "") for fault in caught.exception.faults]
        self.assertEqual(ours, theirs)
        self.assertGreaterEqual(len(ours), 3)
        self.assertEqual(str(caught.exception), "\n".join(caught.exception.faults))
        self.assertIsInstance(caught.exception, (frit.Error, ValueError))

    def test_faults_of_overrides_name_the_key(self):
        with self.assertRaisesRegex(frit.InputError, "contact.sliding_resistance"):
            frit.parse_case(CASE, {"contact.sliding_resistance": 0.7})
        with self.assertRaisesRegex(frit.InputError, "cell.knd"):
            frit.parse_case(CASE, {"cell.knd": "free"})

    def test_faults_of_arrays(self):
        with self.assertRaises(frit.InputError) as caught:
            frit.Packing([[0, 0], [1, 1]], [1, 2, 3])
        self.assertEqual(len(caught.exception.faults), 2)
        with self.assertRaisesRegex(frit.InputError, "radius.*not positive"):
            frit.Simulation(frit.parse_case(PAIR, packing=frit.Packing([[0, 0, 0], [1, 0, 0]], [1, -1])))

    def test_a_folder_that_cannot_be_written_is_the_machines_fault(self):
        (self.folder / "file").write_text("")
        with self.assertRaises(frit.MachineError):
            frit.Simulation(frit.parse_case(CASE), self.folder / "file" / "below")

    def test_missing_results(self):
        with self.assertRaisesRegex(frit.InputError, "series.csv"):
            frit.read_result(self.folder / "none")


class Cases(FolderTest):
    def test_values_of_every_kind_become_overrides(self):
        overrides = {"title": 'quotes " and \\ and \u00e9', "stop.time": "2 h", "output.snapshots": False,
                     "packing.count": numpy.int64(500), "contact.sliding_resistance": numpy.float64(0.1),
                     "cell.stress": numpy.array([-1e6, 0.0, 0.0]),
                     "temperature.program": [{"rate": "10 K/min", "to": 1400}, {"hold": "1 h"}]}
        case = frit.parse_case(CASE, overrides)
        self.assertEqual(case["title"], overrides["title"])
        self.assertEqual(case["stop.time"], 7200)
        self.assertIs(case["output.snapshots"], False)
        self.assertEqual(case["packing.count"], 500)
        self.assertEqual(case["contact.sliding_resistance"], 0.1)
        self.assertEqual(case["cell.stress"], [-1e6, 0, 0])
        self.assertEqual(case["temperature.program"][1], {"hold": 3600})
        self.assertEqual(frit.parse_case(CASE)["packing.count"], 300)

    def test_with_overrides_leaves_the_case_as_it_is(self):
        case = frit.parse_case(CASE, {"stop.time": 5})
        other = case.with_overrides({"packing.count": 400})
        self.assertEqual((case["packing.count"], other["packing.count"], other["stop.time"]), (300, 400, 5))

    def test_paths_are_relative_to_the_folder_of_the_case(self):
        TOUCHING.save(self.folder)
        (self.folder / "case.toml").write_text('[packing]\nfile = "packing.csv"\n' + PAIR)
        self.assertEqual(len(frit.Simulation(frit.load_case(self.folder / "case.toml")).state.radii), 2)
        case = frit.parse_case('[packing]\nfile = "packing.csv"\n' + PAIR, folder=self.folder)
        self.assertEqual(len(frit.Simulation(case).state.radii), 2)

    def test_matplotlib_is_imported_only_for_plots(self):
        code = "import sys, frit; sys.exit('matplotlib' in sys.modules)"
        self.assertEqual(subprocess.run([sys.executable, "-c", code]).returncode, 0)


def frit_program():
    from samples import PROGRAM
    return PROGRAM


if __name__ == "__main__":
    unittest.main()
