// Figures and numbers as files.
import { button, el } from "./dom";

export function saveBlob(name: string, blob: Blob): void {
  const link = el("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function saveText(name: string, text: string, type: string): void {
  saveBlob(name, new Blob([text], { type }));
}

const styles = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "fill-opacity",
  "font-family",
  "font-size",
  "font-weight",
  "text-anchor",
];

/** The drawing as it looks now, with its styles written out and its background filled. */
export function standaloneSvg(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const originals = drawing.querySelectorAll("*");
  copy.querySelectorAll("*").forEach((element, n) => {
    const style = getComputedStyle(originals[n]!);
    for (const name of styles) element.setAttribute(name, style.getPropertyValue(name));
    element.removeAttribute("class");
  });
  copy.querySelectorAll("[data-transient]").forEach((element) => element.remove());
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.style.background = getComputedStyle(document.body).backgroundColor;
  return new XMLSerializer().serializeToString(copy);
}

/** The drawing in `times` its size on the screen. */
export async function pngOf(drawing: SVGSVGElement, times = 3): Promise<Blob> {
  const picture = new Image();
  picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standaloneSvg(drawing))}`;
  await picture.decode();
  const canvas = el("canvas");
  canvas.width = times * drawing.clientWidth;
  canvas.height = times * drawing.clientHeight;
  const context = canvas.getContext("2d")!;
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob((blob) => resolve(blob!)));
}

/** Columns side by side; NaN as an empty cell. */
export function csvOf(columns: { name: string; values: ArrayLike<number> }[]): string {
  const rows = Math.max(...columns.map((column) => column.values.length));
  const cell = (value: number | undefined): string => (value === undefined || Number.isNaN(value) ? "" : String(value));
  const lines = [columns.map((column) => column.name.replaceAll(",", ";")).join(",")];
  for (let row = 0; row < rows; ++row) lines.push(columns.map((column) => cell(column.values[row])).join(","));
  return `${lines.join("\n")}\n`;
}

/** Buttons that save a drawing as SVG and PNG and its numbers as CSV, under a name made from its title. */
export function saveButtons(title: () => string, drawing: SVGSVGElement, csv: () => string): HTMLElement {
  const file = (): string => title().replaceAll(/\W+/g, "_");
  return el(
    "div",
    { class: "tools" },
    button("SVG", "save the drawing", () => saveText(`${file()}.svg`, standaloneSvg(drawing), "image/svg+xml")),
    button("PNG", "save a picture", () => void pngOf(drawing).then((blob) => saveBlob(`${file()}.png`, blob))),
    button("CSV", "save the numbers", () => saveText(`${file()}.csv`, csv(), "text/csv")),
  );
}
