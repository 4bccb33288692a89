// The plan: maps of points as vcview has them drawn, and a row of numbers for each grid, in lx.  A press on a level
// grid puts the eye there, at the height that it has; a drag from there says where it looks.
import { ask, Lost, post } from '/net.js';
import { alike } from '/picture.js';
import { offer } from '/save.js';
import { fill, keep, row_of } from '/table.js';

const $ = (id) => document.getElementById(id);

// 300 (290 to 310), shares in percent.
function cell_of(name, { [name]: value, [`${name}.lo`]: low, [`${name}.hi`]: high }) {
  const by = /\.share[\d.e+]+$/.test(name) ? 100 : 1, unit = by > 1 ? ' %' : '';
  if (!Number.isFinite(value)) return ['–', ''];
  if (!(high > low)) return [String(Number((by * value).toPrecision(3))) + unit, ''];
  const [v, from, to] = alike([value, low, high].map((x) => by * x), by * low, by * high);
  return [v + unit, `${from} to ${to}`];
}

// How a grid that lies level is drawn, with north up: { scale (of the drawing to a metre), x, y, at (of its middle) };
// null: it does not lie so.
function level_of(points) {
  const mean = (of) => points.reduce((sum, p) => sum + of(p), 0) / points.length;
  const x = mean((p) => p.x), y = mean((p) => p.y), at = [0, 1, 2].map((k) => mean((p) => p.at[k]));
  const off = (p, k) => p.at[k] - at[k], over = (k, of) => mean((p) => off(p, k) * of(p)) / mean((p) => off(p, k) ** 2);
  const scale = over(0, (p) => p.x - x) || over(1, (p) => y - p.y);
  const fits = points.every((p) => Math.abs(off(p, 2)) < .01 &&
    Math.hypot(x + scale * off(p, 0) - p.x, y - scale * off(p, 1) - p.y) < 2);
  return scale > 0 && fits ? { scale, x, y, at } : null;
}

// The points of a drawing, each with its words and its rectangles, and which one a place shows.
class Points {
  constructor(map = '<svg/>') {
    const svg = new DOMParser().parseFromString(map, 'image/svg+xml').documentElement;
    [this.width, this.height] = (svg.getAttribute('viewBox') ?? '0 0 0 0').split(' ').slice(2).map(Number);
    this.again = Number(svg.querySelector('use')?.getAttribute('x') ?? 0);  // the second half repeats the first
    this.of = new Int32Array(this.width * this.height).fill(-1);
    this.all = [...svg.querySelectorAll('title')].map(({ textContent: words, parentNode }, k) => {
      const n = parentNode.getAttribute('d').match(/\d+/g).map(Number), ends = [Infinity, Infinity, 0, 0];
      for (let i = 0; i < n.length; i += 5) {
        const [x, y, w, h] = n.slice(i, i + 4);
        for (let row = y; row < y + h; row++) this.of.fill(k, row * this.width + x, row * this.width + x + w);
        ends.forEach((end, side) => {
          ends[side] = side < 2 ? Math.min(end, n[i + side]) : Math.max(end, n[i + side - 2] + n[i + side]);
        });
      }
      return {
        words, grid: words.replace(/: [^:]*$/, ''), x: (ends[0] + ends[2]) / 2, y: (ends[1] + ends[3]) / 2,
        at: (/ at (\S+, \S+, \S+)$/.exec(words)?.[1] ?? '').split(', ').map(Number)
      };
    });
    this.levels = new Map([...new Set(this.all.map((p) => p.grid))].map((grid) =>
      [grid, level_of(this.all.filter((p) => p.grid === grid))]).filter(([, level]) => level));
  }

  at(x, y) { return this.of[Math.floor(y) * this.width + Math.floor(x >= this.width / 2 ? x - this.again : x)] ?? -1; }

  // The nearest one that way, rather ahead than aside; the same where there is none.  Beside it lies its own grid,
  // above and below the others, too.
  beside(k, dx, dy) {
    const from = this.all[k], far = (p) => {
      const [ahead, aside] =
        [dx * (p.x - from.x) + dy * (p.y - from.y), Math.abs(dy * (p.x - from.x) - dx * (p.y - from.y))];
      return ahead > .5 && (dy || p.grid === from.grid) ? ahead + 3 * aside : Infinity;
    };
    return this.all.reduce((best, p, i) => (far(p) < (best === k ? Infinity : far(this.all[best])) ? i : best), k);
  }
}

export class Plan {
  constructor(camera) {
    Object.assign(this, { camera, state: null, drawn: { number: 0 }, asking: false, points: new Points(), point: -1 });
    $('plan').addEventListener('pointermove', (e) => {
      if (e.target.matches('img')) this.choose(this.points.at(...this.place(e)));
    });
    $('plan').addEventListener('pointerdown', (e) => {
      if (!e.target.matches('img')) return;
      e.preventDefault();
      this.pressed = this.place(e);
      $('plan').focus({ preventScroll: true });  // what is pressed stays under the pointer
    });
    document.addEventListener('pointerup', (e) => {
      const from = this.pressed;
      this.pressed = null;
      if (from) this.put_eye(from, e.target.matches('#plan img') ? this.place(e) : from);
    });
    $('plan').addEventListener('keydown', (e) => {
      if (e.key === 'Enter' && this.point >= 0) {
        const { x, y } = this.points.all[this.point];
        this.put_eye([x, y], [x, y]);
      }
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
      if (!by || e.shiftKey || e.ctrlKey || e.metaKey || e.altKey) return;
      e.preventDefault();
      e.stopPropagation();
      this.choose(this.point < 0 ? 0 : this.points.beside(this.point, ...by));
    });
    $('plan-limit').addEventListener('change', async () => {
      const wrong = await post(`/plan?limit=${$('plan-limit').value}`);
      $('plan-limit').setCustomValidity(wrong);
      $('plan-limit').reportValidity();
    });
    $('plan-panel').addEventListener('toggle', () => this.fetch());
    $('save-plan').addEventListener('click', () => offer('plan.svg', this.drawn.map, 'image/svg+xml'));
  }

  // Of a pointer, in the drawing.
  place({ target, clientX, clientY }) {
    const { left, top, width } = target.getBoundingClientRect(), by = this.points.width / width;
    return [(clientX - left) * by, (clientY - top) * by];
  }

  // From one place of the drawing it looks to another; the same: as it does.
  put_eye([x, y], [to_x, to_y]) {
    const grid = this.points.all[this.points.at(x, y)]?.grid, level = this.points.levels.get(grid);
    const now = this.camera.on && this.camera.now();
    if (!level || !now) return;
    const { scale, at } = level, half = x >= this.points.width / 2 ? this.points.again : 0;
    const [right, up] = [to_x - x, y - to_y], far = Math.hypot(right, up), ahead = Math.hypot(now.vd[0], now.vd[1]);
    this.camera.set({
      ...now, vp: [at[0] + (x - half - level.x) / scale, at[1] - (y - level.y) / scale, now.vp[2]],
      vd: far < 8 || !ahead ? now.vd : [right / far * ahead, up / far * ahead, now.vd[2]]
    });
  }

  // The eye, as an arrow, and how long a metre is.
  show_eye() {
    const now = this.camera.on && this.camera.now(), { width, height, levels } = this.points;
    const marks = [...now ? levels.values() : []].map(({ scale, x, y, at }) => {
      const mark = document.createElement('i');
      Object.assign(mark.style, {
        left: `${200 * (x + scale * (now.vp[0] - at[0])) / width}%`,
        top: `${100 * (y - scale * (now.vp[1] - at[1])) / height}%`, rotate: `${Math.atan2(now.vd[0], now.vd[1])}rad`
      });
      return mark;
    });
    const map = $('plan').firstElementChild, [level] = levels.values();
    map.querySelectorAll('i, em').forEach((mark) => mark.remove());
    if (!level) return;
    const metre = document.createElement('em'), bar = document.createElement('u');
    bar.style.width = `${level.scale * map.firstElementChild.clientWidth / width}px`;
    metre.append('▲ N', bar, '1 m');
    map.append(metre, ...marks);
  }

  // { number, limit, edit, waits, ended }, or null.  number: of what can be drawn; edit: that of the model at hand.
  take(state) {
    this.state = state;
    $('plan-panel').hidden = !state;
    if (!state) return;
    fill($('plan-limit'), state.limit);
    this.say();
    this.fetch();
  }

  // One question after another, while there is something newer.
  async fetch() {
    if (this.asking || !this.state) return;
    this.asking = true;
    try {
      while (this.drawn.number < this.state.number && $('plan-panel').open) {
        const answer = await ask(`/plan?picture=${this.state.number}`);
        if (answer.status === 200) this.draw(await answer.json());
        else if (!answer.ok) {
          this.wrong = this.state.waits ? '' : (await answer.text()).trim();
          break;
        }
      }
    } catch (e) {
      if (!(e instanceof Lost)) throw e;
      setTimeout(() => this.fetch(), 1000);  // nothing newer may come that would ask again
    } finally {
      this.asking = false;
      this.say();
    }
  }

  say() {
    const { number, edit, waits, ended } = this.state, { frame, edit: shown } = this.drawn.numbers ?? {};
    const old = this.drawn.numbers && (waits || shown < edit), rough = !(frame >= 2);  // no interval yet
    $('plan').classList.toggle('old', Boolean(old || rough));
    $('plan-say').textContent = this.wrong || [
      ended ? 'the renderer of the points has ended' : '',
      this.drawn.numbers ? rough && !old ? 'looking … (a first rough map)' :
                                           `${frame} frames${old ? ', from before the last change' : ''}` :
        ended || number ? '' :
                          'the plan comes when the picture has 4 frames'
    ].filter(Boolean).join('; ');
  }

  // Its words, and where it lies in both maps.
  choose(k) {
    const point = this.points.all[k], { width, height } = this.points;
    const can = this.camera.on && this.points.levels.size;
    this.point = point ? k : -1;
    const none = this.points.all.length ? `Point at the map for values${can ? '; a press puts the eye there' : ''}.` : '';
    $('plan-point').textContent = point?.words ?? none;
    for (const mark of document.querySelectorAll('#plan b')) {
      mark.hidden = !point;
      mark.dataset.words = point?.words ?? '';
      mark.classList.toggle('far', point?.x > width / 4);  // of a half's middle
      if (point) Object.assign(mark.style, { left: `${200 * point.x / width}%`, top: `${100 * point.y / height}%` });
    }
  }

  draw(drawn) {
    [this.drawn, this.wrong] = [drawn, ''];
    this.points = new Points(drawn.map);
    this.choose(this.point);
    $('plan').tabIndex = this.points.all.length ? 0 : -1;
    const names = Object.keys(drawn.numbers).filter((name) => /\./.test(name) && !/\.(lo|hi)$/.test(name));
    const grids = [...new Set(names.map((name) => name.slice(0, name.lastIndexOf('.'))))];
    const columns = ['mean', 'min', 'median', 'U0', `share${drawn.limit}`];
    ['grid', ...columns.slice(0, 4), `≥ ${drawn.limit} lx`].forEach((text, k) => {
      $('plan-numbers').tHead.rows[0].cells[k].textContent = text;
    });
    keep($('plan-numbers').tBodies[0], grids, (grid) => grid, () => row_of(6), (row, grid) => {
      row.cells[0].textContent = grid;
      columns.forEach((column, k) => {
        const [value, interval] = cell_of(`${grid}.${column}`, drawn.numbers);
        const small = Object.assign(document.createElement('div'), { className: 'change', textContent: interval });
        row.cells[k + 1].replaceChildren(value, small);
      });
    });
    const url = URL.createObjectURL(new Blob([drawn.map], { type: 'image/svg+xml' })), before = this.url;
    for (const image of document.querySelectorAll('#plan img')) image.src = url;
    if (before) setTimeout(() => URL.revokeObjectURL(before), 1000);
    this.url = url;
    this.show_eye();
    document.body.dataset.plan = drawn.number;
    $('save-plan').hidden = false;
  }
}
