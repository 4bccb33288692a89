// A line below the picture that describes the pixel under the pointer.
import { ask } from '/net.js';
import { luminance, short } from '/picture.js';

const $ = (id) => document.getElementById(id);

export class Probe {
  // more: functions of x, y that give words on the pixel, or ''; later: one that gives them in a while, where the
  // pointer rests.
  constructor(more, later) { Object.assign(this, { more, later, asking: false, at: null }); }

  // at: { x, y }, whole pixels, or null.
  async show(at, picture) {
    this.at = at;
    if (!at || !picture) return;
    const words = [`pixel ${at.x}, ${at.y}: ${short(luminance(picture.rgb, 3 * (at.y * picture.width + at.x)))} cd/m²`,
      ...this.more.map((f) => f(at.x, at.y)).filter(Boolean)].join(', ');
    let [facts, names] = ['', ''];
    const say = () => { if (this.at === at) $('probe').textContent = words + names + facts; };
    say();
    clearTimeout(this.rests);
    this.rests = setTimeout(async () => {
      names = (await this.later(at.x, at.y)).replace(/^(?=.)/, ', ');
      say();
    }, 150);
    if (this.asking) return;
    this.asking = true;
    try {
      const answer = await ask(`/pixel?x=${at.x}&y=${at.y}`), p = answer.ok ? await answer.json() : {};
      if (p.direction)
        facts =
          `, ${short(p.angle)}° from the line of sight, direction ${p.direction.map((v) => short(v)).join(' ')}, ` +
          `solid angle ${short(p.omega)} sr, position index ${short(p.position)}`;
      say();
    } finally {
      this.asking = false;
      if (this.at !== at) this.show(this.at, picture);
    }
  }
}
