"""Right input: what the subcommands and options do."""

import json
import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest


class Texts(ProgramTest):
    def test_version_and_help(self):
        self.assertRegex(self.frit("--version").stdout, r"^frit \d+\.\d+\.\d+\n$")
        for command in ("run", "check", "describe", "materials", "pack", "convert", "replay"):
            self.assertIn(command, self.frit("--help").stdout)
            self.assertIn("--help", self.frit(command, "--help").stdout)

    def test_describe_and_materials(self):
        self.assertIn("contact.pull", self.frit("describe").stdout)
        self.assertIn("unilateral", self.frit("describe", "contact.pull").stdout)
        materials = self.frit("materials").stdout
        for word in ("copper", "Swinkels"):
            self.assertIn(word, materials)

    def test_check_tells_what_follows_and_writes_nothing(self):
        text = self.frit("check", "pair.toml").stdout
        for word in ("time scale", "f_a", "m/c_n", "particles", "coordination", "relative density", "1.534",
                     "sliding_resistance"):
            self.assertIn(word, text)
        self.assertEqual(self.names(), [])

    def test_check_warns(self):
        self.write("packing.csv", "x,y,z,radius\n0,0,0,2.5e-6\n7.5e-6,0,0,5e-6\n")
        self.assertIn("warning: contact.equilibrium_radius", self.frit("check", "pair.toml").stdout)
        self.assertIn("frit: warning", self.frit("run", "pair.toml").stderr)
        self.assertEqual(len(self.summary("pair")["warnings"]), 1)


class Running(ProgramTest):
    def test_the_folder_is_named_after_the_case(self):
        self.frit("run", "pair.toml")
        self.assertEqual(self.names(), ["pair"])
        files = sorted(p.name for p in (self.folder / "pair").iterdir())
        self.assertEqual(files, ["case.toml", "checkpoint.cbor", "report.html", "series.csv", "snapshots", "snapshots.pvd", "summary.json"])

    def test_results_are_replaced_only_by_force(self):
        self.frit("run", "pair.toml", "-o", "out")
        before = (self.folder / "out" / "series.csv").read_bytes()
        self.assert_fault(self.frit("run", "pair.toml", "-o", "out", "--set", "stop.time=20", code=2), "--force")
        self.assertEqual((self.folder / "out" / "series.csv").read_bytes(), before)
        self.frit("run", "pair.toml", "-o", "out", "--force", "--set", "stop.time=20")
        self.assertEqual(self.series("out")["time [s]"], ["0", "10", "20"])
        self.assertEqual(len(list((self.folder / "out" / "snapshots").iterdir())), 6)

    def test_overrides_may_stand_before_the_case_and_be_repeated(self):
        self.frit("run", "--set", "stop.time=20 s", "--set", "output.every_time=5", "pair.toml", "-o", "out")
        self.assertEqual(self.series("out")["time [s]"], ["0", "5", "10", "15", "20"])

    def test_json_lines(self):
        lines = [json.loads(line) for line in self.frit("run", "pair.toml", "--json").stdout.splitlines()]
        self.assertEqual([line["event"] for line in lines], ["started"] + ["row"] * 7 + ["finished"])
        self.assertEqual(lines[-1]["code"], 0)
        self.assertEqual([line["row"]["time [s]"] for line in lines[1:-1]], [10.0 * n for n in range(7)])

    def test_plain_lines_and_quiet(self):
        done = self.frit("run", "pair.toml")
        self.assertEqual(sum(line.startswith("time ") for line in done.stdout.splitlines()), 7)
        self.assertNotIn("\r", done.stdout)
        done = self.frit("run", "pair.toml", "--quiet", "-o", "out")
        self.assertEqual(done.stdout + done.stderr, "")

    def test_a_bar_on_a_terminal(self):
        leader, follower = os.openpty()
        program = subprocess.Popen([PROGRAM, "run", "lattice.toml", "--set", "output.snapshots=false"],
                                   cwd=self.folder, stdout=follower, stderr=follower)
        os.close(follower)
        text = b""
        try:
            while chunk := os.read(leader, 4096):
                text += chunk
        except OSError:  # the other end is closed
            pass
        os.close(leader)
        self.assertEqual(program.wait(), 0)
        self.assertIn(b"stop.relative_density is reached", text)
        self.assertNotIn(b"time 0 s", text)

    def test_what_cannot_be_computed_is_exit_code_3(self):
        done = self.frit("run", "pair.toml", "--set", "temperature.start=1 K", code=3)
        self.assert_fault(done, "nothing diffuses")
        self.assertEqual(self.summary("pair")["exit"]["code"], 3)

    def test_a_problem_that_fails_can_be_replayed(self):
        self.frit("run", "lattice.toml", "--set", "packing.generate=random-dense", "--set", "packing.count=100",
                  "--set", "stop.relative_density=0.9",
                  "--set", "method.tolerance=1e-17", "--set", "method.smallest_step=1e-3", "-o", "out", code=3)
        dump = self.folder / "out" / "failed_problem.cbor"
        self.assertIn("did not converge", self.frit("replay", dump, "--tolerance", "1e-17", code=3).stdout)
        for solver in ("auto", "gauss-seidel"):
            text = self.frit("replay", dump, "--solver", solver, "--tolerance", "1e-4").stdout
            self.assertIn("converged", text)
            self.assertIn("residual", text)


class Signals(ProgramTest):
    LONG = ("run", "pair.toml", "--set", "method.time_step=1e-4", "--set", "output.every_time=1", "-o", "out",
            "--force")

    def start(self):
        program = subprocess.Popen([PROGRAM, *self.LONG], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        program.stdout.readline()
        return program

    def test_the_first_signal_ends_the_run_with_its_results(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            program = self.start()
            time.sleep(0.2)
            program.send_signal(number)
            program.communicate(timeout=60)
            self.assertEqual(program.returncode, code)
            summary = self.summary("out")
            self.assertEqual(summary["exit"]["code"], code)
            series = self.series("out")
            self.assertEqual(float(series["time [s]"][-1]), summary["final"]["time [s]"])
            self.assertLess(summary["final"]["time [s]"], 60.0)

    def test_a_closed_pipe_does_not_end_the_run(self):
        program = subprocess.Popen([PROGRAM, "run", "pair.toml"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        program.stdout.close()
        self.assertIn(program.wait(timeout=60), (0, 1))
        program.stderr.close()
        self.assertEqual(self.summary("pair")["exit"]["code"], 0)


class Machine(ProgramTest):
    def test_a_folder_that_cannot_be_made_is_exit_code_1(self):
        self.write("file", "")
        done = self.frit("run", "pair.toml", "-o", "file/out", code=1)
        self.assert_fault(done, "file/out", "making the folder")

    def test_a_full_disk_is_exit_code_1_and_says_what_to_do(self):
        done = subprocess.run(["/bin/sh", "-c", f"ulimit -f 2; exec '{PROGRAM}' run pair.toml --set output.every_time=0.05"],
                              cwd=self.folder, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assert_fault(done, "writing", "disk space")


if __name__ == "__main__":
    unittest.main()
