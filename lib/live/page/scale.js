// Round numbers of a scale: 1, 2 and 5 times powers of ten.
const round = [1, 2, 5, 10];

// At most so many between two values, evenly spaced or, on a logarithmic scale, of every decade alike.
export function round_steps(low, high, logarithmic, most = 5) {
  const all = [];
  if (!(high > low)) return all;
  if (!logarithmic) {
    const power = 10 ** Math.floor(Math.log10((high - low) / most)),
          each = round.map((m) => m * power).find((s) => (high - low) / s <= most) ?? 10 * power;
    for (let k = Math.ceil(low / each); k * each <= high * (1 + 1e-9); k++) all.push(Number((k * each).toPrecision(6)));
    return all;
  }
  for (const of of [[1, 2, 5], [1, 3], [1]]) {
    all.length = 0;
    for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; power++)
      all.push(
        ...of.map((m) => Number((m * 10 ** power).toPrecision(6))).filter((v) => v >= low * .999 && v <= high * 1.001));
    if (all.length <= most) return all;
  }
  return all;
}
