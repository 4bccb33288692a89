// Display of the picture: tone curve or falsecolor with its scale, and the comparison with a picture that was kept.
import { ask } from '/net.js';
import { contours, difference, falsecolor, short, toned } from '/picture.js';
import { round_steps } from '/scale.js';

const $ = (id) => document.getElementById(id);

export class Tones {
  constructor(view) {
    this.view = view;
    this.srgb = [];
    this.picture = this.kept = this.held = this.table = null;
    this.top = 0;  // of the scale, held until another one is asked for; 0: the next picture's
    for (const id of ['tone', 'style', 'top', 'decades', 'divisions', 'mask', 'compare', 'hold'])
      $(id).addEventListener('change', () => this.show());
    $('luminance').addEventListener('click', () => this.luminance());
    $('rescale').addEventListener('click', () => {
      this.top = 0;
      $('top').value = '';
      this.show();
    });
    $('stops').addEventListener('input', () => {
      $('stops-value').value = $('stops').value;
      this.show();
    });
    new ResizeObserver(() => {
      if (this.table) this.draw_legend($('legend'), $('legend').hidden);
    }).observe($('canvas'));
  }

  // rgb: floats of another picture, or null; name: what it is called.
  compare_with(rgb, name = '') {
    Object.assign(this, { kept: rgb, name });
    this.show();
  }

  // Falsecolor, and back to what there was before.
  luminance() {
    const is = $('tone').value === 'falsecolor';
    if (!is) this.other = $('tone').value;
    $('tone').value = is ? this.other ?? 'photo' : 'falsecolor';
    this.show();
  }

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
    document.querySelectorAll('.for-falsecolor > *').forEach((e) => {
      e.hidden = kind !== 'falsecolor';
    });
    $('divisions').parentElement.hidden = kind !== 'falsecolor' || $('style').value === 'smooth';
    document.querySelectorAll('.for-photo > *').forEach((e) => {
      e.hidden = kind === 'falsecolor';
    });
    $('luminance').setAttribute('aria-pressed', String(kind === 'falsecolor'));
    if (kind === 'falsecolor') await this.choose_table();
    const { rgb, width, height } = this.picture;
    const compare = this.kept && this.kept.length === rgb.length ? $('compare').value : 'no';
    const bytes =
      compare === 'difference' ? difference(rgb, this.kept) : this.bytes_of(compare === 'kept' ? this.kept : rgb);
    this.view.show(
      bytes, width, height, rgb, compare === 'wipe' || compare === 'beside' ? this.bytes_of(this.kept) : null,
      compare === 'beside');
    this.compare = compare;
    $('caption').textContent = caption_of(compare, this.name || 'the edit before');
    this.draw_legend($('legend'), kind !== 'falsecolor' && compare !== 'difference');
    performance.measure('tone', { start });
  }

  draw_legend(canvas, hidden) {
    canvas.hidden = hidden;
    if (hidden) return;
    const unit = window.devicePixelRatio || 1, width = canvas.width = Math.round(canvas.clientWidth * unit),
          c = canvas.getContext('2d');
    canvas.height = 34 * unit;
    c.font = `${12 * unit}px system-ui, sans-serif`;
    if (this.compare === 'difference') return draw_key(c, width, unit);
    const { thresholds, colours, top, decades } = this.table;
    const place = (t) => decades > 0 ? top * 10 ** (decades * (t - 1)) : top * t;
    let k = 0;
    for (let x = 0; x < width; x++) {
      while (k < thresholds.length && place(x / (width - 1)) >= thresholds[k]) k++;
      c.fillStyle = `rgb(${colours.slice(3 * k, 3 * k + 3)})`;
      c.fillRect(x, 0, 1, 14 * unit);
    }
    const low = place(0), at = (v) => decades > 0 ? 1 + Math.log10(v / top) / decades : v / top;
    const words = round_steps(
                    low, top, decades > 0,
                    width < 220 * unit   ? 2 :
                      width < 480 * unit ? 4 :
                                           9)
                    .map((v) => [short(v), at(v)]);
    draw_words(c, words, ' cd/m²', width, unit);
  }
}

// Words below a scale, each at its share of the width; the last one with the unit.  Those that would touch are left
// out.
function draw_words(c, words, of, width, unit) {
  c.fillStyle = getComputedStyle(document.body).color;
  let end = width;
  for (const [k, [word, share]] of [...words.entries()].reverse()) {
    const text = k === words.length - 1 ? word + of : word, half = c.measureText(text).width / 2;
    const x = Math.max(half, Math.min(width - half, share * width));
    if (x + half > end) continue;
    c.textAlign = 'center';
    c.fillText(text, x, 29 * unit);
    end = x - half - 8 * unit;
  }
}

// The key of a difference: blue where it is darker now, red where it is brighter.
function draw_key(c, width, unit) {
  const ratios = Float32Array.from({ length: 3 * width }, (_, i) => 2 ** (2 * Math.floor(i / 3) / (width - 1) - 1));
  const bytes = difference(ratios, ratios.map(() => 1));
  for (let x = 0; x < width; x++) {
    c.fillStyle = `rgb(${[...bytes.slice(4 * x, 4 * x + 3)]})`;
    c.fillRect(x, 0, 1, 14 * unit);
  }
  draw_words(c, [['half as bright', 0], ['equal', .5], ['twice as bright', 1]], ' or more', width, unit);
}

function caption_of(compare, other) {
  return {
    beside: `left: ${other}; right: now`,
    wipe: `left of the line: ${other}; right: now (shift and drag moves it)`,
    kept: `${other}, not now`,
    difference: `luminance now, compared with ${other}`,
  }[compare] ??
    '';
}
