"""report.html of real runs in headless Chromium: no error, the numbers of series.csv, what sliders and buttons do."""

import math
import os
import pathlib
import time
import unittest
import xml.etree.ElementTree

from browser import Browser, find_browser
from program import ProgramTest

POWDER = """
title = "Powder <b>in</b> a cell"
[packing]
generate = "random-dense"
count = 500
radius_spread = 0.1
[cell]
kind = "periodic"
[material]
use = "copper"
[contact]
sliding_resistance = {eta}
[stop]
relative_density = 0.70
"""
# Where to keep pictures of the pages, to look at; nothing is kept without it.
PICTURES = os.environ.get("FRIT_PICTURES")
READY = """new Promise((done, fail) => {
  let left = 400;
  const look = () => {
    if (window.frit && frit.views.every((view) => view.canvas.dataset.ready !== undefined)) return done(true);
    if (--left === 0) return fail(new Error("no picture after 20 s"));
    setTimeout(look, 50);
  };
  look();
})"""
# Number of curves, once there are any: they are drawn when the page has been laid out.
CURVES = """new Promise((done) => {
  let left = 200;
  const look = () => {
    const count = document.querySelectorAll("path.curve").length;
    if (count > 0 || --left === 0) return done(count);
    setTimeout(look, 50);
  };
  look();
})"""
# Share of the canvas that is not background, and how many colours it has.
COVERED = """(() => {
  const view = frit.views[0], canvas = view.canvas, gl = canvas.getContext("webgl2");
  view.draw();
  const pixels = new Uint8Array(4 * canvas.width * canvas.height), colours = new Set();
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let covered = 0;
  for (let n = 0; n < pixels.length; n += 4) {
    if (pixels[n] === 255 && pixels[n + 1] === 255 && pixels[n + 2] === 255) continue;
    covered += 1;
    colours.add(pixels[n] >> 4 << 8 | pixels[n + 1] >> 4 << 4 | pixels[n + 2] >> 4);
  }
  return {share: covered / (canvas.width * canvas.height), colours: colours.size};
})()"""
# What is drawn of random spheres must look the same, pixel by pixel, as all of them by brute force.
HIDDEN = """(() => {
  let seed = 1, wrong = 0;
  const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
  const count = 3000, pixel = 0.08, size = 150;
  const [x, y, z, radii] = [0, 1, 2, 3].map(() => new Float32Array(count));
  for (let n = 0; n < count; ++n) {
    [x, y, z].forEach((list) => { list[n] = 12 * (random() - 0.5); });
    radii[n] = 0.4 + 1.6 * random() ** 6;
  }
  const all = Uint32Array.from({length: count}, (_, n) => n), half = size * pixel / 2;
  const seen = frit.visibleRows(all, {x, y, z, radii}, {halfWidth: half, halfHeight: half, pixel});
  const nearest = (rows, a, b) => Math.min(...Array.from(rows, (n) => {
    const left = radii[n] ** 2 - (x[n] - a) ** 2 - (y[n] - b) ** 2;
    return left > 0 ? z[n] - Math.sqrt(left) : Infinity;
  }));
  for (let u = 0; u < size; u += 3) {
    for (let v = 0; v < size; v += 3) {
      const [a, b] = [(u + 0.5) * pixel - half, (v + 0.5) * pixel - half];
      if (nearest(all, a, b) !== nearest(seen, a, b)) wrong += 1;
    }
  }
  return {wrong, seen: seen.length, all: count};
})()"""


@unittest.skipUnless(find_browser(), "Chromium is not installed: the page is not tested in a browser")
class Page(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(1280, 900)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def run_powder(self, name, eta=0.01):
        self.write(f"{name}.toml", POWDER.format(eta=eta))
        self.frit("run", f"{name}.toml", "--quiet")

    def open(self, page):
        self.browser.problems.clear()
        self.browser.open(page)
        self.browser.evaluate(READY)

    def look(self, name):
        if PICTURES:
            time.sleep(0.5)
            self.browser.screenshot(pathlib.Path(PICTURES) / f"{name}.png", whole_page=True)
        self.assertEqual(self.browser.problems, [])

    def test_a_run_from_its_curves_to_its_spheres(self):
        self.run_powder("powder")
        self.open(self.folder / "powder" / "report.html")
        self.assertEqual(self.browser.evaluate("document.querySelector('h1').textContent"), "Powder <b>in</b> a cell")
        self.curves_hold_the_numbers_of_the_series()
        self.a_chart_tells_its_values()
        self.a_chart_can_be_saved()
        self.the_slider_moves_all_parts()
        self.places_are_those_of_the_last_snapshot()
        self.spheres_are_drawn_in_colours()
        hidden = self.browser.evaluate(HIDDEN)
        self.assertEqual(hidden["wrong"], 0)
        self.assertLess(hidden["seen"], 0.8 * hidden["all"])
        self.look("run")

    def curves_hold_the_numbers_of_the_series(self):
        for name, column in self.series("powder").items():
            shown = self.browser.evaluate(f"Array.from(frit.column(frit.runs[0], {name!r}), (v) => isNaN(v) ? null : v)")
            self.assertEqual(shown, [float(text) if text else None for text in column], name)

    def a_chart_tells_its_values(self):
        """The tip at the last point of the density curve, and the CSV of the chart."""
        density = self.series("powder")["relative_density"]
        tip = self.browser.evaluate("""(() => {
          const drawing = document.querySelector("#time svg.chart"), mark = drawing.querySelector(".mark");
          const box = mark.getBoundingClientRect();
          const at = {clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, bubbles: true};
          drawing.dispatchEvent(new PointerEvent("pointermove", at));
          return document.querySelector("#time .tip").textContent;
        })()""")
        self.assertIn("relative density", tip)
        self.assertAlmostEqual(float(tip.split(":")[-1]), float(density[-1]), delta=1e-6)

    def a_chart_can_be_saved(self):
        """SVG that is XML, PNG three times the size on the screen, CSV with the numbers of the series."""
        svg, png, csv = self.browser.evaluate("""(async () => {
          const blobs = [], make = URL.createObjectURL;
          URL.createObjectURL = (blob) => (blobs.push(blob), make(blob));
          for (const button of document.querySelectorAll("#time figure:first-child .tools button")) button.click();
          for (let left = 100; blobs.length < 3 && left > 0; --left) await new Promise((done) => setTimeout(done, 50));
          URL.createObjectURL = make;
          const of = (type) => blobs.find((blob) => blob.type.startsWith(type));
          const picture = await createImageBitmap(of("image/png"));
          return [await of("image/svg").text(), [picture.width, picture.height], await of("text/csv").text()];
        })()""")
        root = xml.etree.ElementTree.fromstring(svg)
        self.assertGreater(len(list(root.iter("{http://www.w3.org/2000/svg}path"))), 1)
        self.assertEqual(png, [3 * int(root.get("width")), 3 * int(root.get("height"))])
        shown = [float(line.split(",")[1]) for line in csv.splitlines()[1:]]
        self.assertEqual(shown, [float(text) for text in self.series("powder")["relative_density"]])

    def the_slider_moves_all_parts(self):
        before = self.browser.evaluate("document.querySelector('#distributions .steps').getAttribute('d')")
        moved = self.browser.evaluate("""(() => {
          const slider = document.querySelector("#bar input");
          slider.value = "0";
          slider.dispatchEvent(new Event("input"));
          return new Promise((done) => setTimeout(() => done({
            row: frit.cursor.rowOf(0),
            frame: frit.views[0].canvas.dataset.ready,
            bins: document.querySelector("#distributions .steps").getAttribute("d"),
            mark: Number(document.querySelector("#time .mark").getAttribute("cx")),
            axis: Number(document.querySelector("#time line.grid").getAttribute("x1")),
          }), 800));
        })()""")
        self.assertEqual((moved["row"], moved["frame"]), (0, "0"))
        self.assertNotEqual(moved["bins"], before)
        self.assertAlmostEqual(moved["mark"], moved["axis"], delta=1)

    def places_are_those_of_the_last_snapshot(self):
        """To a step of 16 bits, after all frames before it have been added up."""
        last = sorted((self.folder / "powder" / "snapshots").glob("particles_*.vtp"))[-1]
        self.frit("convert", last, "last.csv")
        rows = [[float(cell) for cell in line.split(",")] for line in (self.folder / "last.csv").read_text().splitlines()[1:]]
        shown = self.browser.evaluate("""(async () => {
          const {packing, frames} = frit.views[0], index = packing.frames.length - 1, frame = await frames.get(index);
          const {origin, size} = packing.frames[index];
          return {origin, size, radius: packing.mean_radius, places: Array.from(frame.places), radii: Array.from(frame.radii)};
        })()""")
        for n, (_, *place, radius) in enumerate(rows):
            self.assertAlmostEqual(shown["radii"][n] * shown["radius"], radius, delta=1e-4 * radius)
            for axis in range(3):
                edge = shown["size"][axis]
                away = shown["places"][3 * n + axis] * shown["radius"] + edge / 2 + shown["origin"][axis] - place[axis]
                self.assertLess(abs(math.remainder(away, edge)), 0.52 * edge / 65536)

    def spheres_are_drawn_in_colours(self):
        drawn = self.browser.evaluate(COVERED)
        self.assertTrue(0.1 < drawn["share"] < 0.7, drawn)
        self.assertGreater(drawn["colours"], 30)
        self.browser.evaluate("frit.views[0].settings.cutAt = 0.3")
        self.assertLess(self.browser.evaluate(COVERED)["share"], drawn["share"])

    def test_keys_pointer_and_touch_turn_and_zoom(self):
        self.frit("run", "lattice.toml", "--quiet")
        self.open(self.folder / "lattice" / "report.html")
        call, state = self.browser.call, lambda: self.browser.evaluate("[...frit.views[0].camera.turn, frit.views[0].camera.zoom]")
        x, y = self.browser.evaluate("""(() => {
          const canvas = frit.views[0].canvas;
          canvas.scrollIntoView({block: "center"});
          canvas.focus();
          const box = canvas.getBoundingClientRect();
          return [box.left + box.width / 2, box.top + box.height / 2];
        })()""")
        seen = [state()]

        def changed(what):
            seen.append(state())
            self.assertNotEqual(seen[-1], seen[-2], what)
            rows = [seen[-1][3 * n:3 * n + 3] for n in range(3)]
            for a in range(3):
                for b in range(3):
                    dot = sum(p * q for p, q in zip(rows[a], rows[b]))
                    self.assertAlmostEqual(dot, float(a == b), places=9)

        call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft", code="ArrowLeft")
        changed("key")
        for kind, dx in (("mousePressed", 0), ("mouseMoved", 60), ("mouseReleased", 60)):
            call("Input.dispatchMouseEvent", type=kind, x=x + dx, y=y, button="left", buttons=1, clickCount=1)
        changed("drag")
        call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-200)
        changed("wheel")
        for kind, apart in (("touchStart", 40), ("touchMove", 90), ("touchMove", 120), ("touchEnd", None)):
            points = [] if apart is None else [{"x": x - apart, "y": y, "id": 0}, {"x": x + apart, "y": y, "id": 1}]
            call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
        changed("pinch")
        self.assertGreater(seen[-1][9], seen[-2][9])
        self.browser.evaluate("frit.cursor.set(0)")
        call("Input.dispatchKeyEvent", type="keyDown", key=".", code="Period")
        self.assertEqual(self.browser.evaluate("frit.cursor.rowOf(0)"), 1)
        self.assertEqual(self.browser.problems, [])

    def test_several_runs_lie_over_each_other(self):
        for name, eta in (("rough", 0.2), ("smooth", 0.0)):
            self.run_powder(name, eta)
        text = self.frit("report", "rough", "smooth").stdout
        self.assertEqual(text.strip(), "./report.html")
        self.open(self.folder / "report.html")
        self.assertEqual(self.browser.evaluate("frit.views.length"), 2)
        self.assertEqual(self.browser.evaluate("document.querySelector('#time svg').querySelectorAll('path.curve').length"), 2)
        # At equal density, to the nearest row.
        density = self.browser.evaluate("[0, 1].map((run) => frit.column(frit.runs[run], 'relative_density')[frit.cursor.rowOf(run)])")
        self.assertAlmostEqual(density[0], density[1], delta=0.006)
        self.look("two_runs")

    def test_two_spheres_in_free_space(self):
        self.frit("run", "pair.toml", "--quiet")
        self.open(self.folder / "pair" / "report.html")
        self.assertGreater(self.browser.evaluate(COVERED)["share"], 0.02)
        self.look("pair")

    def test_a_run_without_snapshots_says_so(self):
        self.frit("run", "pair.toml", "--quiet", "--set", "output.snapshots=false")
        self.open(self.folder / "pair" / "report.html")
        self.assertIn("no snapshots", self.browser.evaluate("document.body.textContent"))
        self.look("no_snapshots")

    def test_a_browser_without_webgl_is_told(self):
        self.frit("run", "pair.toml", "--quiet")
        with Browser(390, 800, flags=("--disable-3d-apis",)) as browser:
            browser.open(self.folder / "pair" / "report.html")
            self.assertIn("No 3D view", browser.evaluate("document.querySelector('#packing').textContent"))
            self.assertGreater(browser.evaluate(CURVES), 3)


if __name__ == "__main__":
    unittest.main()
