// Numbers in the text of a scene file that may be changed, and the day and hour of its skies.

const number = /(?<![\w.:+-])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w.:])/gi;

// Comments, commands with the lines that continue them, and words.
const token = /#[^\n]*|![^\n]*(?<=\\)(?:\n[^\n]*(?<=\\))*\n[^\n]*|![^\n]*|\S+/g;

// Where numbers may stand: commands, and arguments behind their counts (modifier type name n words n words n words; an
// alias has none).
function arguments_in(text) {
  const all = [];
  let seen = 0, left = 0, lists = 0;  // words of the primitive; arguments that come; lists that come behind them
  for (const { 0: word, index } of text.matchAll(token)) {
    if (word[0] === '#') continue;
    if (word[0] === '!' && !seen) all.push([index, index + word.length]);
    else if (left) { left--; all.push([index, index + word.length]); }
    else if (lists) { lists--; left = Math.max(0, Number.parseInt(word, 10) || 0); }
    else if (++seen === 2 && word === 'alias') seen = -2;
    else if (seen === 3) lists = 3;
    if (!left && !lists && seen === 3) seen = 0;
  }
  return all;
}

// [{ start, end, value, whole }] of a scene file; comments and counts of arguments are left out.  whole: a number of
// repetitions (xform -a).
export const numbers_in = (text) => arguments_in(text).flatMap(([from, to]) => [...text.slice(from, to).matchAll(number)]
  .map((m) => ({ start: from + m.index, end: from + m.index + m[0].length, value: Number(m[0]),
    whole: /xform\b[^|]*\s-[ai]\s+$/.test(text.slice(from, from + m.index)) })));

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
