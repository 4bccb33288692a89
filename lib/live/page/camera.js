// The camera by pointer and keys: look around, orbit, walk.  The page computes the view and sends it over ptrace's
// FIFO: a small picture (`preview`) while it moves, the newest one only when the last has come; the full one (`view`)
// at rest.
import { tell } from '/messages.js';
import { command, post } from '/net.js';
import { short } from '/picture.js';
import { keep } from '/table.js';
import { cross, dot, length, plus, turned, unit } from '/view.js';

const $ = (id) => document.getElementById(id);
const rest = 350, patience = 2500;  // ms: without a move; for a preview
const degree = Math.PI / 180;
const digits = (v) => v.map((x) => String(Number(x.toFixed(5)))).join(' ');

export class Camera {
  // picture(): { eye, ... } or null; pivot(): a point to orbit around, or null.
  constructor(picture, pivot) {
    this.picture = picture;
    this.pivot = pivot;
    this.view = null;       // { vp, vd } where it moves to; null: at rest
    this.waiting = 0;       // when the preview that has not come yet was sent
    this.previews = true;   // does ptrace make them?
    $('back').addEventListener('click', () => post('/back').then((wrong) => this.say(wrong)));
    $('place-keep').addEventListener('click', async () => {
      this.say(await post(`/place?${new URLSearchParams({ do: 'keep', name: $('place-name').value })}`));
      $('place-name').value = '';
    });
    for (const id of ['azimuth', 'elevation'])
      $(id).addEventListener('change', () => this.aim(Number($('azimuth').value), Number($('elevation').value)));
    for (const [id, by] of [['left', -45], ['right', 45]])
      $(id).addEventListener('click', () => this.aim(Number($('azimuth').value) + by, Number($('elevation').value)));
    $('drag').addEventListener('change', () => { $('canvas').style.cursor = this.mode === 'picture' ? '' : 'grab'; });
  }

  get mode() { return $('drag').value; }
  show() { $('walk-keys').hidden = false; this.on = true; }

  // Views as vcview holds them: the latest last; and those with a name.
  take(views, places) {
    const go = (view) => command(`view ${view}`).then((wrong) => this.say(wrong));
    $('back').disabled = views.length < 2;
    $('home').onclick = () => go(views[0]);
    const button = (textContent, does, label) => {
      const b = Object.assign(document.createElement('button'), { type: 'button', textContent });
      b.setAttribute('aria-label', label);
      b.addEventListener('click', does);
      return b;
    };
    keep($('places'), places, (place) => place.join(' '), ([name, view]) => {
      const item = document.createElement('li');
      item.append(button(name, () => go(view), `view ${name}`), ' ',
        button('×', () => post(`/place?name=${encodeURIComponent(name)}`).then((wrong) => this.say(wrong)),
          `delete view ${name}`));
      return item;
    });
    this.places = places;
    this.options = views[views.length - 1];
    this.read_out();
  }

  // The name of the view, or which way it looks.
  called() {
    const now = this.now(), named = this.places?.find(([, view]) => view === this.options);
    if (named || !now) return named?.[0] ?? '';
    if (Math.abs(now.vd[2]) > .9) return now.vd[2] > 0 ? 'looking up' : 'looking down';
    const way = Math.round(Math.atan2(now.vd[0], now.vd[1]) / degree / 45 + 8) % 8;
    return `looking ${['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west', 'north-west'][way]}`;
  }

  // Degrees: from north over east, and up.
  read_out() {
    const now = this.now();
    if (!now) return;
    const texts =
      [Math.atan2(now.vd[0], now.vd[1]) / degree, Math.asin(Math.max(-1, Math.min(1, now.vd[2]))) / degree].map(
        (v) => v.toFixed(1));
    ['azimuth', 'elevation'].forEach((id, k) => {
      if (document.activeElement !== $(id)) $(id).value = (k ? texts[1] : (Number(texts[0]) + 360) % 360);
    });
    $('eye-at').textContent = `from ${now.vp.map((v) => short(v)).join(', ')}`;
  }

  aim(azimuth, elevation) {
    const from = this.now(), [a, e] = [azimuth * degree, Math.max(-85, Math.min(85, elevation)) * degree];
    if (from) this.set({ ...from, vd: [Math.cos(e) * Math.sin(a), Math.cos(e) * Math.cos(a), Math.sin(e)] });
  }

  now() {
    const eye = this.picture()?.eye;
    return this.view ?? (eye && eye.type !== 'l' ? { vp: eye.vp, vd: eye.vd, vu: eye.vu } : null);
  }

  // ---- pointer: a taker of pointer.js

  down(at, place) {
    const eye = this.picture()?.eye;
    if (!this.on || !eye || this.mode === 'picture' || !this.now()) return false;
    this.drag = { eye, from: this.now(), direction: eye.direction(place), place };
    return true;
  }

  move(at, place) {
    const { eye, from, direction } = this.drag, to = eye.direction(place);
    if (this.mode === 'orbit') {
      const [dx, dy] = [place[0] - this.drag.place[0], place[1] - this.drag.place[1]];
      this.set(orbited(from, this.pivot() ?? plus(from.vp, from.vd, 2), -dx * Math.PI, -dy * Math.PI / 2));
    } else if (to && direction) {
      const up = unit(from.vu), [a, b] = [angles(direction, from), angles(to, from)];
      this.set({ ...from, vd: pitched(turned(from.vd, up, a[0] - b[0]), up, a[1] - b[1]) });
    }
  }

  up() { this.drag = null; }

  // ---- keys.  True: taken.

  key(e) {
    const from = this.on && this.now();
    if (!from) return false;
    const up = unit(from.vu), step = e.shiftKey ? .5 : .1;
    const ahead = unit(plus(from.vd, up, -dot(from.vd, up))), right = unit(cross(from.vd, up));
    const all = { w: [ahead, 1], s: [ahead, -1], d: [right, 1], a: [right, -1], e: [up, 1], q: [up, -1] };
    const walk = all[e.key.toLowerCase()];
    if (walk) {
      this.set({ ...from, vp: plus(from.vp, walk[0], walk[1] * step) });
      return true;
    }
    const look = e.shiftKey && { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (!look) return false;
    this.set({ ...from, vd: pitched(turned(from.vd, up, look[0] * 5 * degree), up, look[1] * 5 * degree) });
    return true;
  }

  // ---- what is sent

  set(view) {
    this.view = view;
    this.arrived = false;
    this.moved = performance.now();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.arrive(), rest);
    this.send_preview();
  }

  send_preview() {
    const now = performance.now();
    if (!this.previews || this.sent === this.view || (this.waiting && now - this.waiting < patience)) return;
    if (this.waiting) { this.previews = false; return; }  // none has come
    this.waiting = now;
    this.sent = this.view;
    this.moved_then = this.moved;
    command(`preview ${words(this.view)}`).then((wrong) => { if (wrong) this.say(wrong); });
  }

  // Called for each picture shown, with the number of its edit and what the edit was.
  painted(edit, what) {
    this.read_out();
    if (what !== 'preview') {
      if (this.arrived && edit !== this.edit) this.view = this.arrived = null;
      this.edit = edit;
      return;
    }
    if (!this.waiting) return;
    performance.measure('preview', { start: this.moved_then, end: performance.now() });
    this.waiting = 0;
    if (this.view && !this.arrived) this.send_preview();
  }

  async arrive() {
    const wrong = await command(`view ${words(this.view)}`);
    if (wrong) this.say(wrong);
    this.arrived = true;
    this.waiting = 0;
  }

  say(text) { if (text) tell(text); }
}

const words = ({ vp, vd }) => `-vp ${digits(vp)} -vd ${digits(vd)}`;

// Azimuth around the upward direction and elevation of a direction.
function angles(d, { vd, vu }) {
  const up = unit(vu), right = unit(cross(vd, up)), ahead = cross(up, right);
  return [-Math.atan2(dot(d, right), dot(d, ahead)), Math.asin(Math.max(-1, Math.min(1, dot(d, up))))];
}

// Turned up by an angle, at most to 85 degrees from the horizon.
function pitched(d, up, angle) {
  const most = 85 * Math.PI / 180, now = Math.asin(Math.max(-1, Math.min(1, dot(d, up))));
  return turned(d, unit(cross(d, up)), Math.max(-most, Math.min(most, now + angle)) - now);
}

function orbited(from, pivot, around, over) {
  const up = unit(from.vu), arm = plus(from.vp, pivot, -1), far = length(arm);
  if (far < 1e-6) return from;
  const turn = (d) => turned(d, up, around), out = pitched(turn(unit(arm)), up, over);
  const tilt = Math.asin(dot(out, up)) - Math.asin(dot(unit(arm), up));
  return { ...from, vp: plus(pivot, out, far), vd: pitched(turn(from.vd), up, -tilt) };
}
