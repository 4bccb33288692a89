// Before and after: the lines of each edit, and a table of edits with their metrics and the difference to the edit before,
// as the columns NAME.d NAME.d.lo NAME.d.hi of vcmetrics have it.
import { short } from '/picture.js';

const $ = (id) => document.getElementById(id);
// Less of these is less glare.
const glare = /^(DGP|DGI|UGR|CGI|UGP|DGR|PGSV|Lveil|n_sources)/;

// { text, of } of a difference with its interval.
export function verdict(name, low, high) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return { text: '', kind: '' };
  if (low <= 0 && high >= 0) return { text: 'not told apart yet', kind: 'open' };
  const less = high < 0;
  if (glare.test(name) && !name.endsWith('.px')) return less ? { text: 'better', kind: 'good' } : { text: 'worse', kind: 'bad' };
  if (/^VCP/.test(name)) return less ? { text: 'worse', kind: 'bad' } : { text: 'better', kind: 'good' };
  return { text: less ? 'lower' : 'higher', kind: 'other' };
}

const signed = (v) => (v > 0 ? '+' : v < 0 ? '−' : '') + short(Math.abs(v), 3);

export class Edits {
  constructor() { this.what = new Map(); }

  // A picture tells what its edit was.
  // said: words of the page for what it has changed.
  note(edit, what, said) {
    if (edit === undefined || what === 'preview' || this.what.has(edit)) return;
    this.what.set(edit, what === 'overlay' ? said || 'model' : what === 'scene' ? 'file saved' : what);
  }
  name(edit) { return edit === undefined ? 'now' : this.what.get(edit) ?? `edit ${edit}`; }

  // runs: of Lines, the newest last; names: metrics.
  fill(runs, names) {
    const many = runs.length > 1;
    $('edits-panel').hidden = !many;
    if (!many) return;
    const row = (tag, texts, section) => {
      const tr = document.createElement('tr');
      tr.append(...texts.map((t) => {
        const cell = document.createElement(tag);
        if (tag === 'th') cell.scope = 'col';
        cell.append(...[t].flat());
        return cell;
      }));
      section.append(tr);
    };
    const table = $('edits');
    table.tHead.replaceChildren();
    table.tBodies[0].replaceChildren();
    row('th', ['edit', 'frames', ...names], table.tHead);
    for (const run of [...runs].reverse()) {
      const last = run.rows[run.rows.length - 1];
      row('td', [this.name(run.edit), String(last.frame), ...names.map((n) => this.cell(n, last))], table.tBodies[0]);
    }
  }

  cell(name, row) {
    const value = Number.isFinite(row[name]) ? short(row[name]) : '–', d = row[`${name}.d`];
    if (!Number.isFinite(d)) return value;
    const low = row[`${name}.d.lo`], high = row[`${name}.d.hi`], { text, kind } = verdict(name, low, high);
    const change = document.createElement('span'), word = document.createElement('strong');
    change.className = 'change';
    change.textContent = signed(d);
    const parts = [value, document.createElement('br'), change];
    if (Number.isFinite(low)) {
      const interval = document.createElement('span');
      interval.className = 'change';
      interval.textContent = `(${signed(low)} to ${signed(high)})`;
      parts.push(' ', interval);
    }
    word.className = kind;
    word.textContent = text;
    return [...parts, ' ', word];
  }
}
