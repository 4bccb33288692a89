// What the picture shows at a place, as ptrace names it: surfaces from the eye on, with material, file and line.  A
// click offers what can be changed there, and nothing else: the material by name or its colour as one grey, what a line
// repeats and turns, where it stands, a shade or a blind for a pane, also behind the slats of a blind.
import { ask } from '/net.js';
import { short } from '/picture.js';
import { with_material } from '/library.js';
import { colour_of, grey_of, is_movable, numbers_of, things_in } from '/model_text.js';
import { with_grey, with_move, with_number } from '/model_text.js';
import { takes_slats, with_blind, with_shade } from '/shades.js';

const $ = (id) => document.getElementById(id);
const fields = ['name', 'type', 'place', 'material', 'kind', 'defined', 'point', 'reals'];
const is_clear = ({ kind }) => /^(glass|trans|dielectric|interface|BSDF|aBSDF)$/.test(kind);
// Those that are seen: as far as the first one through which nothing is seen.
const seen_of = (all) => { const end = all.findIndex((s) => !is_clear(s)); return end < 0 ? all : all.slice(0, end + 1); };
const two = (v) => String(Number(v.toFixed(2))).replace(/^(-?)0\./, '$1.');
const make = (tag, facts, ...inside) => {
  const e = Object.assign(document.createElement(tag), facts);
  e.append(...inside);
  return e;
};

// A pane, and frames beside it, are a window; else the sun, the sky, a lamp, or a surface by its material.
const glazing = /^(glass|trans|trans2|dielectric|interface|BSDF|aBSDF|BRTDfunc)$/;
function word_of(all, end) {
  const name = `${end.name} ${end.material}`;
  if (all.some((s) => glazing.test(s.kind)) || /window|glaz|pane|rooflight|skylight/i.test(name)) return 'window';
  if (end.type === 'source' && (/sun|solar/i.test(name) || end.kind === 'light')) return 'sun';
  if (end.type === 'source') return /ground/i.test(end.name) ? 'ground' : 'sky';
  if (/^(light|glow|illum|spotlight)$/.test(end.kind)) return 'lamp';
  return end.material.replace(/_/g, ' ');
}

export class Pointed {
  // picture(): { edit, width, height, eye } or null.
  constructor(picture, sliders, library) {
    Object.assign(this, { picture, sliders, materials: library, known: new Map(), edit: null });
  }

  // Surfaces at a pixel, the nearest first, and perhaps a pane behind them; null: not known (any more).
  async at(x, y) {
    const p = this.picture();
    if (!p || p.what === 'preview') return null;
    if (p.edit !== this.edit) [this.edit, this.known] = [p.edit, new Map()];
    const key = `${x} ${y}`, known = this.known;
    if (!known.has(key)) {
      const question =
        new URLSearchParams({ x: ((x + .5) / p.width).toFixed(5), y: (1 - (y + .5) / p.height).toFixed(5) });
      known.set(key, ask(`/what?${question}`).then(async (answer) => {
        if (answer.status !== 200) return known.delete(key), null;
        const words = (await answer.text()).split('\t'), all = [];
        while (words.length >= fields.length)
          all.push(Object.fromEntries(words.splice(0, fields.length).map((word, k) => [fields[k], word])));
        return all;
      }, () => null));
    }
    return known.get(key);
  }

  // For the line below the picture.
  async words(x, y) {
    const all = seen_of(await this.at(x, y) ?? []), end = all[all.length - 1];
    if (!end) return '';
    return `${end.name} (${end.material}, ${end.place})${
      all.length > 1 ? ` behind ${all.slice(0, -1).map((s) => s.name).join(', ')}` : ''}`;
  }

  // What a person calls it, { word, name }; null: not known.
  async called(x, y) {
    const all = seen_of(await this.at(x, y) ?? []), end = all[all.length - 1];
    return end ? { word: word_of(all, end), name: end.name } : null;
  }

  // ---- what can be changed there

  async choose(x, y) {
    $('here-panel').hidden = false;
    $('here-panel').open = true;
    $('here').replaceChildren('…');
    const all = await this.at(x, y);
    $('here').replaceChildren(
      ...all?.length ? all.flatMap((surface) => this.describe(surface)) : ['nothing is known of this place']);
    $('here-panel').scrollIntoView({ block: 'nearest' });
  }

  // The text of a file that the page changes, and what stands on a line of it; null: none.
  find(place) {
    const at = place.lastIndexOf(':'), one = this.sliders.files.find((f) => f.file.name === place.slice(0, at));
    const thing = one && things_in(one.text).find((t) => t.line === Number(place.slice(at + 1)));
    return thing ? { one, thing } : null;
  }

  describe(surface) {
    const { name, type, place, material, kind, defined } = surface;
    const stands = this.find(place), made = this.find(defined);
    const of_it = ` ${type}, ${place}; ${material} ${kind}${defined ? `, ${defined}` : ''}`;
    const parts = [make('p', {}, make('strong', {}, name), of_it)];
    if (made && colour_of(made.thing)) parts.push(...this.material(material, defined));
    if (stands) parts.push(...this.place(name, place));
    const corners = is_clear(surface) ? surface.reals.split(' ').map(Number) : [], file = this.shade_file(stands);
    if (corners.length === 12 && file) parts.push(...this.shades(name, corners, file));
    return parts;
  }

  slider(place, title, least, most, value, words, change) {
    let now = value;
    const step = most === Math.round(most) && Number.isInteger(value) && least === 1 ?
      1 :
      Number(((most - least) / 200).toPrecision(2));
    return this.sliders.slider(title, least, most, step, value, words, (v, going) => {
      const found = this.find(place);
      if (!found) return;
      const [text, said] = change(found.one.text, found.thing, v, now);
      now = v;
      this.sliders.choose(found.one);
      this.sliders.set(text, going, said);
    });
  }

  // By name, where the library has its kind, and as a grey.
  material(name, place) {
    const { one: { text }, thing } = this.find(place), [kinds, like] = this.materials.kinds_of(text, thing);
    if (!kinds.length) return [this.grey(name, place)];
    const select = make('select', {});
    select.append(...like ? [] : [new Option('of its own', '')], ...kinds.map((m) => new Option(m.called, m.name)));
    select.value = like?.name ?? '';
    select.addEventListener('change', () => {
      const found = this.find(place), chosen = kinds.find((m) => m.name === select.value);
      if (!found || !chosen) return;
      this.sliders.choose(found.one);
      this.sliders.set(with_material(found.one.text, found.thing, chosen), false, `${name}: ${chosen.called}`);
      row.replaceWith(...this.material(name, place));
      slider.remove();
    });
    const row = make('label', {}, 'material', select), slider = this.grey(name, place);
    return [row, slider];
  }

  grey(material, place) {
    const { one: { text }, thing } = this.find(place), { value, most } = grey_of(text, thing);
    const radiance = colour_of(thing) === 'radiance';
    const words = radiance ? short : two;
    return this.slider(place, colour_of(thing), 0, most, value, words,
      (now, at, v) => [with_grey(now, at, v), `${material}: ${words(value)} to ${words(v)}`]);
  }

  // What a line repeats and turns, and where it stands.
  place(name, place) {
    const { one: { text }, thing } = this.find(place), all = numbers_of(text, thing), line = place.replace(/.*[/]/, '');
    const several = !thing.command ? [] : [(n) => n.whole, (n) => /^-r[xyz]$/.test(n.option)]
      .map((is) => all.findIndex(is)).filter((k) => k >= 0).sort((a, b) => a - b).map((k) => [all[k], k]);
    const moves = is_movable(text, thing) ? ['moved along x', 'moved along y', 'moved up'] : [];
    return [
      ...several.map(
        ([n, k]) => this.slider(place, n.whole ? 'repeated' : 'turned, degrees', n.whole ? 1 : n.value - 90,
          n.whole ? Math.max(8, 2 * n.value) : n.value + 90, n.value, (v) => two(v),
          (now, at, v) => [with_number(now, numbers_of(now, at)[k], v), `${line}: ${two(n.value)} to ${two(v)}`])),
      ...moves.map(
        (title, axis) => this.slider(place, title, -1, 1, 0, two,
          (now, at, v, before) => [with_move(now, at, axis, v - before), `${name} ${title} by ${two(v)}`]))
    ];
  }

  // The file that a shade is added to: that of the surface, else the last one without a sky whose text is known.
  shade_file(stands) {
    const files = this.sliders.files.filter(
      (f) => f.file.writable && f.base !== undefined && !/^!.*\bgen(sky|daylit)\b/m.test(f.text));
    return stands?.one ?? files[files.length - 1];
  }

  shades(name, numbers, one) {
    const corners = [0, 3, 6, 9].map((k) => numbers.slice(k, k + 3)), { vp } = this.picture().eye;
    return [['shade', 'fabric_grey_3', with_shade], ['blind', 'slat_white', with_blind]]
      .filter(([kind]) => kind === 'shade' || takes_slats(corners, vp)).map(([kind, material, add]) => {
        const button = make('button', { type: 'button', textContent: `Add a ${kind} to ${name}` });
        button.addEventListener('click', () => {
          const [text, added] = add(one.text, corners, this.picture().eye.vp, (m) => this.materials.lines(material, m));
          this.sliders.choose(one);
          this.sliders.set(text, false, `${added} added to ${name}`);
          this.show_new(added, one);
        });
        return button;
      });
  }

  // What can be changed of the last material and the last surface of a file.
  show_new(name, one) {
    const [made, stands] = things_in(one.text).slice(-2), place = (thing) => `${one.file.name}:${thing.line}`;
    $('here').replaceChildren(make('p', {}, make('strong', {}, name)), ...this.material(made.name, place(made)),
      ...this.place(name, place(stands)));
  }
}
