// Numbers in the text of a scene file that may be changed, and the day and hour of its skies.

const number = /(?<![\w.+-])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w.:])/gi;

// [{ start, end, value, whole }]; comments and counts of arguments are left out.  whole: a number of repetitions (xform -a).
export function numbers_in(text) {
  const all = [];
  let at = 0;
  for (const line of text.split('\n')) {
    if (!line.trimStart().startsWith('#')) {
      const found = [...line.matchAll(number)].map((m) => ({ start: at + m.index, end: at + m.index + m[0].length, value: Number(m[0]),
        whole: /\s-[ai]\s+$/.test(line.slice(0, m.index)) }));
      const command = line.startsWith('!'), first = found[0];
      const counts = !command && first && Number.isInteger(first.value) && /^\s*\d/.test(line) &&
        (first.value === found.length - 1 || found.length === 1);
      all.push(...found.slice(counts ? 1 : 0));
    }
    at += line.length + 1;
  }
  return all;
}

const sky = /^!.*\b(gensky|gendaylit)[ \t]+(\d+)[ \t]+(\d+)[ \t]+(\+?)(\d+(?:\.\d*)?|\.\d+|\d+:\d+)/gm;
const months = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];

// [{ program, day (1 to 365), hour }] of the lines that make a sky.
export const skies_in = (text) => [...text.matchAll(sky)].map((m) => ({
  program: m[1], day: months.slice(0, m[2] - 1).reduce((a, b) => a + b, 0) + Number(m[3]),
  hour: m[5].includes(':') ? Number(m[5].split(':')[0]) + Number(m[5].split(':')[1]) / 60 : Number(m[5]),
}));

export function date_of(day) {
  let month = 0;
  while (month < 11 && day > months[month]) day -= months[month++];
  return [month + 1, day];
}

// The text with sky k at another day and hour.
export function with_sky(text, k, day, hour) {
  const [month, date] = date_of(day);
  let at = 0;
  return text.replace(sky, (all, program, m, d, plus, h) => {
    if (at++ !== k) return all;
    const head = all.slice(0, all.lastIndexOf(program) + program.length);
    return `${head} ${month} ${date} ${plus}${Number(hour.toFixed(3))}`;
  });
}

export const with_number = (text, { start, end }, value) => text.slice(0, start) + String(Number(value.toPrecision(6))) + text.slice(end);

// [least, largest] of a slider that begins at a value.
export function range_of(value) {
  if (value >= 0 && value <= 1) return [0, 1];
  return value > 0 ? [0, 2 * value] : [2 * value, 0];
}
