// Lines and words over the picture: bright on a dark rim, so that they show on any picture.
// to(x, y): from pixels of the picture to those of the canvas; unit: device pixels a CSS pixel.

// rings: [x, y, x, y, ...] each, closed.
export function outline(c, rings, to, unit, colour, width = 1.5) {
  c.beginPath();
  for (const ring of rings) {
    for (let k = 0; k < ring.length; k += 2) c[k ? 'lineTo' : 'moveTo'](...to(ring[k], ring[k + 1]));
    c.closePath();
  }
  c.lineJoin = 'round';
  for (const [style, w] of [['#000a', width + 2], [colour, width]]) {
    c.strokeStyle = style;
    c.lineWidth = w * unit;
    c.stroke();
  }
}

// Centred on x, y, inside of the canvas, above what stands there already.
export function label(c, text, x, y, unit, colour) {
  c.font = `600 ${12 * unit}px system-ui, sans-serif`;
  c.textAlign = 'center';
  const half = c.measureText(text).width / 2 + 3 * unit, line = 15 * unit;
  x = Math.max(half, Math.min(c.canvas.width - half, x));
  y = Math.max(13 * unit, Math.min(c.canvas.height - 4 * unit, y));
  c.words ??= [];
  while (y > 2 * line && c.words.some((w) => Math.abs(w.y - y) < line && Math.abs(w.x - x) < w.half + half)) y -= line;
  c.words.push({ x, y, half });
  c.lineJoin = 'round';
  c.strokeStyle = '#000c';
  c.lineWidth = 3.5 * unit;
  c.strokeText(text, x, y);
  c.fillStyle = colour;
  c.fillText(text, x, y);
}

// Above the middle of rings: [x, y]; null where there is none.
export function top_of(rings) {
  let left = Infinity, right = -Infinity, top = Infinity;
  for (const ring of rings)
    for (let k = 0; k < ring.length; k += 2) {
      left = Math.min(left, ring[k]);
      right = Math.max(right, ring[k]);
      top = Math.min(top, ring[k + 1]);
    }
  return left <= right ? [(left + right) / 2, top] : null;
}

// The middle of the brightest pixel inside of rings: [x, y]; null where there is none.
export function brightest(rings, width, height, brightness) {
  const ys = rings.flatMap((r) => r.filter((_, k) => k % 2));
  let place = null, most = -Infinity;
  for (let y = Math.max(0, Math.floor(Math.min(...ys))); y < Math.min(height, Math.max(...ys)); y++) {
    const xs = [];  // where the outline crosses the middle of this row
    for (const r of rings)
      for (let k = 0, j = r.length - 2; k < r.length; j = k, k += 2)
        if (r[k + 1] > y + .5 !== r[j + 1] > y + .5)
          xs.push(r[k] + (r[j] - r[k]) * (y + .5 - r[k + 1]) / (r[j + 1] - r[k + 1]));
    xs.sort((a, b) => a - b);
    for (let k = 0; k + 1 < xs.length; k += 2)
      for (let x = Math.max(0, Math.ceil(xs[k] - .5)); x + .5 <= xs[k + 1] && x < width; x++) {
        const here = brightness(x, y);
        if (here > most) [most, place] = [here, [x + .5, y + .5]];
      }
  }
  return place;
}

export function dot_at(c, x, y, unit, colour) {
  c.beginPath();
  c.arc(x, y, 5 * unit, 0, 2 * Math.PI);
  c.fillStyle = colour;
  c.fill();
  c.strokeStyle = '#000';
  c.lineWidth = 1.5 * unit;
  c.stroke();
}

// Is a place inside of rings (even-odd)?
export function inside(rings, x, y) {
  let is = false;
  for (const r of rings)
    for (let k = 0, j = r.length - 2; k < r.length; j = k, k += 2)
      if (r[k + 1] > y !== r[j + 1] > y && x < (r[j] - r[k]) * (y - r[k + 1]) / (r[j + 1] - r[k + 1]) + r[k]) is = !is;
  return is;
}
