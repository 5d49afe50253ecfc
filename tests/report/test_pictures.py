"""frit report: pictures of known size, and what it says about folders that are no results."""

import struct
import unittest
import zlib

from program import ProgramTest


def read_png(path):
    """Width, height and the rows of an 8 bit RGB picture without interlace, the filters undone."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert (depth, colour, interlace) == (8, 2, 0)
        packed += body if kind == b"IDAT" else b""
        place += length + 12
    raw, stride, rows, above = zlib.decompress(packed), 3 * width, [], bytes(3 * width)
    for row in range(height):
        start = row * (stride + 1)
        rows.append(unfilter(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above))
        above = rows[-1]
    return width, height, rows


def unfilter(kind, line, above):
    for n in range(len(line)):
        left, up, corner = (line[n - 3], above[n], above[n - 3]) if n >= 3 else (0, above[n], 0)
        if kind == 4:
            guess = left + up - corner
            add = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
        else:
            add = (0, left, up, (left + up) // 2)[kind]
        line[n] = (line[n] + add) & 255
    return bytes(line)


def share_not_white(rows):
    pixels = [row[n:n + 3] for row in rows for n in range(0, len(row), 3)]
    return sum(pixel != b"\xff\xff\xff" for pixel in pixels) / len(pixels), len(set(pixels))


class Pictures(ProgramTest):
    def test_sizes_and_contents(self):
        self.frit("run", "lattice.toml", "--quiet")
        told = self.frit("report", "lattice", "--png", "--width", 600).stdout.split()
        self.assertEqual(told, ["lattice/curves.png", "lattice/packing.png"])
        for name, height, least in (("curves", 375, 0.03), ("packing", 480, 0.15)):
            width, found, rows = read_png(self.folder / "lattice" / f"{name}.png")
            self.assertEqual((width, found), (600, height))
            share, colours = share_not_white(rows)
            self.assertTrue(least < share < 0.8, f"{name}: {share}")
            self.assertGreater(colours, 50, name)

    def test_the_same_bytes_again(self):
        self.frit("run", "pair.toml", "--quiet")
        for folder in ("one", "two"):
            self.frit("report", "pair", "--png", "--width", 400, "-o", folder)
        for name in ("curves.png", "packing.png"):
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "two" / name).read_bytes())

    def test_the_quantity_of_the_colours(self):
        self.frit("run", "pair.toml", "--quiet")
        self.frit("report", "pair", "--png", "--width", 400, "--colour", "coordination")
        done = self.frit("report", "pair", "--png", "--colour", "flavour", code=2)
        self.assert_fault(done, "flavour", "coordination")
        self.assert_fault(self.frit("report", "pair", "--colour", "coordination", code=2), "--png")
        self.assert_fault(self.frit("report", "pair", "--png", "--width", 3, code=2), "400")


class Faults(ProgramTest):
    def test_folders_that_are_no_results_are_told_together(self):
        (self.folder / "empty").mkdir()
        done = self.frit("report", "nowhere", "empty", "pair.toml", code=2)
        for name in ("nowhere", "empty", "pair.toml"):
            self.assert_fault(done, name)
        self.assertEqual(self.names(), ["empty"])

    def test_damaged_files_are_named(self):
        self.frit("run", "pair.toml", "--quiet")
        folder = self.folder / "pair"
        (folder / "report.html").unlink()
        whole = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        for name, bytes_left, word in (("series.csv", 20, "series.csv"), ("summary.json", 40, "not JSON"),
                                       ("snapshots/particles_000003.vtp", 900, "particles_000003.vtp"),
                                       ("snapshots/contacts_000003.vtp", 900, "contacts_000003.vtp"),
                                       ("case.toml", 300, "case.toml"), ("snapshots.pvd", 30, "snapshots.pvd")):
            (folder / name).write_bytes(whole[folder / name][:bytes_left])
            self.assert_fault(self.frit("report", "pair", code=2), word)
            self.assertFalse((folder / "report.html").exists())
            (folder / name).write_bytes(whole[folder / name])
        (folder / "snapshots" / "particles_000002.vtp").unlink()
        self.assert_fault(self.frit("report", "pair", code=2), "particles_000002.vtp", "missing")

    def test_a_run_that_was_cut_short_has_a_report(self):
        self.frit("run", "pair.toml", "--quiet")
        (self.folder / "pair" / "summary.json").unlink()
        self.frit("report", "pair")
        self.assertIn("summary.json is missing", (self.folder / "pair" / "report.html").read_text())

    def test_a_run_can_go_without(self):
        self.frit("run", "pair.toml", "--quiet", "--set", "output.report=false")
        self.assertFalse((self.folder / "pair" / "report.html").exists())
        self.frit("report", "pair")
        self.frit("run", "pair.toml", "--quiet", "--force", "--set", "output.report=false")
        self.assertFalse((self.folder / "pair" / "report.html").exists())


if __name__ == "__main__":
    unittest.main()
