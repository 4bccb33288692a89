// A roller shade, or a venetian blind, before a window: lines of a scene file.
// corners: those of the pane, four points of a rectangle; eye: a point on its side; lines(name): those of its material.
// Both give the text of the file with it, and its name.
import { digits } from '/model_text.js';
import { cross, dot, length, plus, unit } from '/view.js';

const fabric_over = .02, slats_over = .05;  // metres from the pane
const slat = { width: .05, thickness: .0008, apart: .042, tilt: 35 };

// With the first free number.
function with_new(text, kind, of_it, lines, surface) {
  let n = 1;
  while (text.includes(`${kind}_${n}`)) n++;
  const name = `${kind}_${n}`, material = `${name}_${of_it}`;
  return [`${text.replace(/\n?$/, '\n')}\n${lines(material)}\n\n${surface(name, material)}\n`, name];
}

// Towards the eye.
function normal_of(corners, eye) {
  const normal = unit(cross(plus(corners[1], corners[0], -1), plus(corners[2], corners[0], -1)));
  return dot(normal, plus(eye, corners[0], -1)) < 0 ? normal.map((v) => -v) : normal;
}

// The upper half of a window, or all of a rooflight.
export function with_shade(text, corners, eye, lines) {
  const normal = normal_of(corners, eye), heights = corners.map((c) => c[2]);
  const [low, high] = [Math.min(...heights), Math.max(...heights)], middle = (low + high) / 2;
  const upright = high - low > .1 * length(plus(corners[2], corners[0], -1));
  const points = corners.map(([x, y, z]) =>
    plus([x, y, upright ? Math.max(z, middle) : z], normal, fabric_over).map(digits).join(' '));
  return with_new(text, 'roller_shade', 'fabric', lines, (name, fabric) =>
    `${fabric} polygon ${name}\n0\n0\n12 ${points.join('  ')}`);
}

export const takes_slats = (corners, eye) => Math.abs(normal_of(corners, eye)[2]) < .3;

// Slats from the top to the sill, their outer edge lower.
export function with_blind(text, corners, eye, lines) {
  const [nx, ny] = normal_of(corners, eye), out = unit([nx, ny, 0]), along = cross(out, [0, 0, 1]);
  const places = corners.map((c) => dot(c, along)), heights = corners.map((c) => c[2]);
  const [low, high] = [Math.min(...heights), Math.max(...heights)], left = Math.min(...places);
  const corner = plus(plus(out, out, dot(corners[0], out) + slats_over - 1), along, left);
  const count = Math.max(1, Math.floor((high - low) / slat.apart)), width = Math.max(...places) - left;
  const turn = Math.atan2(along[1], along[0]) * 180 / Math.PI;
  const at = [corner[0], corner[1], high - slat.apart / 2].map(digits).join(' ');
  return with_new(text, 'blind', 'slat', lines, (name, paint) =>
    `!genbox ${paint} ${name} ${digits(width)} ${slat.width} ${slat.thickness} | xform -t 0 ${-slat.width / 2} 0 ` +
    `-rx ${slat.tilt} -a ${count} -t 0 0 ${-slat.apart} -i 1 -rz ${digits(turn)} -t ${at}`);
}
