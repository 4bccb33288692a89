// One shape of a region file (vcregion(5)), as its text says it and as points that can be dragged in the picture.
//   { kind, frame, points, angle, rest }   frame: pixel, fraction, direction, space or view; angle: of a circle, in
//   degrees; rest: what is behind the points of disc3d and sphere3d (normal, radius)
import { cross, dot, length, plus, turned, unit } from '/view.js';

const space = { polygon3d: [3, 0], box3d: [3, 0], disc3d: [3, 4], sphere3d: [3, 1] };  // numbers a point, numbers after
const per_point = { pixel: 2, fraction: 2, direction: 3, point: 3, view: 0 };

// null: no single shape with points (a set, a zone, a mask, surfaces of the scene).
export function parse_shape(text) {
  const words = text.trim().split(/\s+/), kind = words.shift();
  let frame = words[0] in per_point ? words.shift() : undefined;
  const numbers = words.map((w) => parseFloat(w));
  if (numbers.some((v, k) => !Number.isFinite(v) || (k < numbers.length - 1 && !/^[-+.\de]+$/i.test(words[k]))))
    return null;
  const unit_of = (words[words.length - 1] ?? '').replace(/^[-+.\d]+(e[-+]?\d+)?/i, '');
  let angle, rest = [], each;
  if (kind in space) {
    [each] = space[kind];
    rest = space[kind][1] ? numbers.splice(3) : [];
    frame = 'space';
  } else if (kind === 'circle') {
    frame ??= numbers.length === 4 ? 'direction' : 'pixel';
    each = per_point[frame];
    angle = numbers.pop() * (unit_of === 'rad' ? 180 / Math.PI : 1);
  } else if (kind === 'rect' || kind === 'polygon') {
    frame ??= 'pixel';
    each = per_point[frame];
  } else return null;
  if (!(unit_of === '' || (kind === 'circle' && /^(rad|deg)$/.test(unit_of)))) return null;
  const points = [];
  while (each && numbers.length >= each) points.push(numbers.splice(0, each));
  return numbers.length ? null : { kind, frame: frame === 'point' ? 'space' : frame, points, angle, rest };
}

const digits = (v, n) => String(Number(v.toFixed(n)));
export function shape_text({ kind, frame, points, angle, rest }) {
  const n = { pixel: 1, fraction: 5, direction: 6, space: 4, view: 0 }[frame];
  const word = kind in space ? '' : frame === 'space' ? ' point' : frame === 'pixel' ? '' : ` ${frame}`;
  return kind + (kind === 'circle' && frame === 'direction' ? '' : word) +
    points.map((p) => '  ' + p.map((v) => digits(v, n)).join(' ')).join('') +
    rest.map((v) => ' ' + digits(v, 4)).join('') + (angle === undefined ? '' : '  ' + digits(angle, 3));
}

// The plane in which points of this shape move.
function plane(shape, point, eye) {
  if (shape.kind === 'disc3d') return unit(shape.rest);
  if (shape.kind !== 'polygon3d') return eye.vd;
  let sum = [0, 0, 0];
  shape.points.forEach((p, k) => { sum = plus(sum, cross(p, shape.points[(k + 1) % shape.points.length])); });
  return unit(sum);
}

// Where a point of the shape appears; size: [width, height] of the picture.  Circles are centred on centres of pixels.
const half = (shape) => shape.kind === 'circle' ? .5 : 0;
const place_of = (shape, point, eye, size) => {
  if (shape.frame === 'fraction') return point;
  if (shape.frame === 'pixel') return point.map((v, k) => (v + half(shape)) / size[k]);
  return eye.place(unit(shape.frame === 'direction' ? point : plus(point, eye.vp, -1)));
};
const point_at = (shape, old, place, eye, size) => {
  if (shape.frame === 'fraction') return place;
  if (shape.frame === 'pixel') return place.map((v, k) => v * size[k] - half(shape));
  return shape.frame === 'direction' ? eye.direction(place) : eye.on_plane(place, old, plane(shape, old, eye));
};

function centre(shape, eye, size) {
  if (shape.frame === 'view') return eye.vd;
  const place = place_of(shape, shape.points[0], eye, size);
  return place && eye.direction(place);
}

// A vector at right angles to another one.
const beside = (v, eye) => unit(cross(v, Math.abs(dot(v, eye.up)) < .9 ? eye.up : eye.right));

// Handles that can be dragged: { place, point: index } or { place, size: true }.
export function handles(shape, eye, size) {
  const all = shape.points.map((p, point) => ({ place: place_of(shape, p, eye, size), point }));
  if (shape.kind === 'circle' || shape.kind === 'sphere3d' || shape.kind === 'disc3d')
    all.push({ place: rim(shape, eye, size, 1)[0], size: true });
  return all.filter((h) => h.place);
}

// Places on the border of a round shape, n of them.
function rim(shape, eye, size, n) {
  const all = [];
  const c = shape.kind === 'circle' ? centre(shape, eye, size) : null;
  if (shape.kind === 'circle' && !c) return [];
  const axis = c ?? (shape.kind === 'disc3d' ? unit(shape.rest) : unit(plus(shape.points[0], eye.vp, -1)));
  for (let k = 0; k < n; k++) {
    const across = turned(beside(axis, eye), axis, 2 * Math.PI * k / n);
    const point = c ? turned(c, unit(cross(c, across)), shape.angle / 2 * Math.PI / 180)
      : plus(shape.points[0], across, shape.rest[shape.rest.length - 1]);
    all.push(eye.place(c ? point : unit(plus(point, eye.vp, -1))));
  }
  return all;
}

// A quick drawing of the shape while it is dragged: places one after another, closed.  (Its outline comes from the
// server.)
export function sketch(shape, eye, size) {
  if (shape.kind === 'circle' || shape.kind === 'sphere3d' || shape.kind === 'disc3d')
    return rim(shape, eye, size, 64).filter(Boolean);
  if (shape.kind === 'box3d') return shape.points.map((p) => place_of(shape, p, eye, size)).filter(Boolean);
  let corners = shape.points;
  if (shape.kind === 'rect') corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([i, j]) => [corners[i][0], corners[j][1]]);
  const steps = shape.frame === 'pixel' || shape.frame === 'fraction' ? 1 : 8, all = [];
  corners.forEach((p, k) => {
    const q = corners[(k + 1) % corners.length];
    for (let s = 0; s < steps; s++) all.push(place_of(shape, p.map((v, i) => v + (q[i] - v) * s / steps), eye, size));
  });
  return all.filter(Boolean);
}

// The shape after a handle, or all of it (null), was dragged from one place to another.
export function dragged(shape, handle, from, to, eye, size) {
  const next = { ...shape, points: shape.points.map((p) => [...p]), rest: [...shape.rest] };
  if (handle?.size && shape.kind === 'circle') {
    const c = centre(shape, eye, size), d = eye.direction(to);
    if (c && d) next.angle = Math.max(.1, 2 * Math.acos(Math.max(-1, Math.min(1, dot(c, d)))) * 180 / Math.PI);
  } else if (handle?.size) {
    const p = point_at(shape, shape.points[0], to, eye, size);
    if (p) next.rest[next.rest.length - 1] = Math.max(.001, length(plus(p, shape.points[0], -1)));
  } else if (handle && !(shape.kind === 'circle' || shape.points.length === 1)) {
    const p = point_at(shape, shape.points[handle.point], to, eye, size);
    if (p) next.points[handle.point] = p;
  } else if (shape.frame === 'direction') {
    const a = eye.direction(from), b = eye.direction(to), axis = a && b && cross(a, b);
    if (axis && length(axis) > 1e-9)
      next.points = shape.points.map((p) => turned(unit(p), unit(axis), Math.atan2(length(axis), dot(a, b))));
  } else if (shape.points.length) {
    const a = point_at(shape, shape.points[0], from, eye, size), b = point_at(shape, shape.points[0], to, eye, size);
    if (a && b) next.points = shape.points.map((p) => plus(p, plus(b, a, -1)));
  }
  return next;
}
