// Axes: from values to places and back, and where ticks stand.

export interface Scale {
  place(value: number): number; // 0 to 1 in the range
  value(place: number): number;
  ticks(about: number): number[];
  accepts(value: number): boolean;
}

export function linear(least: number, most: number): Scale {
  const width = most - least || 1;
  return {
    place: (value) => (value - least) / width,
    value: (place) => least + place * width,
    accepts: Number.isFinite,
    ticks(about) {
      const step = tickStep(width, about);
      const ticks = [];
      for (let n = Math.ceil(least / step - 1e-9); n * step <= most + 1e-9 * width; ++n)
        ticks.push(Number((n * step).toPrecision(12)));
      return ticks;
    },
  };
}

function tickStep(width: number, about: number): number {
  const least = width / about;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 2.5, 5, 10].find((factor) => factor * power >= least * 0.999)!;
}

export function logarithmic(least: number, most: number): Scale {
  const low = Math.log10(least);
  const width = Math.log10(most) - low || 1;
  return {
    place: (value) => (Math.log10(value) - low) / width,
    value: (place) => 10 ** (low + place * width),
    accepts: (value) => Number.isFinite(value) && value > 0,
    ticks(about) {
      if (width < 1.2)
        return linear(least, most)
          .ticks(about)
          .filter((tick) => tick > 0);
      const every = Math.ceil(width / about);
      const ticks = [];
      for (let power = Math.ceil(low - 1e-9); power <= low + width + 1e-9; power += every) ticks.push(10 ** power);
      return ticks;
    },
  };
}

export interface Extent {
  least: number;
  most: number;
}

export function extent(values: Iterable<number>, accepts: (value: number) => boolean = Number.isFinite): Extent | null {
  let least = Infinity;
  let most = -Infinity;
  for (const value of values) {
    if (!accepts(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return least <= most ? { least, most } : null;
}
