// Display of the picture: tone curve or falsecolor with its scale, and the comparison with a picture that was kept.
import { ask } from '/net.js';
import { contours, difference, falsecolor, short, toned } from '/picture.js';

const $ = (id) => document.getElementById(id);

export class Tones {
  constructor(view) {
    this.view = view;
    this.srgb = [];
    this.picture = this.kept = this.held = this.table = null;
    this.top = 0;  // of the scale, held until another one is asked for; 0: the next picture's
    for (const id of ['tone', 'style', 'top', 'decades', 'divisions', 'mask', 'compare', 'hold'])
      $(id).addEventListener('change', () => this.show());
    $('rescale').addEventListener('click', () => { this.top = 0; $('top').value = ''; this.show(); });
    $('stops').addEventListener('input', () => { $('stops-value').value = $('stops').value; this.show(); });
    new ResizeObserver(() => {
      if (this.table) this.draw_legend($('legend'), $('legend').hidden);
    }).observe($('canvas'));
  }

  // rgb: floats of another picture, or null.
  compare_with(rgb) { this.kept = rgb; this.show(); }

  next_of(select) {
    if (select.disabled) return;
    select.selectedIndex = (select.selectedIndex + 1) % select.length;
    this.show();
  }

  brighter(by) {
    $('stops').value = Number($('stops').value) + by;
    $('stops').dispatchEvent(new Event('input'));
  }

  wipe_to(share) {
    this.view.wipe = share;
    this.show();
  }

  get wiping() { return !$('compare').disabled && $('compare').value === 'wipe'; }

  async choose_table() {
    const top = Number($('top').value) || this.top || this.picture.top;
    if (this.picture.frames > 1 && this.picture.what !== 'preview') this.top = top;
    const question = new URLSearchParams({
      top,
      decades: $('decades').value || 3,
      divisions: $('divisions').value || 8,
      mask: $('mask').value || 0,
      style: $('style').value === 'smooth' ? 'smooth' : 'bands'
    });
    if (this.table?.question === question.toString()) return;
    const answer = await ask('/table?' + question);
    if (!answer.ok) return;
    this.table = {
      ...await answer.json(),
      question: question.toString(),
      top: Number(question.get('top')),
      decades: Number(question.get('decades'))
    };
  }

  exposure() {
    const e = $('hold').checked && this.held ? this.held : this.picture.exposure;
    this.held = e;
    return [e[0] * 2 ** Number($('stops').value), e[1]];
  }

  bytes_of(rgb) {
    const kind = $('tone').value, p = this.picture;
    if (kind !== 'falsecolor') return toned(rgb, kind, this.exposure(), this.srgb);
    if ($('style').value === 'contours') return contours(rgb, p.width, p.height, this.table, p.exposure, this.srgb);
    return falsecolor(rgb, this.table);
  }

  async show(picture = this.picture) {
    this.picture = picture;
    if (!picture) return;
    const start = performance.now();
    const kind = $('tone').value;
    document.querySelectorAll('.for-falsecolor > *').forEach((e) => { e.hidden = kind !== 'falsecolor'; });
    $('divisions').parentElement.hidden = kind !== 'falsecolor' || $('style').value === 'smooth';
    document.querySelectorAll('.for-photo > *').forEach((e) => { e.hidden = kind === 'falsecolor'; });
    if (kind === 'falsecolor') await this.choose_table();
    const { rgb, width, height } = this.picture;
    const compare = this.kept && this.kept.length === rgb.length ? $('compare').value : 'no';
    const bytes =
      compare === 'difference' ? difference(rgb, this.kept) : this.bytes_of(compare === 'kept' ? this.kept : rgb);
    this.view.show(bytes, width, height, rgb,
      compare === 'wipe' || compare === 'beside' ? this.bytes_of(this.kept) : null, compare === 'beside');
    this.draw_legend($('legend'), kind !== 'falsecolor' || compare === 'difference');
    performance.measure('tone', { start });
  }

  draw_legend(canvas, hidden) {
    canvas.hidden = hidden;
    if (hidden) return;
    const unit = window.devicePixelRatio || 1, width = canvas.width = Math.round(canvas.clientWidth * unit),
          c = canvas.getContext('2d');
    canvas.height = 34 * unit;
    const { thresholds, colours, top, decades } = this.table;
    const place = (t) => decades > 0 ? top * 10 ** (decades * (t - 1)) : top * t;
    let k = 0;
    for (let x = 0; x < width; x++) {
      while (k < thresholds.length && place(x / (width - 1)) >= thresholds[k]) k++;
      c.fillStyle = `rgb(${colours.slice(3 * k, 3 * k + 3)})`;
      c.fillRect(x, 0, 1, 14 * unit);
    }
    c.fillStyle = getComputedStyle(document.body).color;
    c.font = `${12 * unit}px system-ui, sans-serif`;
    const last = width < 220 * unit ? 1 : width < 480 * unit ? 2 : 4;
    for (let j = 0; j <= last; j++) {
      c.textAlign = j === 0 ? 'left' : j === last ? 'right' : 'center';
      c.fillText(short(place(j / last)) + (j === last ? ' cd/m²' : ''), j / last * width, 29 * unit);
    }
  }
}
