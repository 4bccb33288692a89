// Before and after: the lines of each edit, and a table of edits with their metrics and the difference to the edit
// before, as the columns NAME.d NAME.d.lo NAME.d.hi of vcmetrics have it.
import { judged } from '/judge.js';
import { alike, short } from '/picture.js';

const $ = (id) => document.getElementById(id);
const signed = (v, text) => (v > 0 ? '+' : v < 0 ? '−' : '') + text;

export class Edits {
  // on_change: called when the threshold is another one.
  constructor(on_change) {
    this.what = new Map();
    this.all = false;  // metrics; else the glare alone
    $('edits-more').addEventListener('click', () => {
      this.all = !this.all;
      $('edits-more').setAttribute('aria-pressed', String(this.all));
      on_change();
    });
    $('threshold').addEventListener('change', on_change);
  }

  // edits: [number, "overlay words"] of what has been rendered, as vcview holds them.
  // earlier: words of those before the design was opened again.
  // against: what edits are compared with where no variant is the base.
  take(edits, earlier, variants, base, against) {
    const other = base || (against === 'first' ? 'the first edit' : 'the edit before');
    $('edits-say').textContent = `Differences from ${other}`;
    this.what = new Map(edits);
    this.earlier = earlier;
    this.variants = new Map(variants.map((v) => [v.edit, v.name]));
    Object.assign(this, { base, against, of_base: variants.find((v) => v.name === base)?.edit });
  }

  name(edit) {
    if (edit === undefined) return 'now';
    if (this.variants?.has(edit))
      return `${this.variants.get(edit)}${this.variants.get(edit) === this.base ? ' (base)' : ''}`;
    const words = this.what.get(edit) ?? `edit ${edit}`, [, what, said] = /^(overlay|scene)\b *(.*)$/.exec(words) ?? [];
    return what ? said || (what === 'scene' ? 'file saved' : 'model') : words;
  }

  // The newest row of what an edit is compared with, if it is known.
  before(runs, edit) {
    const first = runs.reduce((least, r) => Math.min(least, r.edit), edit);
    const other = this.base ? this.of_base : this.against === 'first' ? first : edit - 1;
    return runs.find((r) => r.edit === other)?.rows.at(-1);
  }

  // runs: of Lines, the newest last; names: metrics; glare: the one of them that is always shown.
  fill(runs, names, glare) {
    if (!this.all && names.includes(glare)) names = [glare];
    const many = runs.length > 1 || this.earlier?.length;
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
      row(
        'td',
        [
          this.name(run.edit), String(last.frame),
          ...names.map((n) => this.cell(n, last, this.before(runs, run.edit), this.what.get(run.edit) ?? ''))
        ],
        table.tBodies[0]);
    }
    for (const words of [...this.earlier ?? []].reverse())
      row('td', [words, '–', ...names.map(() => '–')], table.tBodies[0]);
  }

  cell(name, row, before, what) {
    const value = Number.isFinite(row[name]) ? short(row[name]) : '–', d = row[`${name}.d`];
    if (!Number.isFinite(d)) return value;
    const low = row[`${name}.d.lo`], high = row[`${name}.d.hi`],
          { text, kind } = judged(name, row, before, what, Number($('threshold').value));
    const [by, from, to] = [d, low, high].map((v, k, all) => signed(v, alike(all.map(Math.abs), low, high)[k]));
    const change = document.createElement('span'), word = document.createElement('strong');
    change.className = 'change';
    change.textContent = by;
    const parts = [value, document.createElement('br'), change];
    if (Number.isFinite(low)) {
      const interval = document.createElement('span');
      interval.className = 'change';
      interval.textContent = `(${from} to ${to})`;
      parts.push(' ', interval);
    }
    word.className = kind;
    word.textContent = text;
    return [...parts, ' ', word];
  }
}
