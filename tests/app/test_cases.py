"""Every case of the cases folder is in order, and the small ones give their known answers."""

import math
import unittest

from program import CASES, ProgramTest

GAMMA, RADIUS, DELTA_B = 1.72, 5e-6, 2.36812e-28
SCALE = RADIUS**4 / (GAMMA * DELTA_B)
SMALL = ["two-spheres", "two-spheres-unequal", "two-spheres-equilibrium", "two-spheres-parhami", "two-spheres-load",
         "chain", "simple-cubic", "body-centred-cubic", "face-centred-cubic"]


def free_neck(start, tau):
    return (start**6 + 54.0 * tau) ** (1.0 / 6.0)


class Cases(ProgramTest):
    def run_case(self, name):
        self.frit("run", CASES / name / "case.toml", "-o", name, "--quiet", "--threads", 1,
                  "--set", "output.snapshots=false")
        return {key: [float(text or "nan") for text in column] for key, column in self.series(name).items()}

    def check_necks(self, name, expected, tolerance=1e-4):
        series = self.run_case(name)
        for time, neck in zip(series["time [s]"], series["neck_ratio_mean"]):
            self.assertTrue(math.isclose(neck, expected(time), rel_tol=tolerance), f"{name} at {time} s: {neck}")

    def test_every_small_case_is_known(self):
        folders = sorted(path.name for path in CASES.iterdir() if (path / "case.toml").exists())
        self.assertEqual(folders, sorted(SMALL + ["copper", "mean-field", "free-ball", "heating"]))

    def test_every_case_is_in_order(self):
        for name in SMALL + ["heating"]:
            self.frit("check", CASES / name / "case.toml")

    def test_two_spheres(self):
        self.check_necks("two-spheres", lambda t: free_neck(0.05, t / SCALE))

    def test_two_unequal_spheres(self):
        scale = SCALE * (2.0 / 3.0) ** 4  # R = 10/3 um
        self.check_necks("two-spheres-unequal", lambda t: free_neck(0.05, t / scale))

    def test_equilibrium(self):
        largest = math.sin(math.radians(73.0))
        self.check_necks("two-spheres-equilibrium", lambda t: min(largest, free_neck(0.05, t / SCALE)))

    def test_the_other_attraction(self):
        series = self.run_case("two-spheres-parhami")
        self.assertAlmostEqual(series["neck_ratio_mean"][-1], 0.5, delta=1e-3)

    def test_load(self):
        share = 1.0 + 1e-4 / (9.0 / 8.0 * math.pi * RADIUS * GAMMA)
        self.check_necks("two-spheres-load", lambda t: free_neck(0.05, share * t / SCALE))

    def test_chain(self):
        self.check_necks("chain", lambda t: free_neck(0.05, t / SCALE))

    def test_lattices(self):
        first = {"simple-cubic": math.pi / 6, "body-centred-cubic": math.pi * math.sqrt(3) / 8,
                 "face-centred-cubic": math.pi / (3 * math.sqrt(2))}
        for name, density in first.items():
            series = self.run_case(name)
            for neck, value in zip(series["neck_ratio_mean"], series["relative_density"]):
                self.assertAlmostEqual(value, density * (1 - neck**2 / 4) ** -3, delta=1e-6, msg=name)
            if name == "simple-cubic":
                self.assertAlmostEqual(series["time [s]"][-1] / SCALE / 5.343e-3, 1.0, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
