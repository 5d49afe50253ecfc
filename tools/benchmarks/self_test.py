"""Tests of the benchmarks' own arithmetic, with closed forms: `./dev bench --self-test`."""
import csv
import json
import math
import pathlib
import tempfile
import unittest
from unittest import mock

from validation import law

from . import bandwidth, cases, curves, ledger, measure, peers, profiling, starts, tables


def rows_of(density_of_time, times):
    return [{"time [s]": t, "relative_density": density_of_time(t), curves.PAIR_RATIO: 1 / density_of_time(t) if t else math.nan}
            for t in times]


def root_law(late=1.0):
    """Densification with the cube root of time, from 0.62 to 0.87 in 2000 s, a factor `late` later."""
    return rows_of(lambda t: 0.62 + 0.25 * (t / (2000 * late)) ** (1 / 3), [0.0] + [2000 * late * (n / 25) ** 3 for n in range(1, 26)])


class Curves(unittest.TestCase):
    def test_time_to_density_is_that_of_the_law(self):
        for density in curves.DENSITIES:
            exact = 2000 * ((density - 0.62) / 0.25) ** 3
            self.assertAlmostEqual(curves.figures_at(root_law(), density)["time [s]"] / exact, 1, delta=2e-3)

    def test_interpolation_is_exact_at_a_row_and_for_cubics(self):
        rows = root_law()
        self.assertAlmostEqual(curves.figures_at(rows, rows[9]["relative_density"])["time [s]"], rows[9]["time [s]"], places=9)
        self.assertAlmostEqual(curves.cubic([(x, x**3 - x) for x in (0, 1, 3, 4)], 2.5), 2.5**3 - 2.5)

    def test_no_value_outside_the_run(self):
        self.assertIsNone(curves.figures_at(root_law(), 0.88))
        self.assertIsNone(curves.figures_at(root_law(), 0.61))

    def test_a_later_run_differs_by_its_lateness(self):
        compared = curves.differences(root_law(late=1.03), root_law())
        self.assertEqual(list(compared), ["0.70", "0.80", "0.87"])
        for figures in compared.values():
            self.assertAlmostEqual(figures["time [s]"], 3.0, places=3)
            self.assertAlmostEqual(figures[curves.PAIR_RATIO], 0.0, places=3)


class Peers(unittest.TestCase):
    def test_limit_meets_its_two_points(self):
        self.assertAlmostEqual(peers.stability_limit(0.2), 0.28)
        self.assertAlmostEqual(peers.stability_limit(0.05), 0.017)
        self.assertEqual(peers.stability_limit(0.6), 0.28)

    def test_step_of_copper_at_a_neck_of_0_3(self):
        self.assertAlmostEqual(peers.longest_explicit_step(0.3, 5e-6, 1.0) / 0.28, 5.6e-16, delta=0.05e-16)

    def test_steps_are_the_integral_of_the_law(self):
        # x^6 = 54 tau: the rate goes with t^(2/3), whose integral is 3/5 of its end value times time.
        times = [100 * n / 2000 for n in range(2001)]
        rows = [{"time [s]": t, "neck_ratio_mean": max(0.2, law.neck_of_tau(t / law.time_scale()))} for t in times]
        start, end = law.tau_of_neck(0.2) * law.time_scale(), 100.0
        rate = 1 / peers.longest_explicit_step(law.neck_of_tau(end / law.time_scale()), law.RADIUS, 1.0)
        exact = 0.6 * rate * (end - start * (start / end) ** (2 / 3)) + start / peers.longest_explicit_step(0.2, law.RADIUS, 1.0)
        self.assertAlmostEqual(peers.explicit_steps(rows, law.RADIUS, 1.0) / exact, 1, delta=1e-3)

    def test_steps_go_down_with_the_density_factor(self):
        rows = [{"time [s]": t, "neck_ratio_mean": 0.3} for t in (0.0, 1.0)]
        self.assertAlmostEqual(peers.explicit_steps(rows, 5e-6, 1.0) / peers.explicit_steps(rows, 5e-6, 1e12), 1e12, delta=1e3)

    def test_sparing_factor_inverts_the_inertial_neck(self):
        # Published with the law: x_c = 0.105 at a factor of 1e12, 0.053 at 1e9 (copper, 5 um, 1050 degC).
        for factor, inertial_neck in ((1e12, 0.105), (1e9, 0.053)):
            found = peers.sparing_factor(inertial_neck / peers.SPARED_SHARE, 5e-6)
            self.assertAlmostEqual((found / factor) ** 0.1, 1, delta=0.01)


class Roofline(unittest.TestCase):
    TRIAD = [{"MiB": 4, "threads": 1, "GB/s": 40.0}, {"MiB": 4, "threads": 2, "GB/s": 80.0}, {"MiB": 1024, "threads": 2, "GB/s": 10.0}]

    def test_bandwidth_is_that_of_the_nearest_size_and_threads(self):
        self.assertEqual(bandwidth.bandwidth_for(self.TRIAD, 3 * 2**20, 1), 40e9)
        self.assertEqual(bandwidth.bandwidth_for(self.TRIAD, 900 * 2**20, 1), 10e9)

    def test_time_is_bytes_over_bandwidth(self):
        entry = {"particles": 1000, "threads": 2, "median": {"contacts": 3000, "linear": 5000, "step wall [s]": 1.0}}
        told = bandwidth.roofline(entry, self.TRIAD)
        self.assertAlmostEqual(told["time at bandwidth [s]"], 5000 * (1000 * 536 + 3000 * 1.15 * 48) / 80e9)
        self.assertAlmostEqual(told["share"], told["time at bandwidth [s]"])


class Names(unittest.TestCase):
    def test_names_are_unique_and_patterns_choose(self):
        every = cases.named_cases()
        self.assertEqual(len({case.name for case in every}), len(every))
        self.assertEqual([case.particles for case in cases.select(every, ["periodic-1*k"])], [1_000, 10_000, 100_000])
        with self.assertRaises(ValueError):
            cases.select(every, ["no-such-case"])

    def test_every_size_and_sliding_resistance_is_there(self):
        scaling = {(case.particles, case.sliding_resistance) for case in cases.named_cases() if case.start is cases.Start.GENERATED}
        self.assertEqual(len(scaling), 16)


class StubResult:
    """The last state of a run: a chain of spheres with falling ids, a neck between neighbours."""

    def __init__(self, count):
        ids = list(range(count - 1, -1, -1))
        centres = [(1.99e-5 * number, 0.0, 0.0) for number in ids]
        self.arrays = {
            "particles": {"id": ids, "Points": centres, "radius": [1e-5 + 1e-9 * number for number in ids], "CellSize": [(1.0, 2.0, 3.0)]},
            "contacts": {"i": list(range(count - 1)), "j": list(range(1, count)), "neck_radius [m]": [1e-6 * n for n in range(1, count)]},
        }

    def snapshot(self, kind):
        return self.arrays[kind]


class StubWorkshop:
    """Makes folders and hands out a state without running the program."""

    def __init__(self, folder, spheres):
        self.folder, self.spheres, self.count, self.calls = pathlib.Path(folder), spheres, 0, 0

    def new_folder(self):
        self.count += 1
        folder = self.folder / str(self.count)
        folder.mkdir()
        return folder

    def call(self, command, _longest):
        self.calls += 1
        rows = [f"{n},{x!r},{y!r},{z!r},{radius!r}" for n, (x, y, z, radius) in enumerate(self.spheres)]
        command[-1].write_text("\n".join(["id,x [m],y [m],z [m],radius [m]", *rows]) + "\n", encoding="utf-8")

    def run(self, _case, **_):
        return StubResult(len(self.spheres))


def necks_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [(int(row["i"]), int(row["j"]), float(row["neck_radius"])) for row in csv.DictReader(file)]


def radii_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [float(row["radius"]) for row in csv.DictReader(file)]


class StartingStates(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def starts_of(self, spheres):
        self.workshop = StubWorkshop(self.folder.name, spheres)
        return starts.Starts(self.workshop, 1)

    def chain(self, count=31):
        return [(1.99e-5 * n, 0.0, 0.0, 1e-5) for n in range(count)]

    def test_loose_keeps_two_thirds_of_the_necks_and_no_overlap(self):
        made = self.starts_of(self.chain()).of(cases.BenchCase("x", cases.Start.LOOSE, 31))
        necks = necks_of(made.contacts)
        self.assertEqual(len(necks), 20)
        self.assertTrue(all(j == i + 1 and radius == 1e-6 * j for i, j, radius in necks))
        self.assertTrue(all(2 * radius < 1.99e-5 for radius in radii_of(made.packing)))

    def test_dense_brings_cell_and_necks_by_row(self):
        made = self.starts_of(self.chain()).of(cases.BenchCase("x", cases.Start.DENSE, 31, cell="periodic"))
        self.assertEqual(made.size, [1.0, 2.0, 3.0])
        radii = radii_of(made.packing)
        # Rows are in the order of the snapshot (falling ids), so a neck of ids n and n + 1 joins rows 30 - n and 29 - n.
        self.assertAlmostEqual(radii[0], 1e-5 + 30e-9)
        self.assertEqual(necks_of(made.contacts)[0], (30, 29, 1e-6))

    def test_wide_ends_at_the_ratio_of_ten(self):
        spheres = [(float(n), 0.0, 0.0, radius) for n, radius in enumerate((1e-5, 0.99e-6, 1.01e-6, 4e-6))]
        made = self.starts_of(spheres).of(cases.BenchCase("x", cases.Start.RADIUS_RATIO_10, 4))
        self.assertEqual(radii_of(made.packing), [1e-5, 1.01e-6, 4e-6])

    def test_periodic_cell_has_the_generated_density(self):
        made = self.starts_of(self.chain()).of(cases.BenchCase("x", cases.Start.GENERATED, 31, cell="periodic"))
        self.assertAlmostEqual(31 * 4 / 3 * math.pi * 1e-15 / math.prod(made.size), starts.GENERATED_DENSITY)

    def test_a_start_is_made_once(self):
        states = self.starts_of(self.chain())
        for sliding_resistance in (0.0, 0.1):
            states.of(cases.BenchCase("x", cases.Start.GENERATED, 31, sliding_resistance=sliding_resistance))
        self.assertEqual(self.workshop.calls, 1)


class Figures(unittest.TestCase):
    def test_per_particle_and_step(self):
        summary = {"particles": 1000, "steps": 20, "rejected_steps": 1, "newton_iterations": 200, "solver_iterations": 4000,
                   "peak_memory_bytes": 5_000_000, "wall_s": {"setup": 0.1, "step": 0.4}, "cpu_s": {"step": 0.5}}
        figures = measure.figures_of(summary, [{"contacts": 3000}, {"contacts": 4000}], 0.7, 0.9)
        self.assertAlmostEqual(figures["cpu per particle-step [us]"], 25)
        self.assertAlmostEqual(figures["wall per step [s]"], 0.02)
        self.assertEqual((figures["bytes per particle"], figures["contacts"], figures["wall [s]"]), (5000, 3500, 0.7))

    def test_ledger_keeps_what_was_measured_before(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(ledger, "PATH", pathlib.Path(folder) / "results/bench.json"):
            self.assertEqual(ledger.load(), {"cases": {}})
            ledger.save({"cases": {"a": {"failed": "x"}}, "peers": {}})
            self.assertEqual(ledger.load(), {"cases": {"a": {"failed": "x"}}, "peers": {}})
            ledger.PATH.write_text(json.dumps({"cases": [{"name": "of an older form"}]}), encoding="utf-8")
            self.assertEqual(ledger.load(), {"cases": {}})


class Text(unittest.TestCase):
    def test_functions_of_a_profile(self):
        line = " 1,234 ( 5.60%)  ???:frit::solve::(anonymous namespace)::Update::run<int, a<b> >(std::span<double>) const [/x/frit]"
        self.assertEqual(profiling.parse("1,234 (100.0%)  PROGRAM TOTALS\n" + line),
                         [{"function": "solve::Update::run", "instructions": 1234, "share [%]": 5.6}])

    def test_pending_and_failed_cases_fill_their_row(self):
        text = tables.case_table({"cases": {"b": {"failed": "exit code 3"}}}, ["a", "b"])
        rows = text.splitlines()
        self.assertIn(tables.PENDING, rows[2])
        self.assertIn("failed: exit code 3", rows[3])
        self.assertEqual({row.count("|") for row in rows}, {rows[0].count("|")})

    def test_packing_for_the_peer_has_diameters_and_a_box_around_all(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "packing.data"
            peers.write_data(path, [(0.0, 0.0, 0.0, 5e-6), (0.0, -1e-5, 0.0, 5e-6)])
            lines = path.read_text(encoding="utf-8").splitlines()
        self.assertIn("1 1 1e-05 8960.0 0.0 0.0 0.0", lines)
        low, high = (float(number) for number in next(line for line in lines if line.endswith("ylo yhi")).split()[:2])
        self.assertTrue(low < -1.5e-5 and high > 1.5e-5)

    def test_solid_volume(self):
        self.assertAlmostEqual(starts.solid_volume([(0, 0, 0, 1.0), (5, 0, 0, 2.0)]), 9 * 4 / 3 * math.pi)


def run():
    """0 if every test passes, else 1."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(__import__(__name__, fromlist=["run"]))
    return 0 if unittest.TextTestRunner().run(suite).wasSuccessful() else 1
