// What may be said of glare, for every part of the page: the class of an interval, and whether a change is better or
// worse. A value alone says nothing: an interval does, where it lies in one class or in two neighbouring ones.
// lib/report/verdict_words.cpp has the same words; tests/golden/verdicts.tsv holds both to them.

// DGP's classes (Wienold and Christoffersen 2006): a word and a sign each, so that colour says nothing alone.
export const limits = [.35, .40, .45], words = ['imperceptible', 'perceptible', 'disturbing', 'intolerable'];
export const signs = ['○', '◔', '◑', '●'];
export const class_of = (dgp) => limits.filter((limit) => dgp >= limit).length;

// [lowest, highest] of the classes that an interval holds; null: there is no interval, or it holds more than two.
export function classes(low, high) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return null;
  const [from, to] = [class_of(low), class_of(high)];
  return to - from <= 1 ? [from, to] : null;
}
const of_row = (name, row) => classes(row?.[`${name}.lo`], row?.[`${name}.hi`]);

// The first that has a value: pictures without moments have no DGPf.
export function glare_of(names, row) {
  const all = ['DGPf', 'DGPu', 'DGP'].filter((name) => names.includes(name));
  return all.find((name) => Number.isFinite(row?.[name])) ?? all[0];
}

const black =
  'no light reaches the eye: it is night, the eye is in a solid or below the ground, or the scene has no sky and no lamp';
const three = (v) => v.toFixed(3).replace(/^0/, '');
export const looking = 'looking …';

// { text, kind, number, told } of a row of numbers.  kind: looking, or class0 to class3 of the worst class that the
// interval holds; told: a sentence on what that means.
export function verdict(name, row) {
  const value = row?.[name], ends = [row?.[`${name}.lo`], row?.[`${name}.hi`]];
  if (!Number.isFinite(value)) return { text: '', kind: '', number: '', told: '' };
  if (row.Ev === 0)
    return { text: '', kind: '', number: row.frame === 0 ? '' : black, told: '' };  // frame 0 may lack all of its light
  const found = classes(...ends);
  const number = ends.every(Number.isFinite) ? `${name} ${three(value)} (${three(ends[0])} to ${three(ends[1])})` : '';
  if (!found) return { text: looking, kind: 'looking', number, told: '' };
  const [low, high] = found, text = `${low === high ? '' : `${words[low]} to `}${words[high]}`;
  return { text: `${signs[high]} ${text}`, kind: `class${high}`, number, told: people(value, low, high) };
}

// DGP is a share of people; the classes are names for ranges of it (EN 17037, annex E).
function people(value, low, high) {
  const share = value < .2 ? 'fewer than 20' : value > .8 ? 'more than 80' : `about ${Math.round(100 * value)}`;
  const of_100 = limits.map((limit) => Math.round(100 * limit));
  const range = low === 0 ? `below ${of_100[0]} of 100` :
    low === 3 ? `from ${of_100[2]} of 100 on` :
                `from ${of_100[low - 1]} to ${of_100[low]} of 100`;
  const called = low === high ?
    `calls a share ${range} ${words[low]} glare` :
    `calls glare ${words[low]} below ${of_100[low]} of 100 and ${words[high]} from there on, which is not decided yet`;
  return `DGP is a share of people: ${share} of 100 would be disturbed by glare in this view. The standard (EN 17037) ${
    called}.`;
}

// { text, kind } of a difference with its interval.  before: the row of what it is compared with, if it is known.
// Better and worse are words for DGP alone: for all of the interval beyond a threshold, or for another class where both
// intervals lie in one class each; a view is another place, not a better one.
export function judged(name, row, before, what, threshold) {
  const [low, high] = [row[`${name}.d.lo`], row[`${name}.d.hi`]];
  if (!Number.isFinite(low) || !Number.isFinite(high)) return { text: '', kind: '' };
  if (low <= 0 && high >= 0) return { text: 'not told apart yet', kind: 'open' };
  const less = high < 0, [then, now] = [of_row(name, before), of_row(name, row)];
  const other_class =
    then && now && then[0] === then[1] && now[0] === now[1] && (less ? now[0] < then[0] : now[0] > then[0]);
  if (
    /^DGP[uf]?$/.test(name) && !/^(view|size)/.test(what) &&
    (other_class || (less ? high < -threshold : low > threshold)))
    return less ? { text: 'better', kind: 'good' } : { text: 'worse', kind: 'bad' };
  return { text: less ? 'lower' : 'higher', kind: 'other' };
}
