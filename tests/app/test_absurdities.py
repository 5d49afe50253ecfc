"""Sizes and absurdities: an answer, or the reason why there is none; never a crash, a wrong answer or no end."""

import math
import random
import unittest

from program import ProgramTest

R = 5e-6
PAIR = [(0.0, 0.0, 0.0, R), (2 * R, 0.0, 0.0, R)]


def cubic(*counts):
    nx, ny, nz = counts
    return [(2 * R * i, 2 * R * j, 2 * R * k, R) for i in range(nx) for j in range(ny) for k in range(nz)]


def periodic(size, more=""):
    return f'[cell]\nkind = "periodic"\nsize = [{size}, {size}, {size}]\n{more}'


class Absurdities(ProgramTest):
    def outcome(self, spheres, *sets, stop="time = 60", more="", code=0, threads=1):
        """Runs the case for 60 s at 1050 degC; what it said on standard error."""
        lines = "".join(",".join(map(repr, sphere)) + "\n" for sphere in spheres)
        self.write("packing.csv", "x,y,z,radius\n" + lines)
        self.write("case.toml", '[packing]\nfile = "packing.csv"\n[material]\nuse = "copper"\n[output]\n'
                                f"report = false\n[stop]\n{stop}\n{more}")
        overrides = [word for key in sets for word in ("--set", key)]
        return self.frit("run", "case.toml", "-o", "out", "--force", "--quiet", "--threads", threads, *overrides,
                         code=code)

    def neck(self):
        return float(self.series("out")["neck_ratio_mean"][-1])

    def test_few_particles(self):
        self.assert_fault(self.outcome([], code=2), "no particles")
        self.assert_fault(self.outcome(PAIR[:1], code=2), "no two particles touch")
        self.outcome(PAIR)
        self.assertAlmostEqual(self.neck(), 0.358179, 5)  # x^6 = x0^6 + 54 tau
        self.assert_fault(self.outcome([PAIR[0], (5 * R, 0.0, 0.0, R)], code=2), "no two particles touch")

    def test_every_neck_of_a_line_and_a_plane_grows_as_that_of_a_pair(self):
        for spheres in (cubic(20, 1, 1), cubic(8, 8, 1), PAIR + [(x + 1e-3, y, z, r) for x, y, z, r in PAIR]):
            for eta in (0, 0.01):
                self.outcome(spheres, f"contact.sliding_resistance={eta}")
                self.assertAlmostEqual(self.neck(), 0.358179, 5)
        self.assert_fault(self.outcome(cubic(12, 12, 1), stop="relative_density = 0.9", code=2), "has no volume")

    def test_radii_over_four_decades(self):
        for seed in (4, 6, 8):
            dice, x, line = random.Random(seed), 0.0, []
            for _ in range(60):
                radius = 10 ** dice.uniform(-9, -5)
                line.append((x + radius, 0.0, 0.0, radius))
                x += 2 * radius
            self.outcome(line)
            self.assertLess(float(self.series("out")["steps"][-1]), 500)
        ring = [(1.0001e-4 * math.cos(0.3 * k), 1.0001e-4 * math.sin(0.3 * k), 0.0, 1e-8) for k in range(20)]
        self.outcome([(0.0, 0.0, 0.0, 1e-4)] + ring)
        self.assertEqual(float(self.series("out")["contacts"][-1]), 20)

    def test_places(self):
        self.assert_fault(self.outcome([PAIR[0], PAIR[0]], code=2), "already the centre")
        self.assert_fault(self.outcome([PAIR[0], (0.1 * R, 0.0, 0.0, R)], code=2), "inside the other")
        self.assert_fault(self.outcome([(1e10 + x, y, z, r) for x, y, z, r in PAIR], code=2), "too large for a radius")
        self.outcome([(1.0 + x, y, z, r) for x, y, z, r in PAIR])
        self.assertAlmostEqual(self.neck(), 0.358179, 5)
        self.assert_fault(self.outcome(PAIR[:1], more=periodic(R), code=2), "smaller than the largest particle")
        far = [(0.0, 0.0, 0.0, R), (2 * R, 0.0, 0.0, R)]
        self.outcome([far[0], (far[1][0] + 7 * 50e-6, -3 * 50e-6, 0.0, R)], more=periodic(50e-6))
        self.assertAlmostEqual(self.neck(), 0.358179, 5)  # cells away is the same place

    def test_temperatures(self):
        self.assert_fault(self.outcome(PAIR, "temperature.start=0 K", code=2), "above 0 K")
        self.assert_fault(self.outcome(PAIR, "temperature.start=1 K", code=3), "nothing diffuses")

    def test_times(self):
        for time, neck in (("1e-20", 0.03), ("1e20", math.sin(math.radians(73)))):
            self.outcome(PAIR, f"stop.time={time}")
            self.assertAlmostEqual(self.neck(), neck, 6)
        self.assert_fault(self.outcome(PAIR, "method.time_step=1e-20", code=2), "method.time_step", "6e+21 steps")

    def test_loads_that_tear_the_packing_apart(self):
        force = '[[particles]]\nids = [0]\nfixed = true\n[[particles]]\nids = [1]\nforce = [1e10, 0, 0]'
        self.assert_fault(self.outcome(PAIR, more=force, code=3), "cannot be made")
        self.assert_fault(self.outcome(PAIR[:1], more=periodic(2 * R, 'stress = "1e9 Pa"'), code=3), "cannot be made")
        self.outcome(PAIR, more="[[particles]]\nids = [0, 1]\nfixed = true")
        self.assertAlmostEqual(self.neck(), 0.03, 12)

    def test_a_stop_that_is_never_reached(self):
        more = periodic(2 * R)
        self.assert_fault(self.outcome(PAIR[:1], "material.dihedral_angle=40 deg", stop="relative_density = 0.9",
                                       more=more, code=3), "out of reach")

    def test_more_threads_than_cores(self):
        self.outcome(PAIR, threads=64)
        self.assertAlmostEqual(self.neck(), 0.358179, 5)


if __name__ == "__main__":
    unittest.main()
