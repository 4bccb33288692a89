// Numbers in the text of a scene file that may be changed, and the day and hour of its skies.

const number = /(?<![\w.:+-])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w.:])/gi;

// Comments, commands with the lines that continue them, and words, which may have quoted parts.
const token = /#[^\n]*|![^\n]*(?<=\\)(?:\n[^\n]*(?<=\\))*\n[^\n]*|![^\n]*|(?:"[^"\n]*"|'[^'\n]*'|\S)+/g;

// The primitives and commands of a text: { start, end, line, command, type, name, arguments: places of words, reals:
// those of real arguments }.  Arguments stand behind their counts (modifier type name n words n words n words; an alias
// has none).
export function things_in(text) {
  const all = [];
  let thing, left = 0, lists = 0, line = 1, counted = 0;  // arguments that come; lists that come behind them
  const begin = (start, facts) => {
    for (; counted < start; counted++) line += text[counted] === '\n';
    all.push(thing = { start, line, words: [], arguments: [], reals: [], ...facts });
  };
  for (const { 0: word, index } of text.matchAll(token)) {
    const place = [index, index + word.length];
    if (word[0] === '#') continue;
    if (!thing && word[0] === '!') {
      begin(index, { command: true });
      thing.arguments.push(place);
    } else if (left) {
      left--;
      thing.arguments.push(place);
      if (!lists) thing.reals.push(place);
    } else if (lists) {
      lists--;
      left = Math.max(0, Number.parseInt(word, 10) || 0);
    } else {
      if (!thing) begin(index);
      thing.words.push(word);
      if (thing.words.length === 3 && thing.words[1] !== 'alias') lists = 3;
    }
    thing.end = index + word.length;
    const { words, command } = thing;
    if (command || (!left && !lists && words.length === (words[1] === 'alias' ? 4 : 3))) {
      [, thing.type, thing.name] = words.map((w) => w.replace(/["']/g, ''));
      thing = null;
    }
  }
  return all;
}

// [{ start, end, value, whole }] of a scene file; comments and counts of arguments are left out.  whole: a number of
// repetitions (xform -a).
export const numbers_in = (text) => things_in(text).flatMap((thing) => numbers_of(text, thing));
export const numbers_of = (text, thing) =>
  thing.arguments.flatMap(([from, to]) => [...text.slice(from, to).matchAll(number)].map((m) => ({
    start: from + m.index,
    end: from + m.index + m[0].length,
    value: Number(m[0]),
    option: /(?:\s(-[a-z]+)(?:\s+[-+.\de]+)*?\s+)?$/i.exec(text.slice(from, from + m.index))[1],
    whole: /xform\b[^|]*\s-[ai]\s+$/.test(text.slice(from, from + m.index))
  })));

export const sky_line = /^!.*\b(gensky|gendaylit)[ \t]+(\d+)[ \t]+(\d+)[ \t]+(\+?)(\d+:\d+|\d+(?:\.\d*)?|\.\d+)/gm;
const months = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];

// [{ program, day (1 to 365), hour }] of the lines that make a sky.
export const skies_in = (text) => [...text.matchAll(sky_line)].map((m) => ({
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
  return text.replace(sky_line, (all, program, m, d, plus, h) => {
    if (at++ !== k) return all;
    const head = all.slice(0, all.lastIndexOf(program) + program.length);
    return `${head} ${month} ${date} ${plus}${Number(hour.toFixed(3))}`;
  });
}

export const digits = (value) => String(Number(value.toPrecision(6)));
export const with_number = (text, { start, end }, value) => text.slice(0, start) + digits(value) + text.slice(end);
export const reals_of = (text, thing) => thing.reals.map(([from, to]) => Number(text.slice(from, to)));
function with_reals(text, thing, values) {
  for (let k = values.length - 1; k >= 0; k--)
    text = with_number(text, { start: thing.reals[k][0], end: thing.reals[k][1] }, values[k]);
  return text;
}

// What the first three numbers of a material mean; null: no colour.
export const colour_of = ({ type }) =>
  /^(plastic|metal|trans|mirror)$/.test(type) ? 'reflectance' :
  type === 'glass' ? 'transmissivity' :
  /^(light|glow|spotlight|illum)$/.test(type) ? 'radiance' : null;
const grey = ([r, g, b]) => .265 * r + .67 * g + .065 * b;

// { value, most } of its colour as one grey; what is reflected or passes is at most all.
export function grey_of(text, thing) {
  const rgb = reals_of(text, thing).slice(0, 3), value = grey(rgb);
  return { value, most: colour_of(thing) === 'radiance' ? 2 * value || 100 : value > 0 ? value / Math.max(...rgb) : 1 };
}

// The text with that grey; the hue stays.
export function with_grey(text, thing, value) {
  const rgb = reals_of(text, thing).slice(0, 3), now = grey(rgb);
  return with_reals(text, thing, rgb.map((v) => now > 0 ? v * value / now : value));
}

// How many of its real arguments are places.
const places = { polygon: Infinity, sphere: 3, bubble: 3, ring: 3, cylinder: 6, tube: 6, cone: 6, cup: 6 };
export const is_movable = (text, thing) =>
  thing.command ? !/^!\s*gen(sky|daylit)\b/.test(text.slice(thing.start, thing.end)) : thing.type in places;

// The text with a primitive or a command's surfaces moved along an axis.
export function with_move(text, thing, axis, by) {
  if (!thing.command) {
    const points = places[thing.type] ?? 0;
    return with_reals(
      text, thing, reals_of(text, thing).map((v, k) => k < points && k % 3 === axis ? Number((v + by).toFixed(6)) : v));
  }
  const line = text.slice(thing.start, thing.end), moved = / \| xform -t (\S+) (\S+) (\S+)$/.exec(line);
  const place = moved ? moved.slice(1).map(Number) : [0, 0, 0];
  place[axis] += by;
  const head = moved ? line.slice(0, moved.index) : line, back = place.every((v) => Math.abs(v) < 1e-6);
  return text.slice(0, thing.start) + head + (back ? '' : ` | xform -t ${place.map(digits).join(' ')}`) +
    text.slice(thing.end);
}

// [least, largest] of a slider that begins at a value.
export function range_of(value) {
  if (value >= 0 && value <= 1) return [0, 1];
  return value > 0 ? [0, 2 * value] : [2 * value, 0];
}
