// The lines of vcmetrics: read, shown as a table, drawn as SVG over the number of frames with their intervals.
import { limits } from '/judge.js';
import { meaning } from '/metrics.js';
import { alike } from '/picture.js';
import { round_steps } from '/scale.js';
import { keep, one_stop, row_of } from '/table.js';

const classes = {
  DGP: limits,
  DGPu: limits,
  DGPf: limits,
  UGR: [13, 16, 19, 22, 25, 28]
};
// Effect of pixels on a metric: evalglare's (DGP, DGPu) lack it, DGPf has it.
const of_pixels = (name, row) =>
  name.endsWith('f') ? -row[`${name.slice(0, -1)}.px`] : row[`${name.replace(/u$/, '')}.px`];
const beside = /\.(lo|hi|d)$/, most_runs = 12;
const no_metric = new Set(['frame', 'seconds', 'tails', 'errors', 'view', 'sky', 'edit', 'settled']);

// Lines become rows of numbers by name, in runs: a run is what one edit of the scene has brought.  A line of names
// begins a new table, a smaller number of frames or another edit a new run.
export class Lines {
  // keeps: numbers of edits whose lines stay.
  constructor() {
    this.keeps = new Set();
    this.text = [];
    this.runs = [];
    this.columns = [];
    this.seen = new Set();
  }

  get rows() { return this.runs[this.runs.length - 1]?.rows ?? []; }

  add(line) {
    this.text.push(line);
    if (line.startsWith('{')) {
      try {
        return this.take(Object.entries(JSON.parse(line)));
      } catch {
        return;
      }
    }
    const cells = line.split(line.includes('\t') ? '\t' : ',');
    if (
      cells.some((c) => /^[A-Za-z_]/.test(c) && !/^(nan|inf)$/i.test(c)) &&
      (cells.includes('frame') || !this.columns.length)) {
      this.columns = cells;
      return;
    }
    if (cells.length === this.columns.length) this.take(cells.map((c, k) => [this.columns[k], c]));
  }

  take(entries) {
    const row = {};
    for (const [name, value] of entries)
      row[name] = value === null || value === '-' || value === '' ? NaN : Number(value);
    if (!this.columns.length) this.columns = Object.keys(row);
    for (const name in row)
      if (Number.isFinite(row[name])) this.seen.add(name);
    const run = this.runs[this.runs.length - 1], last = run?.rows[run.rows.length - 1];
    if (!run || row.edit !== run.edit || row.frame < last.frame) this.runs.push({ edit: row.edit, rows: [row] });
    else if (row.frame === last.frame) run.rows[run.rows.length - 1] = row;  // measured anew: a region has changed
    else run.rows.push(row);
    const old = this.runs.filter((r) => !this.keeps.has(r.edit));
    if (old.length > most_runs) this.runs = this.runs.filter((r) => r !== old[0]);
  }

  csv() { return this.text.map((line) => line.replaceAll('\t', ',')).join('\n') + '\n'; }

  // Columns that have had a number.
  metrics() { return this.columns.filter((c) => !beside.test(c) && !no_metric.has(c) && this.seen.has(c)); }
}

export function element(name, attributes, text) {
  const e = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
  if (text !== undefined) e.textContent = text;
  return e;
}

const points_of = (name, rows) => {
  const point = (r) => ({
    x: Math.max(r.frame, .5),
    y: r[name],
    lo: r[`${name}.lo`],
    hi: r[`${name}.hi`],
    px: r[name] + of_pixels(name, r),
    settled: r.settled
  });
  return rows.map(point).filter((p) => Number.isFinite(p.x) && Number.isFinite(p.y));
};

// runs: those of Lines; the newest one with its interval, the others as ghosts.
export function plot(name, runs) {
  const width = 420, height = 132, left = 58, right = 8, top = 8, bottom = 32;
  const svg = element('svg', {
    viewBox: `0 0 ${width} ${height}`,
    role: 'img',
    'aria-label': `${[name, meaning(name)[1]].filter(Boolean).join(' in ')} by number of frames`
  });
  const points = points_of(name, runs[runs.length - 1]?.rows ?? []),
        ghosts = runs.slice(0, -1).map((r) => points_of(name, r.rows));
  if (!points.length) return svg;

  const ys = points.flatMap((p) => [p.y, p.lo, p.hi, p.px]).filter(Number.isFinite).sort((a, b) => a - b);
  // early intervals are wide: the axis leaves out the outermost twentieth of what is drawn
  const cut = points.length > 8 ? Math.floor(ys.length / 20) : 0;
  const ends = ghosts.filter((g) => g.length).map((g) => g[g.length - 1].y);
  let low = Math.min(ys[cut], ...ends), high = Math.max(ys[ys.length - 1 - cut], ...ends);
  if (low === high) {
    low -= Math.abs(low) * .01 || 1;
    high += Math.abs(high) * .01 || 1;
  }
  const pad = .08 * (high - low);
  low -= pad;
  high += pad;
  const all = [points, ...ghosts].flat();
  const first = all.reduce((m, p) => Math.min(m, p.x), Infinity),
        last = all.reduce((m, p) => Math.max(m, p.x), first * 2);
  const x = (v) => left + (width - left - right) * Math.log(v / first) / Math.log(last / first);
  const y = (v) => height - bottom - (height - top - bottom) * (v - low) / (high - low);
  const line = (list, name) => list.map((p) => `${x(p.x).toFixed(1)},${y(p[name]).toFixed(1)}`).join('L');

  // what is drawn ends at the axes
  const [w, h] = [width - left - right, height - top - bottom];
  const area = element('svg', { x: left, y: top, width: w, height: h, viewBox: `${left} ${top} ${w} ${h}` });
  for (const [kind, from, to] of [['pixels', 'y', 'px'], ['interval', 'lo', 'hi']]) {
    const band = points.filter((p) => Number.isFinite(p[from]) && Number.isFinite(p[to]));
    if (band.length > 1)
      area.append(element('path', { class: kind, d: `M${line(band, to)}L${line(band.reverse(), from)}Z` }));
  }
  for (const limit of classes[name] ?? (name.endsWith('.CR') ? [.25] : []))  // the paper's 25 %
    if (limit > low && limit < high)
      area.append(element('line', { class: 'class', x1: left, x2: width - right, y1: y(limit), y2: y(limit) }));
  for (const ghost of ghosts)
    if (ghost.length) area.append(element('path', { class: 'ghost', d: 'M' + line(ghost, 'y') }));
  const stop = points.find((p) => p.settled > 0);
  if (stop) area.append(element('line', { class: 'stop', x1: x(stop.x), x2: x(stop.x), y1: top, y2: height - bottom }));
  area.append(element('path', { class: 'curve', d: 'M' + line(points, 'y') }));
  svg.append(area, element('path', { class: 'axis', d: `M${left},${top}V${height - bottom}H${width - right}` }));
  for (const v of round_steps(low, high, false, 4.5))
    svg.append(element('text', { x: left - 4, y: y(v) + 4, 'text-anchor': 'end' }, String(Number(v.toPrecision(5)))));
  for (let v = 1; v <= last; v *= 10)
    if (v >= first) svg.append(element('text', { x: x(v), y: height - 18, 'text-anchor': 'middle' }, String(v)));
  svg.append(element('text', { x: width - right, y: height - 4, 'text-anchor': 'end' }, 'frames (logarithmic)'));
  svg.append(element('text', { x: left + 5, y: top + 10 }, meaning(name)[1]));
  return svg;
}

// The latest values, a row a metric; chosen: names whose curves are drawn; on_choice: called with a name;
// elsewhere(name): is it of a region that was drawn in another view?
export function fill_table(body, lines, chosen, on_choice, elsewhere) {
  const last = lines.rows[lines.rows.length - 1];
  if (!last) return;
  keep(
    body, lines.metrics(), (name) => name,
    (name) => {
      const row = row_of(5);
      row.addEventListener('click', () => on_choice(name));
      row.addEventListener('keydown', (e) => {
        if (e.key === 'Enter' || e.key === ' ') {
          e.preventDefault();
          on_choice(name);
        }
      });
      return row;
    },
    (row, name) => {
      const ends = [last[`${name}.lo`], last[`${name}.hi`]];
      row.setAttribute('aria-selected', String(chosen.has(name)));
      const [words, unit] = meaning(name);
      row.title = elsewhere(name) ? `${words}: drawn in another view` : words;
      row.classList.toggle('elsewhere', elsewhere(name));
      row.setAttribute('aria-label', `${name}: ${words}`);
      [name, ...alike([last[name], ...ends], ...ends), unit].forEach((text, k) => {
        row.cells[k].textContent = text;
      });
    });
  one_stop(body, body.rows);
}
