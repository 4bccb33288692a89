// SPDX-License-Identifier: BSD-3-Clause
// How often the page's words are wrong:  node count.mjs ROWS REFERENCE [RULE]   (both of runs.py; RULE: another
// judge.js) The first coloured verdict of each run against the class of its design when it is settled, and the first
// "better" or "worse" against the settled difference.  Settled: the mean of all seeds at their last frame (noise alone,
// at the same size), and the picture of REFERENCE, which is larger.
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';

const [rows_file, reference_file, rule = new URL('../../lib/live/page/judge.js', import.meta.url).pathname] =
  process.argv.slice(2);
const { class_of, classes, judged, verdict } =
  await import('data:text/javascript,' + encodeURIComponent(readFileSync(resolve(rule), 'utf8')));
const threshold = .01;

const table = (file) => {
  const [head, ...lines] = readFileSync(file, 'utf8').trim().split('\n').map((l) => l.split('\t'));
  return lines.filter((l) => l.length === head.length && l[0] !== 'scene')
    .map(
      (l) => Object.fromEntries(head.map(
        (n, k) =>
          [n,
           n === 'scene'  ? l[k] :
             l[k] === '-' ? NaN :
                            Number(l[k])])));
};
const by = (all, key) => all.reduce((m, r) => m.set(key(r), [...m.get(key(r)) ?? [], r]), new Map());
const mean = (v) => v.reduce((a, b) => a + b, 0) / v.length;
const design = (r) => `${r.scene} ${r.hour} ${r.edit}`, run = (r) => `${design(r)} ${r.seed}`;

// The rule of before: the classes of an interval where there is one, else of the value; differences by two values.
const old = {
  verdict: (name, row) => {
    const ends = [row[`${name}.lo`], row[`${name}.hi`]].map((v) => Number.isFinite(v) ? v : row[name]);
    return Number.isFinite(row[name]) && row.Ev !== 0 ? ends.map(class_of) : null;
  },
  judged: (name, row) => {
    const [low, high] = [row[`${name}.d.lo`], row[`${name}.d.hi`]];
    if (!(high < 0 || low > 0)) return '';
    const then = class_of(row[name] - row[`${name}.d`]), now = class_of(row[name]), less = high < 0;
    return then !== now || (less ? high < -threshold : low > threshold) ? less ? 'better' : 'worse' : '';
  },
};
const ours = {
  verdict: (name, row) =>
    verdict(name, row).kind.startsWith('class') ? classes(row[`${name}.lo`], row[`${name}.hi`]) : null,
  judged: (name, row, before) => /better|worse/.exec(judged(name, row, before, 'overlay', threshold).text)?.[0] ?? '',
};

const all = table(rows_file), runs = by(all, run), name = 'DGPf';
const last = [...runs.values()].map((r) => r[r.length - 1]), settled = new Map(), larger = new Map();
for (const [key, of] of by(last, design)) settled.set(key, mean(of.map((r) => r[name])));
for (const [key, of] of by(table(reference_file), design)) larger.set(key, of[of.length - 1][name]);
const half = [...by(last, design).values()].map(
  (of) => 2 * Math.sqrt(mean(of.map((r) => (r[name] - mean(of.map((q) => q[name]))) ** 2)) / of.length));
console.log(
  `${runs.size} runs of ${settled.size} designs; the settled values are known to +- ${
    half.sort((a, b) => a - b)[Math.floor(.9 * half.length)].toFixed(4)} (nine of ten); ` +
  `the larger picture differs by ${
    mean([...larger].filter(([k]) => settled.has(k)).map(([k, v]) => Math.abs(v - settled.get(k))))
      .toFixed(4)} on average`);

const percent = (k, n) => `${(100 * k / n).toFixed(2)} % (${k} of ${n})`;
for (const [which, rule] of [['before', old], ['now', ours]]) {
  let told = 0, wrong = 0, wrong_larger = 0, two = 0, words = 0, opposite = 0, not_so = 0, of_larger = 0, said = 0;
  const frames = [];
  for (const [key, of] of runs) {
    const at = of.find((r) => rule.verdict(name, r)), d = design(of[0]);
    if (!at) continue;
    const [low, high] = rule.verdict(name, at);
    told++;
    two += low !== high;
    frames.push(at.frame);
    const holds = (v) => class_of(v) >= low && class_of(v) <= high;
    wrong += !holds(settled.get(d));
    if (larger.has(d)) {
      of_larger++;
      wrong_larger += !holds(larger.get(d));
    }
    if (of[0].edit === 0) continue;
    const base = `${of[0].scene} ${of[0].hour} 0`, before = runs.get(`${base} ${of[0].seed}`);
    words++;
    const word_at = (r) => rule.judged(name, r, before[before.length - 1]);
    const first = of.find(word_at);
    if (!first) continue;
    said++;
    const word = word_at(first), [then, now] = [settled.get(base), settled.get(d)],
          sign = word === 'better' ? then - now : now - then;
    opposite += sign < 0;
    not_so += !(sign > threshold || (sign > 0 && class_of(then) !== class_of(now)));
  }
  frames.sort((a, b) => a - b);
  console.log(
    `${which}: first coloured verdict ${told} of ${runs.size}, of two classes ${percent(two, told)}, at frame ${
      frames[frames.length >> 1]} (median), ` +
    `${frames[Math.floor(.95 * frames.length)]} (95 %); does not hold the settled class ${
      percent(wrong, told)}, that of the larger picture ${percent(wrong_larger, of_larger)}`);
  console.log(`${which}: better or worse said in ${said} of ${words}; the other way round ${
    percent(opposite, said)}; not so when settled ${percent(not_so, said)}`);
}
