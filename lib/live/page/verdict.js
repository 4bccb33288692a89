// The verdict, always in sight: class of glare in words with its number, and what the programs do.
const $ = (id) => document.getElementById(id);

// DGP's classes (Wienold and Christoffersen 2006): a word and a sign each, so that colour says nothing alone.
const limits = [.35, .40, .45], words = ['imperceptible', 'perceptible', 'disturbing', 'intolerable'], signs = ['○', '◔', '◑', '●'];
export const class_of = (dgp) => limits.filter((limit) => dgp >= limit).length;
// The first that has a value: pictures without moments have no DGPf.
export function glare_of(names, row) {
  const all = ['DGPf', 'DGPu', 'DGP'].filter((name) => names.includes(name));
  return all.find((name) => Number.isFinite(row?.[name])) ?? all[0];
}
const black = 'no light reaches the eye: it is night, the eye is in a solid or below the ground, or the scene has no sky and no lamp';

const three = (v) => v.toFixed(3).replace(/^0/, '');

// { text, kind } of a row of numbers; kind: 0 to 3 of the worst class that the interval holds.
export function verdict(name, row) {
  const value = row?.[name], ends = [row?.[`${name}.lo`], row?.[`${name}.hi`]];
  if (!Number.isFinite(value)) return { text: '', kind: '', number: '' };
  if (row.Ev === 0) return { text: '', kind: '', number: row.frame === 0 ? '' : black };  // frame 0 may lack all of its light
  const told = ends.every(Number.isFinite), [low, high] = told ? ends.map(class_of) : [class_of(value), class_of(value)];
  return { text: `${signs[high]} ${low === high ? '' : `${words[low]} to `}${words[high]}`, kind: `class${high}`,
    number: `${name} ${three(value)}${told ? ` (${three(ends[0])} to ${three(ends[1])})` : ''}` };
}

// Words are written only where they change: they are read aloud.
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// The state of the programs, as the server reports it.
export function state_of({ refused, lost, ended, paused, what, settled, since }) {
  if (refused) return 'this link is not the one that vcview printed';
  if (lost) return 'the connection to vcview is lost: the page tries again';
  if (ended !== undefined) return `the programs have ended${ended === 0 ? '' : ` with status ${ended}`}: the last picture stays, and can be saved`;
  if (since === undefined) return 'waiting for the first picture';
  if (paused) return 'paused';
  if (what === 'preview') return 'preview';
  if (settled) return `settled after ${settled} frames`;
  return since > 30 ? `no picture for ${Math.round(since)} s` : 'running';
}

export function show_verdict(lines, state) {
  const row = lines.rows[lines.rows.length - 1], { text, kind, number } = verdict(glare_of(lines.columns, row), row);
  const settled = lines.rows.find((r) => r.settled > 0)?.frame;
  write($('verdict'), text);
  $('verdict').className = kind;
  write($('glare'), number);
  write($('state'), state_of({ ...state, settled }));
  $('state').className = state.lost || state.ended !== undefined ? 'bad' : '';
}
