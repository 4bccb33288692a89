// The plan: maps of points as vcview has them drawn, and a row of numbers for each grid, in lx.
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

export class Plan {
  constructor() {
    Object.assign(this, { state: null, drawn: { number: 0 }, asking: false });
    $('plan-limit').addEventListener('change', async () => {
      const wrong = await post(`/plan?limit=${$('plan-limit').value}`);
      $('plan-limit').setCustomValidity(wrong);
      $('plan-limit').reportValidity();
    });
    $('plan-panel').addEventListener('toggle', () => this.fetch());
    $('save-plan').addEventListener('click', () => offer('plan.svg', this.drawn.map, 'image/svg+xml'));
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
        else if (!answer.ok) { this.wrong = (await answer.text()).trim(); break; }
      }
    } catch (e) {
      if (!(e instanceof Lost)) throw e;
    } finally {
      this.asking = false;
      this.say();
    }
  }

  say() {
    const { number, edit, waits, ended } = this.state, { frame, edit: shown } = this.drawn.numbers ?? {};
    const old = this.drawn.numbers && (waits || shown < edit);
    $('plan').classList.toggle('old', Boolean(old));
    $('plan-say').textContent = this.wrong || [ended ? 'the renderer of the points has ended' : '',
      this.drawn.numbers ? `${frame} frames${old ? ', of the model before the last change' : ''}` :
        ended || number ? '' : 'the plan comes when the picture has 4 frames'].filter(Boolean).join('; ');
  }

  draw(drawn) {
    [this.drawn, this.wrong] = [drawn, ''];
    const names = Object.keys(drawn.numbers).filter((name) => /\./.test(name) && !/\.(lo|hi)$/.test(name));
    const grids = [...new Set(names.map((name) => name.slice(0, name.lastIndexOf('.'))))];
    const columns = ['mean', 'min', 'median', 'U0', `share${drawn.limit}`];
    ['grid', ...columns.slice(0, 4), `≥ ${drawn.limit} lx`].forEach((text, k) => { $('plan-numbers').tHead.rows[0].cells[k].textContent = text; });
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
    document.body.dataset.plan = drawn.number;
    $('save-plan').hidden = false;
  }
}
