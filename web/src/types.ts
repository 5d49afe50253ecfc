// What the program writes into the page (src/report/page.cpp); SI units.

export interface Series {
  columns: string[];
  values: (number | null)[][]; // [column][row]
}

export interface Field {
  name: string;
  least: number;
  most: number;
  square: boolean; // codes are of the root
}

export interface FrameInfo {
  time: number;
  origin: [number, number, number];
  size: [number, number, number];
  periodic: boolean;
  necks: number;
}

export interface Packing {
  count: number;
  ids: number[] | null; // null: 0, 1, 2, ...
  largest_radius: number;
  mean_radius: number;
  fields: Field[];
  frames: FrameInfo[];
}

export interface Distribution {
  name: string;
  over: string;
  range: [number, number];
  counts: number[][]; // [snapshot][bin]
  mean: (number | null)[];
}

export interface Run {
  name: string;
  title: string;
  words: string[];
  material: { name: string; source: string; properties: [string, string][] };
  summary: Record<string, any>;
  notes: string[];
  series: Series;
  tau_per_theta: number | null;
  distributions: { times: number[]; fields: Distribution[] } | null;
  packing: Packing | null;
}

export interface PageData {
  version: string;
  maps: { name: string; colours: string }[]; // base64 of 256 RGB triples; the first is the default
  runs: Run[];
}
