// The verdict, always in sight: class of glare in words with its number, and what the programs do.
import { glare_of, looking, verdict } from '/judge.js';

const $ = (id) => document.getElementById(id);

// Words are written only where they change: they are read aloud.
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// The state of the programs, as the server reports it.
export function state_of({refused, lost, ended, paused, rests, what, settled, since}) {
  if (refused) return 'this link is not the one that vcview printed';
  if (lost) return 'the connection to vcview is lost: the page tries again';
  if (ended !== undefined)
    return `the programs have ended${
      ended === 0 ? '' : ` with status ${ended}`}: the last picture stays, and can be saved`;
  if (since === undefined) return 'waiting for the first picture';
  if (paused) return 'paused';
  if (what === 'preview') return 'preview';
  if (settled) return `settled after ${settled} frames${rests ? ', rests' : ''}`;
  if (rests) return 'rests';
  return since > 30 ? `no picture for ${Math.round(since)} s` : 'running';
}

// What is said of glare now.  lines: of vcmetrics; first: a row of a small picture of the model at hand, which comes
// sooner than numbers of the larger one; waits: the picture is of an earlier model.
export function glare_now(lines, {first, waits, ended}) {
  const row = lines.rows[lines.rows.length - 1], name = glare_of(lines.columns, row),
        none = { text: '', kind: '', number: '', told: '' };
  const large = waits ? null : verdict(name, row), small = first ? {...verdict('DGPf', first), small: true } : null;
  if (large?.text && !lines.columns.includes(`${name}.lo`))
    return {...none, text: 'no class', number: `${name} has no interval (vcmetrics -ci)` };
  const known = [large, small].find((v) => v?.kind.startsWith('class')) ?? [large, small].find((v) => v?.number);
  if (known) return known;
  if (large && !large.text) return large;
  return {...none, text: ended === undefined ? looking : 'not known', kind: 'looking' };
}

export function show_verdict(lines, state) {
  const { text, kind, number, told, small } = glare_now(lines, state);
  const settled = state.waits ? undefined : lines.rows.find((r) => r.settled > 0)?.frame;
  write($('verdict'), text);
  $('verdict').className = kind;
  write($('glare'), number + (small ? ', of a small picture' : ''));
  write($('glare-means'), told);
  write($('state'), state_of({...state, settled }));
  $('state').className = state.lost || state.ended !== undefined ? 'bad' : '';
}
