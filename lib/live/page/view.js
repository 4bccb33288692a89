// A view (lib/view): from places of the picture to directions and back.  Places are fractions of the picture, x to the
// right and y up; directions are unit vectors in world axes.
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const plus = (a, b, by = 1) => a.map((v, k) => v + by * b[k]);
export const length = (a) => Math.hypot(...a);
export const unit = (a) => { const l = length(a) || 1; return a.map((v) => v / l); };

// v turned around an axis (unit) by an angle in radians (Rodrigues).
export function turned(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), along = dot(axis, v) * (1 - c), across = cross(axis, v);
  return v.map((x, k) => x * c + across[k] * s + axis[k] * along);
}

const degree = Math.PI / 180;
const sizes = {
  v: (a) => 2 * Math.tan(a / 2 * degree), l: (a) => a, a: (a) => a / 180,
  h: (a) => 2 * Math.sin(a / 2 * degree), s: (a) => 2 * Math.tan(a / 4 * degree),
};

export class Eye {
  // options: as in a VIEW= line, all of them.
  constructor(options) {
    this.options = options;
    const words = options.trim().split(/\s+/), numbers = (name, n) => {
      const at = words.indexOf(name);
      return at < 0 ? Array(n).fill(0) : words.slice(at + 1, at + 1 + n).map(Number);
    };
    this.type = (words.find((w) => w.startsWith('-vt')) ?? '-vtv')[3];
    this.vp = numbers('-vp', 3);
    this.vd = unit(numbers('-vd', 3));
    this.vu = numbers('-vu', 3);
    [this.vh] = numbers('-vh', 1);
    [this.vv] = numbers('-vv', 1);
    this.shift = [numbers('-vs', 1)[0], numbers('-vl', 1)[0]];
    this.right = unit(cross(this.vd, this.vu));
    this.up = cross(this.right, this.vd);
    const size = sizes[this.type];
    this.size = this.type === 'c' ? [this.vh * degree, sizes.v(this.vv)] : [size(this.vh), size(this.vv)];
  }

  direction([x, y]) {
    const a = this.size[0] * (x - .5 + this.shift[0]), b = this.size[1] * (y - .5 + this.shift[1]), q2 = a * a + b * b;
    const q = Math.sqrt(q2), sum = (d, h, u) => unit(plus(plus(this.vd.map((v) => v * d), this.right, h), this.up, u));
    switch (this.type) {
      case 'v': return sum(1, a, b);
      case 'a': {
        if (q > 1) return null;
        const k = q > 0 ? Math.sin(Math.PI * q) / q : Math.PI;
        return sum(Math.cos(Math.PI * q), k * a, k * b);
      }
      case 'h': return q2 > 1 ? null : sum(Math.sqrt(1 - q2), a, b);
      case 's': { const z = (1 - q2) / (1 + q2); return sum(z, (1 + z) * a, (1 + z) * b); }
      case 'c': return sum(Math.cos(a), Math.sin(a), b);
      default: return null;
    }
  }

  place(direction) {
    const z = dot(direction, this.vd), a = dot(direction, this.right), b = dot(direction, this.up),
          s = Math.hypot(a, b);
    const at = (x, y) => [x / this.size[0] + .5 - this.shift[0], y / this.size[1] + .5 - this.shift[1]];
    switch (this.type) {
      case 'v': return z > 0 ? at(a / z, b / z) : null;
      case 'a': {
        if (s === 0 && z < 0) return null;
        const k = s > 0 ? Math.atan2(s, z) / Math.PI / s : 0;
        return at(a * k, b * k);
      }
      case 'h': return z >= 0 ? at(a, b) : null;
      case 's': return z > -1 ? at(a / (1 + z), b / (1 + z)) : null;
      case 'c': { const r = Math.hypot(z, a); return r > 0 ? at(Math.atan2(a, z), b / r) : null; }
      default: return null;
    }
  }

  // Where the ray of a place meets the plane through a point; null: it does not.
  on_plane(place, point, normal) {
    const d = this.direction(place);
    const t = d && dot(normal, plus(point, this.vp, -1)) / dot(normal, d);
    return d && t > 0 && Number.isFinite(t) ? plus(this.vp, d, t) : null;
  }
}
