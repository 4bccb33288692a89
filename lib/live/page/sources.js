// Glare sources: outlines with numbers over the picture and a table with their shares of DGP, as vcmetrics -sources
// lists them.  They are asked for while their part of the page is open, and not so often that the rendering suffers.
import { ask } from '/net.js';
import { brightest, inside, label, outline } from '/overlay.js';
import { luminance, short } from '/picture.js';
import { keep, one_stop, row_of } from '/table.js';

const $ = (id) => document.getElementById(id);
const css = '#ffb347', chosen_css = '#fff2d8';

const speck = .005;  // of DGP's sum

// A source keeps its number from picture to picture: that of the nearest one before, where it is near.
// sources: the largest share first.  Returns the places by number, in fractions of the picture.
function numbered(sources, before, width, height) {
  const left = [...before], reach = .08;
  for (const s of sources) {
    const [xs, ys] = [0, 1].map((side) => s.outline.flatMap((r) => r.filter((_, k) => k % 2 === side)));
    s.at = [(Math.min(...xs) + Math.max(...xs)) / 2 / width, (Math.min(...ys) + Math.max(...ys)) / 2 / height];
    const far = ({ at }) => Math.hypot(at[0] - s.at[0], at[1] - s.at[1]),
          nearest = left.reduce((best, b) => !best || far(b) < far(best) ? b : best, null);
    if (!nearest || far(nearest) > reach) continue;
    s.number = nearest.number;
    left.splice(left.indexOf(nearest), 1);
  }
  const taken = new Set([...before, ...sources].map((s) => s.number));
  for (const s of sources) {
    if (s.number !== undefined) continue;
    for (s.number = before.length ? 1 : s.source; taken.has(s.number); s.number++)
      ;
    taken.add(s.number);
  }
  return [...sources.map(({ number, at }) => ({ number, at })), ...left].slice(0, 50);
}

// Four places inside of an outline, each in the middle of a row that it crosses.
function within(rings) {
  const ys = rings.flatMap((r) => r.filter((_, k) => k % 2)), low = Math.min(...ys), high = Math.max(...ys), all = [];
  for (const share of [.2, .4, .6, .8]) {
    const y = Math.floor(low + share * (high - low)) + .5, xs = [];
    for (const r of rings)
      for (let k = 0, j = r.length - 2; k < r.length; j = k, k += 2)
        if (r[k + 1] > y !== r[j + 1] > y) xs.push(r[k] + (r[j] - r[k]) * (y - r[k + 1]) / (r[j + 1] - r[k + 1]));
    xs.sort((a, b) => a - b);
    if (xs.length > 1) all.push([(xs[0] + xs[1]) / 2, y]);
  }
  return all;
}

export class Sources {
  // called(x, y): what is there, { word, name }, in a while; null: not known.
  constructor(view, called) {
    Object.assign(this, { view, called, before: [] });
    this.all = [];
    this.chosen = null;  // a number
    this.asking = false;
    $('sources-panel').addEventListener('toggle', () => {
      this.wanted = this.known = 0;
      this.show(this.newest);
      view.draw();
    });
    view.overlays.push((...c) => this.draw(...c));
  }

  // The picture is of another view.
  forget() { this.before = []; }

  get open() { return $('sources-panel').open; }

  // picture: the number of the newest.
  async show(picture) {
    this.newest = picture;
    if (!picture || !this.open || this.asking || this.known === picture) return;
    this.asking = true;
    const begin = performance.now();
    try {
      const answer = await ask(`/sources?picture=${picture}`);
      if (answer.status === 200) {
        const { picture: known, sources } = await answer.json();
        this.known = known;
        this.all = sources.sort((a, b) => b.DGPshare - a.DGPshare);
        const { values, image: { width, height } } = this.view;
        for (const s of this.all)
          s.peak = brightest(s.outline, width, height, (x, y) => luminance(values, 3 * (y * width + x)));
        this.before = numbered(this.all, this.before, width, height);
        this.fill_table();
      } else if (answer.status !== 204) {
        this.known = picture;
        $('sources-say').textContent = (await answer.text()).trim();
      }
    } catch {
      return;  // vcview has ended
    } finally {
      setTimeout(() => {
        this.asking = false;
        this.show(this.newest);
      }, Math.max(500, 9 * (performance.now() - begin)));
    }
  }

  fill_table() {
    $('sources-say').textContent = this.all.length ? '' : 'no glare source in this picture';
    $('sources').hidden = !this.all.length;
    const body = $('sources').tBodies[0];
    keep(
      body, this.all, (s) => s.number,
      ({ number }) => {
        const row = row_of(6), choose = () => {
          this.chosen = this.chosen === number ? null : number;
          this.fill_table();
        };
        row.addEventListener('click', choose);
        row.addEventListener('keydown', (e) => {
          if (e.key === 'Enter') choose();
        });
        return row;
      },
      (row, s) => {
        row.setAttribute('aria-selected', String(s.number === this.chosen));
        [s.number, `${(100 * s.DGPshare).toFixed(1)} %`, short(s.L), short(s.omega), short(s.P)].forEach((text, k) => {
          row.cells[k].textContent = text;
        });
        row.shown = s;
        this.name(s).then(() => {
          if (row.shown === s)
            Object.assign(row.cells[5], { textContent: s.word ?? row.cells[5].textContent, title: s.title ?? '' });
          this.view.draw();
        });
      });
    one_stop(body, body.rows);
    this.view.draw();
  }

  // What most of it shows: the brightest pixel, and four others.
  async name(s) {
    if (!s.peak || s.DGPshare < speck) return;
    const places = [s.peak, ...within(s.outline)].map((p) => p.map(Math.floor));
    const all = (await Promise.all(places.map((p) => this.called(...p)))).filter(Boolean),
          of = (word) => all.filter((a) => a.word === word);
    const most = all.reduce((best, a) => of(a.word).length > (best ? of(best.word).length : 0) ? a : best, null);
    if (most) Object.assign(s, { word: most.word, title: [...new Set(all.map((a) => a.name))].join(', ') });
  }

  draw(c, to, unit) {
    if (!this.open) return;
    const sorted = [...this.all].sort((a, b) => (a.number === this.chosen) - (b.number === this.chosen));
    const seen = sorted.filter((s) => s.DGPshare >= speck || s.number === this.chosen);  // others are specks
    for (const s of seen)
      outline(c, s.outline, to, unit, s.number === this.chosen ? chosen_css : css, s.number === this.chosen ? 3 : 1.5);
    for (const s of seen) {
      if (!s.peak) continue;  // of a picture of another size
      const [x, y] = to(...s.peak);
      label(
        c, `${s.number} ${s.word ? `${s.word} ` : ''}${(100 * s.DGPshare).toFixed(0)} %`, x, y - 4 * unit, unit, css);
    }
  }

  // For the probe.
  at(x, y) {
    const s = this.open && this.all.find((one) => inside(one.outline, x + .5, y + .5));
    return s ? `glare source ${s.number} (${(100 * s.DGPshare).toFixed(1)} % of DGP)` : '';
  }
}
