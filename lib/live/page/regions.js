// Regions: outlines over the picture, drawn, moved and deleted by pointer and keys, named and edited in a table; each
// change is saved to the region file at once.
import { ask } from '/net.js';
import { dot_at, inside, label, outline, top_of } from '/overlay.js';
import { tell } from '/messages.js';
import { add, free_name, is_elsewhere, regions_of, remove, replace, seen_from, set_region } from '/region_file.js';
import { fill, keep, row_of } from '/table.js';
import { dragged, handles, parse_shape, shape_text, sketch } from '/shapes.js';
import { TextFile } from '/text_file.js';

const $ = (id) => document.getElementById(id);
const pair = ['low', 'high'];
const grasp = 9;  // CSS pixels around a handle

export class Regions {
  // view: the PictureView; picture(): { eye, width, height } or null.
  constructor(view, picture) {
    this.view = view;
    this.picture = picture;
    this.text = '';      // of the file, with changes that are still on their way to it
    this.entries = [];   // of that text
    this.waiting = 0;    // changes on their way
    this.outlines = new Map();
    this.selected = null;  // a name
    this.drawing = null;   // { kind, points } while a new one is drawn
    this.drag = null;
    for (const kind of ['circle', 'rect', 'polygon']) $(`draw-${kind}`).addEventListener('click', () => this.begin(kind));
    $('draw-pair').addEventListener('click', () => this.begin('rect', pair));
    for (const name of pair) $(`contrast-${name}`).addEventListener('change', (e) => this.save(set_region(name, e.target.value)));
    view.overlays.push((...c) => this.draw(...c));
  }

  async use(n, facts) {
    this.file = new TextFile(n, facts);
    $('regions-panel').hidden = false;
    $('regions-file').textContent = facts.writable ? facts.name : `${facts.name} (shown only; -regions lets the page write it)`;
    document.querySelectorAll('#regions-panel .bar button').forEach((b) => { b.disabled = !facts.writable; });
    await this.reload();
  }

  async reload() {
    if (!this.file) return;
    const before = this.file.tag;
    try {
      await this.file.read();
    } catch (e) {
      return this.say(e.message);
    }
    if (this.file.tag !== before) await this.show();
  }

  // The table anew and, from the server, the outlines in the picture at hand.
  async show() {
    if (this.waiting) return;  // the last of them shows all
    this.read_as(this.file.text);
    if (!this.entries.some((r) => r.name === this.selected)) this.selected = null;
    this.fill_table();
    this.fill_contrast();
    await this.fetch_outlines();
  }

  async fetch_outlines() {
    if (!this.file || !this.picture()) return;
    if (this.fetching) { this.again = true; return; }
    this.fetching = true;
    try {
      const answer = await ask(`/outlines?n=${this.file.n}`);
      if (answer.ok) this.outlines = new Map((await answer.json()).map((r) => [r.name, r]));
      else if (answer.status === 409) this.say((await answer.text()).trim());
      this.outlines.forEach((r) => { r.css = `rgb(${r.colour.map((v) => Math.round(v + .4 * (255 - v)))})`; });
      this.mark_rows();
      this.view.draw();
    } finally {
      this.fetching = false;
      if (this.again) { this.again = false; this.fetch_outlines(); }
    }
  }

  // ---- the table

  fill_table() {
    keep($('regions').tBodies[0], this.entries, (r) => r.name, () => this.new_row(), (row, r) => {
      const [name, definition, away] = row.querySelectorAll('input, button');
      row.dataset.region = name.dataset.region = definition.dataset.region = r.name;
      fill(name, r.name);
      fill(definition, r.definition);
      definition.setAttribute('aria-label', `what ${r.name} is`);
      away.setAttribute('aria-label', `delete ${r.name}`);
    });
    this.mark_rows();
  }

  new_row() {
    const row = row_of(3), swatch = document.createElement('span'), away = document.createElement('button');
    const now = () => this.entries.find((r) => r.name === row.dataset.region);
    const field = (kind, changed) => {
      const input = document.createElement('input');
      Object.assign(input, { className: kind, spellcheck: false, autocomplete: 'off', readOnly: !this.file.writable });
      input.addEventListener('focus', () => this.select(row.dataset.region));
      input.addEventListener('change', () => now() && changed(input.value.trim().replace(/\s+/g, ' '), now()));
      return input;
    };
    swatch.className = 'swatch';
    const name = field('name', async (v, r) => {
      const saved = this.save(replace(r, v, r.definition), v);
      row.dataset.key = v;  // the row stays, and what follows is of that name
      this.fill_table();
      await saved;
      if (!this.entries.some((e) => e.name === v)) row.dataset.key = r.name;
      this.fill_table();
    });
    name.setAttribute('aria-label', 'name');
    row.cells[0].append(swatch, name);
    row.cells[1].append(field('definition', (v, r) => this.save(replace(r, r.name, v), r.name)));
    Object.assign(away, { type: 'button', textContent: '×', disabled: !this.file.writable });
    away.addEventListener('click', () => now() && this.save(remove(now())));
    row.cells[2].append(away);
    return row;
  }

  // Two regions of one contrast ratio: those that "low" and "high" stand for in the file, which luxpipe-live measures.
  fill_contrast() {
    const names = this.entries.map((r) => r.name).filter((name) => !pair.includes(name));
    $('contrast').hidden = names.length < 2 || !this.file.writable;
    for (const name of pair) {
      const now = this.entries.find((r) => r.name === name)?.definition ?? '';
      keep($(`contrast-${name}`), ['', ...names], (n) => n, (n) => Object.assign(new Option(n, n), { disabled: !n }));
      $(`contrast-${name}`).value = names.includes(now) ? now : '';
    }
  }

  mark_rows() {
    for (const row of $('regions').tBodies[0].rows) {
      const o = this.outlines.get(row.dataset.region);
      row.setAttribute('aria-selected', String(row.dataset.region === this.selected));
      row.querySelector('.swatch').style.background = o?.css ?? 'transparent';
      const elsewhere = this.elsewhere(row.dataset.region);
      row.title = o?.trouble ?? (o && !o.rings.length ? 'out of sight' : elsewhere ? 'drawn from another place or view' : '');
      row.classList.toggle('trouble', Boolean(o?.trouble));
      row.classList.toggle('elsewhere', elsewhere);
    }
    const all = this.entries.map((r) => r.name).filter((name) => this.elsewhere(name)), several = all.length > 1;
    $('regions-elsewhere').textContent = all.length ? `${all.join(', ')} ${several ? 'are parts' : 'is a part'} of the picture, drawn in another view: `
      + `${several ? 'their' : 'its'} numbers are of what is there now. Move ${several ? 'them' : 'it'}, or go back to that view.` : '';
  }

  // Was it drawn in another view?
  elsewhere(name) {
    const region = this.entries.find((r) => r.name === name), eye = this.picture()?.eye;
    return Boolean(region && eye) && is_elsewhere(region, this.entries, eye);
  }

  // A column of vcmetrics is of such a region: low/high.CR.
  of_elsewhere(column) {
    const dot = column.lastIndexOf('.');
    return dot > 0 && column.slice(0, dot).split('/').some((name) => this.elsewhere(name));
  }

  select(name) {
    this.selected = name;
    this.mark_rows();
    this.view.draw();
  }

  // ---- saving

  read_as(text) { [this.text, this.entries] = [text, regions_of(text)]; }

  // A change in what the page shows, at once, so that the next one begins from it; and in the file.
  async put(change) {
    const next = change(this.text);
    if (next !== null) this.read_as(next);
    this.waiting++;
    try { return await this.file.save(change); } finally { this.waiting--; }
  }

  say(text, ...choices) {
    $('regions-say').replaceChildren(text, ...choices.map(([title, act]) => {
      const button = document.createElement('button');
      Object.assign(button, { type: 'button', textContent: title });
      button.addEventListener('click', act);
      return button;
    }));
  }

  async save(change, select = this.selected) {
    const said = await this.put(change);
    if (said === 'conflict') {
      await this.show();
      const text = `${this.file.name} was changed by another program, which this change does not fit: `
        + 'it is as that program left it.';
      tell(text);
      return this.say(text);
    }
    if (said || !this.drawing) this.say(said);
    if (said) return this.read_as(this.file.text);
    this.selected = select;
    await this.show();
  }

  shape_of(name) {
    const region = this.entries.find((r) => r.name === name);
    return region && parse_shape(region.definition);
  }

  // The selected region after its shape has changed.
  async change_shape(shape) {
    const region = this.entries.find((r) => r.name === this.selected);
    const seen = seen_from(shape, this.picture().eye), text = shape_text(shape);
    const mine = replace(region, region.name, text, true, seen), said = await this.put(replace(region, region.name, text, false, seen));
    if (said !== 'conflict') { this.say(said); return this.show(); }
    await this.show();
    const theirs = this.entries.find((r) => r.name === region.name);
    this.say(theirs ? `${region.name} was changed in the file meanwhile (it is shown as there). Yours is: ${shape_text(shape)} `
      : `${region.name} was deleted in the file meanwhile. Yours is: ${shape_text(shape)} `,
    ['Use mine', () => this.save(theirs ? mine : add(region.name, text, seen), region.name)],
    ['Keep the file’s', () => this.say('')]);
  }

  // ---- drawing a new one

  // names: of so many one after another; else the user who draws it names it.
  begin(kind, names = []) {
    const picture = this.picture();
    if (!picture || !this.file?.writable) return;
    this.drawing = { kind, points: [], names };
    this.say(names.length ? `Drag over ${names[0] === pair[0] ? 'the darker part' : 'the brighter part'}; Escape ends.` : { circle: 'Drag from the centre outward', rect: 'Drag from corner to corner',
      polygon: 'Click at each corner; Enter or a click on the first ends it' }[kind] + '. Enter draws one in the middle; Escape ends.');
    $('canvas').focus();
  }

  async end(shape) {
    const { kind, names } = this.drawing;
    this.drawing = null;
    this.drag = null;
    this.say('');
    if (!shape) return this.view.draw();
    if (names.length > 1) this.begin(kind, names.slice(1));
    const seen = seen_from(shape, this.picture().eye);
    if (names.length) return this.save(set_region(names[0], shape_text(shape), seen), names[0]);
    const name = free_name(this.text), saved = this.save(add(name, shape_text(shape), seen), name);
    this.fill_table();  // the user goes on and types its name
    const field = document.querySelector(`#regions .name[data-region="${name}"]`);
    field?.focus();
    field?.select();
    await saved;
    this.fill_table();
  }

  new_shape(kind, from, to) {
    const { eye, width, height } = this.picture();
    if (kind === 'rect') return { kind, frame: 'fraction', points: [from, to], rest: [] };
    const centre = eye.direction(from);
    if (!centre) return null;
    return dragged({ kind, frame: 'direction', points: [centre], angle: 1, rest: [] }, { size: true }, from, to, eye, [width, height]);
  }

  end_polygon() {
    const { eye } = this.picture(), points = this.drawing.points.map((p) => eye.direction(p));
    this.end(points.length >= 3 && points.every(Boolean) ? { kind: 'polygon', frame: 'direction', points, rest: [] } : null);
  }

  // ---- pointer: at is { x, y } in pixels of the picture, place in fractions, y up.  True: taken.

  down(at, place, reach) {
    if (!this.file?.writable) return false;
    if (this.drawing?.kind === 'polygon') {
      const first = this.drawing.points[0];
      if (this.drawing.points.length >= 3 && this.near(first, at, reach)) this.end_polygon();
      else this.drawing.points.push(place);
      this.view.draw();
      return true;
    }
    if (this.drawing) {
      this.drawing.points = [place, place];
      return true;
    }
    const shape = this.shape_of(this.selected);
    const handle = shape && this.handles(shape).find((h) => this.near(h.place, at, reach));
    if (handle) return this.take(shape, handle, place);
    const hit = [...this.outlines.values()].reverse().find((r) => r.rings && inside(r.rings, at.x, at.y));
    if (!hit) {
      if (this.selected) this.select(null);
      return false;
    }
    const was = this.selected === hit.name;
    this.select(hit.name);
    if (was && this.shape_of(hit.name)) return this.take(this.shape_of(hit.name), null, place);
    return false;
  }

  near(place, at, reach) {
    const { width, height } = this.picture();
    return Math.hypot(place[0] * width - at.x, (1 - place[1]) * height - at.y) <= grasp * reach;
  }

  take(shape, handle, place) {
    this.drag = { shape, handle, from: place, now: shape };
    return true;
  }

  move(at, place) {
    if (this.drawing) {
      if (this.drawing.kind === 'polygon') this.drawing.end = place;
      else if (this.drawing.points.length) this.drawing.points[1] = place;
      this.view.draw();
    } else if (this.drag) {
      const { eye, width, height } = this.picture();
      this.drag.now = dragged(this.drag.shape, this.drag.handle, this.drag.from, place, eye, [width, height]);
      this.view.draw();
    }
  }

  up() {
    if (this.drawing && this.drawing.kind !== 'polygon' && this.drawing.points.length) {
      const [from, to] = this.drawing.points;
      if (from !== to) this.end(this.new_shape(this.drawing.kind, from, to));
    } else if (this.drag) {
      const { now, shape } = this.drag;
      this.drag = null;
      if (shape_text(now) !== shape_text(shape)) this.change_shape(now);
    }
  }

  // ---- keys on the picture.  True: taken.

  key(e) {
    if (this.drawing) {
      if (e.key === 'Escape') this.end(null);
      else if (e.key === 'Enter' && this.drawing.points.length > 2) this.end_polygon();
      else if (e.key === 'Enter') {
        const middle = [[.4, .4], [.6, .4], [.6, .6], [.4, .6]];
        if (this.drawing.kind !== 'polygon') this.end(this.drawing.kind === 'rect' ? this.new_shape('rect', middle[0], middle[2])
          : this.new_shape('circle', [.5, .5], [.6, .5]));
        else { this.drawing.points = middle; this.end_polygon(); }
      } else return false;
      return true;
    }
    if (e.key === 'n' && this.entries.length) {
      const k = this.entries.findIndex((r) => r.name === this.selected);
      this.select(this.entries[(k + 1) % this.entries.length].name);
      return true;
    }
    const region = this.entries.find((r) => r.name === this.selected);
    if (!region) return false;
    if (e.key === 'Escape') { this.select(null); return true; }
    if (!this.file.writable) return false;
    if (e.key === 'Delete' || e.key === 'Backspace') { this.save(remove(region), null); return true; }
    const shape = parse_shape(region.definition), step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (!shape || !(step || e.key === '<' || e.key === '>')) return false;
    const { eye, width, height } = this.picture(), by = e.shiftKey && step ? 10 : 1, size = [width, height];
    const of = step ? this.handles(shape)[0] : this.handles(shape).find((h) => h.size);
    if (!of) return true;
    const to = step ? [of.place[0] + by * step[0] / width, of.place[1] + by * step[1] / height]
      : [of.place[0] + (e.key === '>' ? 1 : -1) / width, of.place[1]];
    this.change_shape(dragged(shape, step ? null : of, of.place, to, eye, size));
    return true;
  }

  // ---- over the picture

  handles(shape) {
    const { eye, width, height } = this.picture();
    return handles(shape, eye, [width, height]);
  }

  draw(c, to, unit) {
    const picture = this.picture();
    if (!picture) return;
    const { eye, width, height } = picture, place = ([x, y]) => to(x * width, (1 - y) * height);
    const ring = (places) => places.flatMap(([x, y]) => [x * width, (1 - y) * height]);
    for (const r of this.outlines.values()) {
      if (!r.rings || (this.drag && r.name === this.selected)) continue;
      outline(c, r.rings, to, unit, r.css, r.name === this.selected ? 2.5 : 1.5);
    }
    for (const r of this.outlines.values()) {
      const top = r.rings && top_of(r.rings);
      if (!top) continue;
      const [x, y] = to(...top);
      label(c, r.name, x, y - 6 * unit, unit, r.css);
    }
    const shape = this.drag?.now ?? this.shape_of(this.selected);
    if (shape) {
      if (this.drag) outline(c, [ring(sketch(shape, eye, [width, height]))], to, unit, '#fff', 2);
      if (this.file.writable)
        handles(shape, eye, [width, height]).forEach((h) => dot_at(c, ...place(h.place), unit, h.size ? '#ffd24a' : '#fff'));
    }
    if (this.drawing?.kind === 'polygon') {
      const points = [...this.drawing.points, this.drawing.end].filter(Boolean);
      outline(c, [ring(points)], to, unit, '#fff', 2);
      this.drawing.points.forEach((p) => dot_at(c, ...place(p), unit, '#fff'));
    } else if (this.drawing?.points.length) {
      const fresh = this.new_shape(this.drawing.kind, ...this.drawing.points);
      if (fresh) outline(c, [ring(sketch(fresh, eye, [width, height]))], to, unit, '#fff', 2);
    }
  }

  // The middle of the chosen region, if it lies in space: the camera turns around it.
  pivot() {
    const shape = this.shape_of(this.selected);
    if (shape?.frame !== 'space') return null;
    return [0, 1, 2].map((k) => shape.points.reduce((sum, p) => sum + p[k], 0) / shape.points.length);
  }

  // Names of regions at a pixel.
  at(x, y) { return [...this.outlines.values()].filter((r) => r.rings && inside(r.rings, x + .5, y + .5)).map((r) => r.name); }
}
