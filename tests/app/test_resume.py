"""Runs that are stopped by anything at any moment go on to the same bits."""

import concurrent.futures
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest

SHIM = os.environ.get("FRIT_SHIM", "")
# `tools/validate.py --long` asks for more kills, and for every call to fail instead of every fourth.
KILLS = int(os.environ.get("FRIT_KILLS", "20"))
STRIDE = 1 if "FRIT_KILLS" in os.environ else 4

# 120 steps of about a millisecond, each with a checkpoint, a row and a snapshot now and then.
CASE = """
[packing]
generate = "random-dense"
count = 30
[cell]
kind = "periodic"
stress = "-1 MPa"
[material]
use = "copper"
[method]
time_step = "0.05 s"
[stop]
time = "6 s"
[output]
every_steps = 7
report = false
checkpoint_every_steps = 1
"""


def bits(folder):
    """Every file of a result that does not tell the clock."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*"))
            if p.is_file() and p.name != "summary.json"}


class ResumeTest(ProgramTest):
    # In memory where there is such a place: hundreds of flushed files are slow on a busy disk.
    parent = "/dev/shm" if pathlib.Path("/dev/shm").is_dir() else None
    made = None  # the run that nothing interrupted, by name and bytes of its files; made once for all tests
    seconds = 0.0  # that it took: builds with sanitizers or gcov, and busy machines, are slower by far

    def setUp(self):
        super().setUp()
        self.write("case.toml", CASE)
        if ResumeTest.made is None:
            begin = time.monotonic()
            self.frit("run", "case.toml", "-o", "straight", "--quiet", "--threads", 1)
            ResumeTest.seconds = time.monotonic() - begin
            ResumeTest.made = {str(p.relative_to(self.folder)): p.read_bytes()
                               for p in sorted((self.folder / "straight").rglob("*")) if p.is_file()}
        for name, content in ResumeTest.made.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_bytes(content)
        self.straight = bits(self.folder / "straight")
        # In a coverage build a process that is killed, or may not write, would spoil the counts of all others.
        os.environ["GCOV_PREFIX"] = str(self.folder / "gcov")

    def tearDown(self):
        del os.environ["GCOV_PREFIX"]
        super().tearDown()

    def assert_same(self, folder):
        found = bits(folder)
        self.assertEqual(sorted(found), sorted(self.straight))
        for name, content in self.straight.items():
            self.assertEqual(found[name], content, name)

    def start(self, *arguments, **options):
        return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, **options)

    def end(self, process):
        out, err = process.communicate(timeout=120)
        return process.returncode, out, err

    def assert_machine_error(self, code, err):
        """Exit code 1 and one line that names what failed; no trace of a crash."""
        self.assertEqual(code, 1, err)
        lines = [line for line in err.splitlines() if "warning" not in line]
        self.assertEqual(len(lines), 1, err)
        self.assertTrue(lines[0].startswith("frit: "), err)

    def go_on(self, name):
        """Whatever is in the folder, on to the end; what the last good checkpoint holds is not done again."""
        if (self.folder / name / "checkpoint.cbor").exists() or (self.folder / name / "checkpoint.previous.cbor").exists():
            self.frit("resume", name, "--quiet")
        else:
            self.frit("run", "case.toml", "-o", name, "--force", "--quiet")
        self.assert_same(self.folder / name)


class Signals(ResumeTest):
    def test_int_and_term_end_with_a_checkpoint(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            name = f"out{code}"
            process = self.start("run", "case.toml", "-o", name, "--set", "method.time_step=0.001 s")
            while not (self.folder / name / "checkpoint.cbor").exists():
                time.sleep(0.002)
            process.send_signal(number)
            got, out, err = self.end(process)
            self.assertEqual(got, code, err)
            self.assertIn(f"stopped by signal {int(number)}", out)
            self.assertEqual(self.summary(name)["exit"]["code"], code)
            done = self.frit("resume", name, "--set", "stop.time=0.5 s")
            self.assertIn("goes on from", done.stdout)
            self.assertIsInstance(self.summary(name)["resumed_at_step"], int)

    def test_a_packing_under_way_is_given_up(self):
        """A packing of minutes, ended within seconds; the folder of an older result stays as it was."""
        large = ("--set", "packing.count=100000", "--set", "packing.relative_density=0.64")
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            process = self.start("run", "case.toml", "-o", "straight", "--force", *large)
            time.sleep(0.5)
            self.assertIsNone(process.poll(), "it had ended before")
            process.send_signal(number)
            begin = time.monotonic()
            got, _, err = self.end(process)
            self.assertLess(time.monotonic() - begin, max(10.0, 20.0 * self.seconds))
            self.assertEqual(got, code, err)
            self.assertIn(f"stopped by signal {int(number)} before the first step: the packing is not made; nothing is written", err)
            self.assert_same(self.folder / "straight")
        done = self.frit("run", "case.toml", "-o", "late", *large, "--max-wall", "0.5s", code=4)
        self.assertIn("stopped by --max-wall before the first step", done.stderr)
        self.assertFalse((self.folder / "late").exists())

    def test_usr1_takes_a_checkpoint_and_goes_on(self):
        process = self.start("run", "case.toml", "-o", "out", "--set", "output.checkpoint_every_steps=0",
                             "--set", "method.time_step=0.0005 s")
        while not (self.folder / "out" / "series.csv").exists():
            time.sleep(0.002)
        self.assertFalse((self.folder / "out" / "checkpoint.cbor").exists())
        process.send_signal(signal.SIGUSR1)
        for _ in range(2000):
            if (self.folder / "out" / "checkpoint.cbor").exists():
                break
            time.sleep(0.002)
        self.assertIsNone(process.poll(), "it had ended before")
        self.assertTrue((self.folder / "out" / "checkpoint.cbor").exists())
        process.kill()
        self.end(process)

    def test_max_wall_ends_with_four_and_goes_on(self):
        done = self.frit("run", "case.toml", "-o", "out", "--max-wall", "0.05s", "--quiet", code=4)
        self.assertEqual(done.stderr, "")
        self.frit("resume", "out", "--max-wall", "1h")
        self.assert_same(self.folder / "out")
        self.assert_fault(self.frit("run", "case.toml", "-o", "x", "--max-wall", "soon", code=2), "--max-wall", "11h50m")

    def test_a_finished_run_says_so(self):
        done = self.frit("resume", "straight")
        self.assertIn("the run is finished: stop.time is reached", done.stdout)
        self.assert_same(self.folder / "straight")

    def test_wrong_folders(self):
        self.assert_fault(self.frit("resume", "nowhere", code=2), "nowhere", "no such folder")
        self.assert_fault(self.frit("resume", "case.toml", code=2), "is a file")
        self.assert_fault(self.frit("resume", ".", code=2), "holds no checkpoint")
        self.assert_fault(self.frit("resume", "straight", "--set", "contact.pull=unilateral", code=2), "keys of [stop]")


class Kills(ResumeTest):
    def test_killed_at_random_moments(self):
        dice, kills, again = random.Random(6), 0, 0
        while kills < KILLS:
            again += 1
            name, has_checkpoint = f"killed{again}", False
            while True:
                arguments = ("resume", name) if has_checkpoint else ("run", "case.toml", "-o", name, "--force")
                process = self.start(*arguments, "--quiet")
                time.sleep(dice.uniform(0.0, max(0.1, 0.4 * self.seconds)))
                process.kill()
                code, _, err = self.end(process)
                kills += code == -signal.SIGKILL
                self.assertIn(code, (0, -signal.SIGKILL), err)
                there = {p.name for p in (self.folder / name).glob("checkpoint*")}
                self.assertTrue(there or not has_checkpoint, "a checkpoint was lost")
                has_checkpoint = bool(there)
                if code == 0:
                    break
            self.assert_same(self.folder / name)
        print(f"{kills} kills in {again} runs")


class Machine(ResumeTest):
    @unittest.skipUnless(SHIM, "needs the preloaded library")
    def test_every_call_that_fails_is_told_and_costs_nothing(self):
        steps = ("--set", "output.checkpoint_every_steps=20", "--set", "output.every_steps=30")
        self.frit("run", "case.toml", *steps, "-o", "short", "--quiet")
        self.straight = bits(self.folder / "short")

        def run(number, *arguments):
            environment = dict(os.environ, LD_PRELOAD=SHIM, FAIL_AT=str(number), COUNT_TO=str(self.folder / "count"))
            return self.end(self.start(*arguments, "--quiet", "--threads", 1, env=environment))

        self.assertEqual(run(0, "run", "case.toml", *steps, "-o", "counted")[0], 0)
        calls = int((self.folder / "count").read_text())
        self.assertGreater(calls, 50)

        def tear(number):
            name = f"torn{number}"
            code, _, err = run(number, "run", "case.toml", *steps, "-o", name)
            self.assert_machine_error(code, err)
            self.assertIn("No space left on device", err)
            self.assertIn(name, err)
            if (self.folder / name / "checkpoint.cbor").exists() or \
                    (self.folder / name / "checkpoint.previous.cbor").exists():
                code, _, err = run(2, "resume", name)  # once more
                self.assert_machine_error(code, err) if code else None
                self.frit("resume", name, "--quiet", "--threads", 1)
                self.assert_same(self.folder / name)
            shutil.rmtree(self.folder / name, ignore_errors=True)

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(tear, range(1, calls + 1, STRIDE)))
        print(f"{(calls - 1) // STRIDE + 1} of {calls} calls failed, one at a time")

    def test_a_limit_on_the_size_of_files(self):
        for kilobytes in (0, 1, 4, 16, 24):
            def limit():
                resource.setrlimit(resource.RLIMIT_FSIZE, (kilobytes * 1024, kilobytes * 1024))
            code, _, err = self.end(self.start("run", "case.toml", "-o", "out", "--force", preexec_fn=limit))
            self.assert_machine_error(code, err)
            self.assertIn("File too large", err)
            self.go_on("out")

    @unittest.skipUnless(SHIM, "a sanitizer takes all memory there is")
    def test_a_limit_on_memory(self):
        """From too little to load the program up to enough: an exit code and a line, never a crash."""
        codes = []
        for megabytes in range(16, 400, 4):
            def limit():
                resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
            code, _, err = self.end(self.start("run", "case.toml", "-o", "out", "--force", "--threads", 1, "--set",
                                               "packing.generate=face-centred-cubic", "--set", "packing.count=4000",
                                               "--set", "stop.time=0.2", "--quiet",
                                               preexec_fn=limit))
            if "shared libraries" in err:
                continue
            codes.append(code)
            if code == 0:
                break
            self.assert_machine_error(code, err)
            self.assertIn("memory", err)
        self.assertEqual(codes[-1], 0)
        self.assertGreater(len(codes), 5)

    @unittest.skipUnless(os.geteuid() == 0, "mounting needs root")
    def test_a_full_and_a_read_only_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "none", disk], capture_output=True).returncode:
            self.skipTest("mounting is not allowed here")
        try:
            stuffing = disk / "stuffing"
            stuffing.write_bytes(bytes((4 << 20) - 90_000))
            code, _, err = self.end(self.start("run", "case.toml", "-o", "disk/out", "--quiet"))
            self.assert_machine_error(code, err)
            self.assertIn("No space left on device", err)
            subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
            code, _, err = self.end(self.start("resume", "disk/out", "--quiet"))
            self.assert_machine_error(code, err)
            self.assertIn("Read-only file system", err)
            subprocess.run(["mount", "-o", "remount,rw", disk], check=True)
            stuffing.unlink()
            self.assertTrue(list((disk / "out").glob("checkpoint*.cbor")))
            self.go_on("disk/out")
        finally:
            subprocess.run(["umount", disk], check=True)


if __name__ == "__main__":
    unittest.main()
