"""Wrong input: exit code 2, every fault told with its place and what is allowed, nothing written."""

import unittest

from program import CASE, PAIR, ProgramTest


class Faults(ProgramTest):
    def check_refused(self, *words, case="pair.toml", options=()):
        for command in (("run",), ("check",)):
            done = self.frit(*command, case, *options, code=2)
            self.assert_fault(done, *words)
            self.assertEqual(done.stdout, "")
        self.assertFalse((self.folder / "pair").exists(), "a result folder was made for a wrong case")

    def with_case(self, old, new):
        self.assertIn(old, CASE)
        self.write("pair.toml", CASE.replace(old, new))

    def test_unknown_key_names_the_nearest(self):
        self.with_case("initial_neck_ratio", "inital_neck_ratio")
        self.check_refused("pair.toml:7", "contact.inital_neck_ratio", "initial_neck_ratio")

    def test_unknown_material_names_the_nearest(self):
        self.with_case('"copper"', '"coper"')
        self.check_refused("pair.toml:5", "material.use", '"copper"')

    def test_wrong_unit(self):
        self.with_case('"60 s"', '"60 um"')
        self.check_refused("pair.toml:9", "stop.time", "60 um")

    def test_out_of_range(self):
        self.with_case("0.05", "1.5")
        self.check_refused("pair.toml:7", "contact.initial_neck_ratio", "1.5")

    def test_not_toml(self):
        self.with_case("[contact]", "[contact")
        self.check_refused("pair.toml:6")

    def test_missing_case(self):
        self.check_refused("nowhere.toml", "no such file", case="nowhere.toml")

    def test_missing_packing(self):
        (self.folder / "packing.csv").unlink()
        self.check_refused("packing.csv")
        self.write("packing.csv", PAIR)

    def test_text_in_a_cell(self):
        self.write("packing.csv", PAIR + "abc,0,0,5\n")
        self.check_refused("packing.csv:4", "x", "abc")

    def test_radius_that_is_no_number(self):
        self.write("packing.csv", PAIR + "20,0,0,nan\n")
        self.check_refused("packing.csv:4", "radius", "nan")

    def test_radius_that_is_negative(self):
        self.write("packing.csv", PAIR + "20,0,0,-5\n")
        self.check_refused("packing.csv:4", "radius")

    def test_two_particles_at_one_place(self):
        self.write("packing.csv", PAIR + "10,0,0,5\n")
        self.check_refused("packing.csv:4", "packing.csv:3")

    def test_empty_packing(self):
        self.write("packing.csv", PAIR.splitlines()[0] + "\n")
        self.check_refused("packing.csv", "no particles")

    def test_nothing_can_touch(self):
        self.write("packing.csv", PAIR.replace("10,0,0,5", "30,0,0,5"))
        self.check_refused("packing.csv", "no two particles touch")

    def test_density_stop_of_a_pair(self):
        self.with_case("time = \"60 s\"", "relative_density = 0.9")
        self.check_refused("stop.relative_density", "core")

    def test_all_faults_together(self):
        self.with_case('"60 s"', '"60 um"')
        text = (self.folder / "pair.toml").read_text().replace("0.05", "1.5").replace("[output]", "[outputs]")
        self.write("pair.toml", text)
        done = self.frit("run", "pair.toml", code=2)
        for words in (["stop.time"], ["contact.initial_neck_ratio"], ["outputs", "output"]):
            self.assert_fault(done, *words)

    def test_faults_of_case_and_folder_together(self):
        self.with_case("0.05", "1.5")
        (self.folder / "out").mkdir()
        self.write("out/series.csv", "")
        done = self.frit("run", "pair.toml", "-o", "out", code=2)
        self.assert_fault(done, "contact.initial_neck_ratio")
        self.assert_fault(done, "out", "results", "--force")

    def test_rows_of_a_packing_are_told_together_but_not_by_thousands(self):
        self.write("packing.csv", PAIR + "1,0,0,-5\n" * 1000)
        done = self.frit("check", "pair.toml", code=2)
        self.assertGreater(len(done.stderr.splitlines()), 10)
        self.assertLess(len(done.stderr.splitlines()), 50)

    def test_a_bad_override_is_named_as_such(self):
        self.check_refused("stop.time", "60 um", options=("--set", "stop.time=60 um"))


class CommandLine(ProgramTest):
    def test_mistakes_on_the_command_line(self):
        for arguments in ((), ("sinter",), ("run",), ("run", "pair.toml", "--treads", "2"),
                          ("run", "pair.toml", "--threads", "0"), ("pack", "pair.toml"), ("convert", "packing.csv"),
                          ("run", "pair.toml", "extra.toml"), ("replay", "x.cbor", "--solver", "magic")):
            self.assert_fault(self.frit(*arguments, code=2), "frit")
        self.assertEqual(self.names(), [])

    def test_formats_that_are_unknown(self):
        self.assert_fault(self.frit("convert", "packing.csv", "packing.doc", code=2), "packing.doc", ".vtp")
        self.assert_fault(self.frit("pack", "lattice.toml", "-o", "packing.doc", code=2), "packing.doc")

    def test_a_dump_that_is_none(self):
        self.assert_fault(self.frit("replay", "packing.csv", code=2), "dump")
        self.assert_fault(self.frit("replay", "nowhere.cbor", code=2), "nowhere.cbor")

    def test_describe_names_the_nearest_key(self):
        self.assert_fault(self.frit("describe", "contact.pul", code=2), "contact.pull")


if __name__ == "__main__":
    unittest.main()
