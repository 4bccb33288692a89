// A line below the picture that describes the pixel under the pointer.
import { ask } from '/net.js';
import { luminance, short } from '/picture.js';

const $ = (id) => document.getElementById(id);

export class Probe {
  // more: functions of x, y that give words on the pixel, or ''.
  constructor(more) { this.more = more; this.asking = false; this.at = null; }

  // at: { x, y }, whole pixels, or null.
  async show(at, picture) {
    this.at = at;
    if (!at || !picture) return;
    const words = [`pixel ${at.x}, ${at.y}: ${short(luminance(picture.rgb, 3 * (at.y * picture.width + at.x)))} cd/m²`,
      ...this.more.map((f) => f(at.x, at.y)).filter(Boolean)].join(', ');
    $('probe').textContent = words;
    if (this.asking) return;
    this.asking = true;
    try {
      const answer = await ask(`/pixel?x=${at.x}&y=${at.y}`);
      if (answer.ok && this.at === at) {
        const p = await answer.json();
        if (p.direction)
          $('probe').textContent = `${words}, ${short(p.angle)}° from the line of sight, direction ${p.direction.map((v) => short(v)).join(' ')}, ` +
            `solid angle ${short(p.omega)} sr, position index ${short(p.position)}`;
      }
    } finally {
      this.asking = false;
      if (this.at !== at) this.show(this.at, picture);
    }
  }
}
