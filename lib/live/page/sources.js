// Glare sources: outlines with numbers over the picture and a table with their shares of DGP, as vcmetrics -sources
// lists them.  They are asked for while their part of the page is open, and not so often that the rendering suffers.
import { ask } from '/net.js';
import { brightest, inside, label, outline } from '/overlay.js';
import { luminance, short } from '/picture.js';
import { keep, one_stop, row_of } from '/table.js';

const $ = (id) => document.getElementById(id);
const css = '#ffb347', chosen_css = '#fff2d8';

export class Sources {
  // what(x, y): names what is there, in a while.
  constructor(view, what) {
    Object.assign(this, { view, what });
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
    keep(body, this.all, (s) => s.source,
      ({ source }) => {
        const row = row_of(6), choose = () => {
          this.chosen = this.chosen === source ? null : source;
          this.fill_table();
        };
        row.addEventListener('click', choose);
        row.addEventListener('keydown', (e) => {
          if (e.key === 'Enter') choose();
        });
        return row;
      },
      (row, s) => {
        row.setAttribute('aria-selected', String(s.source === this.chosen));
        [s.source, `${(100 * s.DGPshare).toFixed(1)} %`, short(s.L), short(s.omega), short(s.P)].forEach(
          (text, k) => { row.cells[k].textContent = text; });
        row.shown = s;
        const name = s.peak ? this.what(...s.peak.map(Math.floor)) : Promise.resolve('');
        name.then((text) => {
          if (row.shown === s) row.cells[5].textContent = text;
        });
      });
    one_stop(body, body.rows);
    this.view.draw();
  }

  draw(c, to, unit) {
    if (!this.open) return;
    const sorted = [...this.all].sort((a, b) => (a.source === this.chosen) - (b.source === this.chosen));
    const seen = sorted.filter((s) => s.DGPshare >= .005 || s.source === this.chosen);  // others are specks
    for (const s of seen)
      outline(c, s.outline, to, unit, s.source === this.chosen ? chosen_css : css, s.source === this.chosen ? 3 : 1.5);
    for (const s of seen) {
      if (!s.peak) continue;  // of a picture of another size
      const [x, y] = to(...s.peak);
      label(c, `${s.source}: ${(100 * s.DGPshare).toFixed(0)} %`, x, y - 4 * unit, unit, css);
    }
  }

  // For the probe.
  at(x, y) {
    const s = this.open && this.all.find((one) => inside(one.outline, x + .5, y + .5));
    return s ? `glare source ${s.source} (${(100 * s.DGPshare).toFixed(1)} % of DGP)` : '';
  }
}
