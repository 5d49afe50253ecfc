"""Runs from Python: the same bits as the program, callbacks, views, interrupts."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy

import frit
from samples import CASE, PAIR, TOUCHING, FolderTest


class SameBits(FolderTest):
    def test_files_are_those_of_the_program(self):
        (self.folder / "case.toml").write_text(CASE)
        self.run_program("run", "case.toml", "-o", "program", "--threads", "1")
        frit.run(frit.load_case(self.folder / "case.toml"), self.folder / "module")
        ours = sorted(p.relative_to(self.folder / "module") for p in (self.folder / "module").rglob("*") if p.is_file())
        theirs = sorted(p.relative_to(self.folder / "program") for p in (self.folder / "program").rglob("*") if p.is_file())
        self.assertEqual(ours, theirs)
        self.assertGreater(len(ours), 8)
        for name in ours:
            if name.name in ("summary.json", "report.html"):  # they tell times and names
                continue
            self.assertEqual((self.folder / "module" / name).read_bytes(), (self.folder / "program" / name).read_bytes(), name)

    def test_steps_and_threads_do_not_change_the_result(self):
        case = frit.parse_case(CASE)
        whole = frit.run(case)
        try:
            frit.set_threads(1)
            stepped = frit.Simulation(case)
            while stepped.step():
                stepped.state.positions  # looking must not disturb
        finally:
            frit.set_threads(0)
        for name, values in whole.series.items():
            self.assertEqual(values.tobytes(), stepped.series[name].tobytes(), name)
        self.assertEqual(whole.state.positions.tobytes(), stepped.state.positions.tobytes())
        self.assertEqual(whole.state.neck_radii.tobytes(), stepped.state.neck_radii.tobytes())


class Driving(FolderTest):
    def setUp(self):
        super().setUp()
        self.case = frit.parse_case(PAIR, {"output.every_time": 20}, packing=TOUCHING)

    def test_two_spheres_follow_the_closed_form(self):
        run = frit.run(self.case)
        delta_b = run.state.theta / run.state.time
        tau = run.state.time * 1.72 * delta_b / 5e-6**4
        self.assertAlmostEqual(run.state.neck_ratios[0] ** 6, 0.05**6 + 54 * tau, delta=1e-4 * 54 * tau)
        self.assertEqual(run.ending, (0, "stop.time is reached"))

    def test_callbacks_are_told_of_each_step_and_row(self):
        steps, rows = [], []
        run = frit.run(self.case, on_step=lambda s: steps.append(s.state.time), on_row=lambda s: rows.append(s.row["time"]))
        self.assertEqual(rows, [0, 20, 40, 60])
        self.assertEqual(rows, list(run.series["time"]))
        self.assertEqual(len(steps), run.counts["steps"])
        self.assertEqual(steps[-1], 60)
        self.assertEqual(steps, sorted(set(steps)))

    def test_an_exception_of_a_callback_leaves_the_run_where_it_is(self):
        simulation = frit.Simulation(self.case)

        def complain(run):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            simulation.run(on_step=complain)
        self.assertEqual(simulation.counts["steps"], 1)
        simulation.run()
        self.assertEqual(simulation.series["neck_ratio_mean"].tobytes(),
                         frit.run(self.case).series["neck_ratio_mean"].tobytes())

    def test_stop_writes_the_last_row_and_the_summary(self):
        with frit.Simulation(self.case, self.folder / "out") as simulation:
            simulation.step()
        result = frit.read_result(self.folder / "out")
        self.assertEqual(simulation.ending, (4, "stopped by the caller"))
        self.assertEqual(result.series["time"][-1], simulation.state.time)
        self.assertLess(simulation.state.time, 60)
        self.assertEqual(result.summary["steps"], 1)
        self.assertFalse(simulation.step())

    def test_a_packing_from_arrays_can_be_run_again_from_its_folder(self):
        frit.run(self.case, self.folder / "out")
        self.run_program("run", "out/case.toml", "-o", "again")
        self.assertEqual((self.folder / "out/series.csv").read_bytes(), (self.folder / "again/series.csv").read_bytes())

    def test_contacts_and_necks_from_arrays(self):
        packing = frit.Packing([[0, 0, 0], [1e-5, 0, 0], [2e-5, 0, 0]], [5e-6] * 3, contacts=[[2, 1]], neck_radii=[1e-6])
        state = frit.Simulation(frit.parse_case(PAIR, {"contact.initial_neck_ratio": 0}, packing=packing)).state
        self.assertEqual([(1, 2)], list(zip(state.contact_i, state.contact_j)))
        self.assertAlmostEqual(state.neck_radii[0], 1e-6, delta=1e-20)

    def test_a_periodic_packing_from_arrays(self):
        grid = numpy.stack(numpy.meshgrid(*[numpy.arange(3) * 1e-5] * 3, indexing="ij"), -1).reshape(-1, 3)
        case = frit.parse_case(PAIR, packing=frit.Packing(grid, 5e-6, size=[3e-5] * 3))
        run = frit.run(case)
        self.assertEqual(len(run.state.neck_radii), 81)  # simple cubic: 3 contacts a particle
        self.assertLess(run.state.cell_size[0], 3e-5)
        self.assertAlmostEqual(run.state.relative_density, 27 * 4 / 3 * numpy.pi * 5e-6**3 / run.state.cell_size.prod(), 12)

    def test_a_run_that_cannot_be_computed_is_warned_of(self):
        case = self.case.with_overrides({"temperature.start": 1})
        with self.assertWarnsRegex(RuntimeWarning, "nothing diffuses"):
            self.assertEqual(frit.run(case).ending.code, 3)


class Views(unittest.TestCase):
    def setUp(self):
        self.simulation = frit.Simulation(frit.parse_case(PAIR, packing=TOUCHING))

    def test_arrays_are_views_without_copies(self):
        state = self.simulation.state
        for name in ("positions", "radii", "orientations", "ids", "contact_images", "neck_radii"):
            first, second = getattr(state, name), getattr(state, name)
            self.assertEqual(first.__array_interface__["data"][0], second.__array_interface__["data"][0], name)
            self.assertFalse(first.flags.owndata, name)
            self.assertIs(first.base, state, name)
            with self.assertRaises(ValueError):
                first[0] = 0
        self.assertEqual(state.positions.shape, (2, 3))
        self.assertEqual(state.orientations.tolist(), [[0, 0, 0, 1]] * 2)

    def test_a_view_outlives_state_simulation_and_steps(self):
        positions = self.simulation.state.positions
        necks = self.simulation.state.neck_radii
        before, neck = positions.copy(), necks[0]
        while self.simulation.step():
            pass
        self.assertFalse(numpy.array_equal(self.simulation.state.positions, before))
        del self.simulation
        gc.collect()
        junk = [numpy.full((2, 3), 7.0) for _ in range(1000)]  # would take freed memory
        self.assertTrue(numpy.array_equal(positions, before))
        self.assertEqual(necks[0], neck)
        del junk

    def test_the_state_is_the_same_object_until_the_next_step(self):
        state = self.simulation.state
        self.assertIs(state, self.simulation.state)
        self.simulation.step()
        self.assertIsNot(state, self.simulation.state)
        self.assertEqual(state.time, 0)


class OtherThreads(unittest.TestCase):
    def test_the_interpreter_is_free_while_frit_computes(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        simulation = frit.Simulation(frit.parse_case(CASE, {"packing.count": 4000}))
        other = threading.Thread(target=tick)
        other.start()
        begin = time.monotonic()
        simulation.step()
        end = time.monotonic()
        done.set()
        other.join()
        during = sum(begin < t < end for t in ticks)
        self.assertGreater(during, 5, f"in {end - begin} s")  # one or two slip in at the end of a step that holds the GIL

    def test_several_threads_may_look_and_step(self):
        simulation = frit.Simulation(frit.parse_case(CASE, {"stop.relative_density": 0.66}))
        seen = []

        def look():
            while simulation.ending is None:
                state = simulation.state
                seen.append(len(state.contact_i) == len(state.neck_radii))

        others = [threading.Thread(target=look) for _ in range(3)]
        for other in others:
            other.start()
        simulation.run()
        for other in others:
            other.join()
        self.assertTrue(seen and all(seen))


class Interrupts(FolderTest):
    SCRIPT = """
import sys, frit
case = frit.load_case("case.toml")
with frit.Simulation(case, "out") as simulation:
    try:
        simulation.run(on_step=lambda run: print("step", flush=True))
    except KeyboardInterrupt:
        print("interrupted after", simulation.counts["steps"])
        raise
"""

    def test_control_c_ends_the_run_after_its_step(self):
        (self.folder / "case.toml").write_text(CASE + "[method]\ntime_step = 1e-4\n")  # far from its end
        process = subprocess.Popen([sys.executable, "-c", self.SCRIPT], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "step\n")
        os.kill(process.pid, signal.SIGINT)
        out, errors = process.communicate(timeout=60)
        self.assertIn("interrupted after", out)
        self.assertIn("KeyboardInterrupt", errors)
        result = frit.read_result(self.folder / "out")
        self.assertEqual(result.summary["exit"]["code"], 130)
        self.assertEqual(result.summary["steps"], result.series["steps"][-1])


if __name__ == "__main__":
    unittest.main()
