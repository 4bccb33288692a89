// The picture: floats (radiance) toned on a 2-D canvas, zoomed and moved, down to single pixels with their values.
// The arithmetic is that of lib/display step by step, so that the bytes are those of `ptaccum -o x.png`.
const weights = [0.265074126, 0.670114631, 0.064811243], lumens = 179;

export function luminance(rgb, i) {
  return lumens * (weights[0] * rgb[i] + weights[1] * rgb[i + 1] + weights[2] * rgb[i + 2]);
}

// Number of thresholds that are not above v: display::ColourTable::index().
export function index(thresholds, v) {
  let low = 0, high = thresholds.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (v >= thresholds[middle]) low = middle + 1;
    else high = middle;
  }
  return low;
}

// index() of the same thresholds for many values: begins at what the first bits of the value as a float say.
const finders = new WeakMap();
export function finder(thresholds) {
  const known = finders.get(thresholds);
  if (known) return known;
  const value = new Float32Array(1), bits = new Uint32Array(value.buffer), first = new Uint16Array(1 << 15);
  for (let b = 0; b < first.length; b++) {
    bits[0] = b << 16;
    first[b] = index(thresholds, value[0]);
  }
  const find = (v) => {
    if (!(v > 0)) return index(thresholds, v);
    value[0] = v;
    let k = first[bits[0] >>> 16];
    while (k < thresholds.length && v >= thresholds[k]) k++;
    while (k > 0 && v < thresholds[k - 1]) k--;
    return k;
  };
  finders.set(thresholds, find);
  return find;
}

// Bytes of the picture under a table of colours.
export function falsecolor(rgb, table) {
  const out = new Uint8ClampedArray(rgb.length / 3 * 4), find = finder(table.thresholds);
  for (let i = 0, o = 0; i < rgb.length; i += 3, o += 4) {
    const k = 3 * find(luminance(rgb, i));
    out[o] = table.colours[k];
    out[o + 1] = table.colours[k + 1];
    out[o + 2] = table.colours[k + 2];
    out[o + 3] = 255;
  }
  return out;
}

// exposure: [scale, white2] (display::Exposure).
export function toned(rgb, kind, exposure, srgb) {
  const [scale, white2] = exposure, straight = scale / Math.sqrt(white2);
  const out = new Uint8ClampedArray(rgb.length / 3 * 4), find = finder(srgb);
  for (let i = 0, o = 0; i < rgb.length; i += 3, o += 4) {
    const world = luminance(rgb, i), l = scale * world, shown = l * (1 + l / white2) / (1 + l);
    const by = kind === 'linear' ? straight : world > 0 && Number.isFinite(shown) ? shown / world : 0;
    if (kind === 'grey') out[o] = out[o + 1] = out[o + 2] = find(world * by);
    else for (let c = 0; c < 3; c++) out[o + c] = find(rgb[i + c] * by * lumens);
    out[o + 3] = 255;
  }
  return out;
}

// Lines where the band changes toward the right or the lower neighbour, over the grey picture.
export function contours(rgb, width, height, table, exposure, srgb) {
  const out = toned(rgb, 'grey', exposure, srgb), band = new Uint16Array(rgb.length / 3);
  const find = finder(table.thresholds);
  for (let i = 0; i < band.length; i++) band[i] = find(luminance(rgb, 3 * i));
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const i = y * width + x, right = x + 1 < width ? band[i + 1] : band[i],
            below = y + 1 < height ? band[i + width] : band[i];
      const highest = Math.max(band[i], right, below);
      if (highest !== Math.min(band[i], right, below))
        for (let c = 0; c < 3; c++) out[4 * i + c] = table.colours[3 * highest + c];
    }
  return out;
}

// Luminance against that of a kept picture: blue darker, red brighter, by the binary logarithm of the ratio.
export function difference(rgb, kept) {
  const out = new Uint8ClampedArray(rgb.length / 3 * 4);
  for (let i = 0, o = 0; i < rgb.length; i += 3, o += 4) {
    const a = luminance(kept, i), b = luminance(rgb, i), ratio = a > 0 && b > 0 ? Math.log2(b / a) : 0;
    const t = Math.max(-1, Math.min(1, ratio));
    out[o] = 235 - (t < 0 ? -t * 205 : t * 45);
    out[o + 1] = 235 - Math.abs(t) * 185;
    out[o + 2] = 235 - (t > 0 ? t * 200 : -t * 25);
    out[o + 3] = 255;
  }
  return out;
}

// A canvas that shows an image at a zoom and a place.
export class PictureView {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.image = document.createElement('canvas');
    this.zoom = 0;  // screen pixels a pixel; 0: the whole picture
    this.x = this.y = 0;  // the picture's place in the middle of the canvas
    this.wipe = 0.5;
    this.overlays = [];  // functions that draw over the picture: (context, to, unit); overlay.js
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  // bytes: RGBA; kept: likewise or null, shown on the left: of the wipe, or of its own.
  show(bytes, width, height, values, kept, beside = false) {
    if (this.image.width !== width || this.image.height !== height) {
      const by = this.image.width ? width / this.image.width : 0;  // the same place of a picture of another size
      this.image.width = width;
      this.image.height = height;
      if (this.zoom && by) Object.assign(this, { zoom: this.zoom / by, x: this.x * by, y: this.y * by });
      else this.fit();
    }
    const to = this.image.getContext('2d');
    to.putImageData(new ImageData(bytes, width, height), 0, 0);
    this.beside = null;
    if (kept && beside) {
      this.beside = Object.assign(document.createElement('canvas'), { width, height });
      this.beside.getContext('2d').putImageData(new ImageData(kept, width, height), 0, 0);
    } else if (kept) {
      const left = Math.round(this.wipe * width);
      to.putImageData(new ImageData(kept, width, height), 0, 0, 0, 0, left, height);
      to.fillStyle = '#fff';
      to.fillRect(left, 0, 1, height);
    }
    this.values = values;
    document.querySelector('main').style.setProperty('--ratio', (beside ? 2 * width : width) / height);
    this.draw();
  }

  // Pictures side by side, each with half of the width: [image, its left end as a share of the width].
  get panes() { return this.beside ? [[this.beside, 0], [this.image, .5]] : [[this.image, 0]]; }
  scale() {
    return this.zoom ||
      Math.min(
        this.canvas.clientWidth / this.panes.length / this.image.width, this.canvas.clientHeight / this.image.height);
  }
  // From the middle of the pane under a place of the page.
  from_middle(clientX, clientY) {
    const box = this.canvas.getBoundingClientRect(), width = box.width / this.panes.length, x = clientX - box.left;
    return [(x < width ? x : x - box.width + width) - width / 2, clientY - box.top - box.height / 2];
  }
  fit() { this.zoom = 0; this.x = this.image.width / 2; this.y = this.image.height / 2; this.draw(); }

  // A place of the page in pixels of the picture, also beside it.
  place(clientX, clientY) {
    const [dx, dy] = this.from_middle(clientX, clientY), s = this.scale();
    return { x: this.x + dx / s, y: this.y + dy / s };
  }

  // The pixel there; null beside the picture.
  pixel(clientX, clientY) {
    const at = this.place(clientX, clientY), x = Math.floor(at.x), y = Math.floor(at.y);
    return x >= 0 && y >= 0 && x < this.image.width && y < this.image.height ? { x, y } : null;
  }

  zoomBy(factor, clientX, clientY) {
    const before = this.scale(), [dx, dy] = clientX === undefined ? [0, 0] : this.from_middle(clientX, clientY);
    this.zoom = Math.max(0.1, Math.min(200, before * factor));
    this.x += dx / before - dx / this.zoom;
    this.y += dy / before - dy / this.zoom;
    this.draw();
  }

  moveBy(dx, dy) {  // screen pixels
    if (!this.zoom) this.zoom = this.scale();
    this.x -= dx / this.zoom;
    this.y -= dy / this.zoom;
    this.draw();
  }

  draw() {
    if (!this.image.width) return;
    const ratio = window.devicePixelRatio || 1, c = this.context;
    const width = Math.round(this.canvas.clientWidth * ratio), height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, width, height);
    const s = this.scale() * ratio, each = width / this.panes.length, top = height / 2 - this.y * s;
    for (const [image, from] of this.panes) {
      const left = from * width + each / 2 - this.x * s;
      c.save();
      c.beginPath();
      c.rect(from * width, 0, each - (this.beside && !from ? 2 * ratio : 0), height);
      c.clip();
      c.imageSmoothingEnabled = s < 1;
      c.drawImage(image, left, top, image.width * s, image.height * s);
      if (s >= 40 * ratio && this.values && image === this.image) this.drawValues(s, left, top, width, height, ratio);
      c.words = [];
      this.overlays.forEach((draw) => draw(c, (x, y) => [left + x * s, top + y * s], ratio));
      c.restore();
    }
  }

  // The whole picture with what is drawn over it, at least 1024 pixels wide.
  sheet() {
    const by = Math.max(1, Math.ceil(1024 / this.image.width)), sheet = document.createElement('canvas'),
          c = sheet.getContext('2d');
    sheet.width = by * this.image.width;
    sheet.height = by * this.image.height;
    c.imageSmoothingEnabled = false;
    c.drawImage(this.image, 0, 0, sheet.width, sheet.height);
    this.overlays.forEach((draw) => draw(c, (x, y) => [by * x, by * y], 1));
    return sheet;
  }

  drawValues(s, left, top, width, height, ratio) {
    const c = this.context;
    c.font = `${11 * ratio}px system-ui, sans-serif`;
    c.textAlign = 'center';
    c.strokeStyle = '#000';
    c.lineWidth = 3 * ratio;
    for (let y = Math.max(0, Math.floor(-top / s)); y < this.image.height && top + y * s < height; y++)
      for (let x = Math.max(0, Math.floor(-left / s)); x < this.image.width && left + x * s < width; x++) {
        const text = short(luminance(this.values, 3 * (y * this.image.width + x)));
        c.strokeText(text, left + (x + .5) * s, top + (y + .5) * s + 4 * ratio);
        c.fillStyle = '#fff';
        c.fillText(text, left + (x + .5) * s, top + (y + .5) * s + 4 * ratio);
      }
  }
}

export function short(v, digits = 4) {
  if (!Number.isFinite(v)) return String(v);
  return v.toLocaleString('en', { maximumSignificantDigits: digits, useGrouping: false });
}

// Numbers with the decimals that an interval's width leaves: two digits of it.
export function alike(values, low, high) {
  const width = Math.abs(high - low) / 2, decimals = Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(width))));
  return values.map((v) => !Number.isFinite(v) ? '–' : Number.isFinite(decimals) ? v.toFixed(decimals) : short(v));
}
