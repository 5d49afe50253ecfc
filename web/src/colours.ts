// From codes of a quantity to colours.
import { bytesOf, data } from "./runs";
import { decode } from "./frames";
import type { Field } from "./types";

const tables = new Map<string, Uint8Array>();

export const mapNames = data.maps.map((map) => map.name);

/** 256 colours of three bytes. */
export function mapTable(name: string): Uint8Array {
  if (!tables.has(name)) tables.set(name, bytesOf(data.maps.find((map) => map.name === name)!.colours));
  return tables.get(name)!;
}

export interface Range {
  least: number;
  most: number;
}

/** Four bytes for each code; grey for 255, which stands for no value. */
export function codeColours(map: string, field: Field, range: Range): Uint8Array {
  const table = mapTable(map);
  const colours = new Uint8Array(4 * 256).fill(255);
  for (let code = 0; code < 255; ++code) {
    const width = range.most - range.least;
    const part = width === 0 ? 0.5 : (decode(field, code) - range.least) / width;
    const entry = Math.round(255 * Math.max(0, Math.min(1, part)));
    colours.set(table.subarray(3 * entry, 3 * entry + 3), 4 * code);
  }
  colours.set([150, 150, 150], 4 * 255);
  return colours;
}

/** The range in which all but the smallest and largest hundredth lie. */
export function usualRange(field: Field, codes: Uint8Array[]): Range {
  const counts = new Uint32Array(256);
  let all = 0;
  for (const list of codes) {
    for (const code of list) {
      if (code === 255) continue;
      counts[code]! += 1;
      ++all;
    }
  }
  const codeAt = (share: number): number => {
    let sum = 0;
    for (let code = 0; code < 255; ++code) {
      sum += counts[code]!;
      if (sum >= share * all) return code;
    }
    return 254;
  };
  if (all === 0) return { least: field.least, most: field.most };
  const least = field.square ? field.least : decode(field, codeAt(0.01));
  const most = decode(field, codeAt(0.99));
  return most > least ? { least, most } : { least: field.least, most: field.most };
}

/** Fills a canvas of 256 pixels across with the map. */
export function drawColourBar(canvas: HTMLCanvasElement, map: string): void {
  const context = canvas.getContext("2d")!;
  const table = mapTable(map);
  for (let n = 0; n < 256; ++n) {
    context.fillStyle = `rgb(${table[3 * n]},${table[3 * n + 1]},${table[3 * n + 2]})`;
    context.fillRect(n, 0, 1, canvas.height);
  }
}
