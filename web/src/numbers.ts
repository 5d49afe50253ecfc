// Numbers as people read them.

const superscripts: Record<string, string> = {
  "-": "⁻",
  "0": "⁰",
  "1": "¹",
  "2": "²",
  "3": "³",
  "4": "⁴",
  "5": "⁵",
  "6": "⁶",
  "7": "⁷",
  "8": "⁸",
  "9": "⁹",
};

/** At most `digits` significant digits; powers of ten for what is very large or small. */
export function short(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits))).replace("-", "−");
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
  const power = [...String(Number(exponent))].map((c) => superscripts[c]).join("");
  const factor = String(Number(mantissa)).replace("-", "−");
  return factor === "1" ? `10${power}` : `${factor}·10${power}`;
}

export interface Unit {
  name: string;
  size: number; // in SI
}

/** The unit of time that suits a span [s]. */
export function timeUnit(span: number): Unit {
  if (span >= 3 * 3600) return { name: "h", size: 3600 };
  if (span >= 10 * 60) return { name: "min", size: 60 };
  if (span >= 0.1) return { name: "s", size: 1 };
  return { name: "ms", size: 1e-3 };
}

/** The unit of length that suits a size [m]. */
export function lengthUnit(size: number): Unit {
  if (size >= 1e-3) return { name: "mm", size: 1e-3 };
  if (size >= 0.5e-6) return { name: "µm", size: 1e-6 };
  return { name: "nm", size: 1e-9 };
}

/** 1, 2 or 5 times a power of ten, at most `value`. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = value / power;
  return (factor >= 5 ? 5 : factor >= 2 ? 2 : 1) * power;
}

/** "neck_angle_change [rad]" as "neck angle change" and "rad". */
export function nameAndUnit(column: string): { name: string; unit: string } {
  const match = /^(.*?)(?: \[(.*)\])?$/.exec(column)!;
  return { name: match[1]!.replaceAll("_", " "), unit: match[2] ?? "" };
}

export function label(column: string): string {
  const { name, unit } = nameAndUnit(column);
  return unit ? `${name} [${unit}]` : name;
}
