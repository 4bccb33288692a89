// Asks vcview for news, again as soon as the last answer is drawn; so a slow page gets fewer pictures, not late ones.
import { PictureView, contours, difference, falsecolor, luminance, short, toned } from '/picture.js';
import { Lines, fill_table, plot } from '/plot.js';

const $ = (id) => document.getElementById(id);
const token = location.hash.slice(1);
const ask = (path, more) => fetch(path, { ...more, headers: { 'X-Luxpipe-Token': token } });

const view = new PictureView($('canvas')), lines = new Lines(), chosen = new Set();
let news = { picture: 0, line: 0 }, shown = null, kept = null, held = null, srgb = [], table = null, ended;

// ---- the picture

async function choose_table() {
  const question = new URLSearchParams({ top: Number($('top').value) || shown.top, decades: $('decades').value || 3,
    divisions: $('divisions').value || 8, mask: $('mask').value || 0, style: $('style').value === 'smooth' ? 'smooth' : 'bands' });
  if (table && table.question === question.toString()) return;
  const answer = await ask('/table?' + question);
  if (!answer.ok) return;
  table = await answer.json();
  table.question = question.toString();
  table.top = Number(question.get('top'));
  table.decades = Number(question.get('decades'));
}

function exposure() {
  const e = $('hold').checked && held ? held : shown.exposure;
  held = e;
  return [e[0] * 2 ** Number($('stops').value), e[1]];
}

function bytes_of(rgb) {
  const kind = $('tone').value;
  if (kind !== 'falsecolor') return toned(rgb, kind, exposure(), srgb);
  if ($('style').value === 'contours') return contours(rgb, shown.width, shown.height, table, shown.exposure, srgb);
  return falsecolor(rgb, table);
}

async function show() {
  if (!shown) return;
  const kind = $('tone').value;
  document.querySelectorAll('.for-falsecolor > *').forEach((e) => { e.hidden = kind !== 'falsecolor'; });
  document.querySelectorAll('.for-photo > *').forEach((e) => { e.hidden = kind === 'falsecolor'; });
  if (kind === 'falsecolor') await choose_table();
  const with_kept = kept && kept.length === shown.rgb.length ? $('compare').value : 'no';
  const bytes = with_kept === 'difference' ? difference(shown.rgb, kept) : bytes_of(with_kept === 'kept' ? kept : shown.rgb);
  view.show(bytes, shown.width, shown.height, shown.rgb, with_kept === 'wipe' ? bytes_of(kept) : null);
  draw_legend(kind, with_kept);
  document.body.dataset.picture = news.picture;
}

function draw_legend(kind, with_kept) {
  const canvas = $('legend'), c = canvas.getContext('2d');
  canvas.hidden = kind !== 'falsecolor' || with_kept === 'difference';
  if (canvas.hidden) return;
  c.clearRect(0, 0, canvas.width, canvas.height);
  const place = (t) => table.decades > 0 ? table.top * 10 ** (table.decades * (t - 1)) : table.top * t;
  const colour = (v) => { let k = 0; while (k < table.thresholds.length && v >= table.thresholds[k]) k++; return table.colours.slice(3 * k, 3 * k + 3); };
  for (let x = 0; x < canvas.width; x++) {
    c.fillStyle = `rgb(${colour(place(x / (canvas.width - 1)))})`;
    c.fillRect(x, 0, 1, 16);
  }
  c.fillStyle = getComputedStyle(document.body).color;
  c.font = '12px system-ui, sans-serif';
  for (let k = 0; k <= 4; k++) {
    c.textAlign = k === 0 ? 'left' : k === 4 ? 'right' : 'center';
    c.fillText(short(place(k / 4)) + (k === 4 ? ' cd/m²' : ''), k / 4 * canvas.width, 30);
  }
}

let probing = false, probed = null;
async function probe(at) {
  probed = at;
  if (!at || !shown) return;
  const i = 3 * (at.y * shown.width + at.x), text = `pixel ${at.x}, ${at.y}: ${short(luminance(shown.rgb, i))} cd/m²`;
  $('probe').textContent = text;
  if (probing) return;
  probing = true;
  try {
    const answer = await ask(`/pixel?x=${at.x}&y=${at.y}`);
    if (answer.ok && probed === at) {
      const p = await answer.json();
      $('probe').textContent = text + (p.direction ? `, ${short(p.angle)}° from the line of sight, direction ${p.direction.map(short).join(' ')}, ` +
        `solid angle ${short(p.omega)} sr, position index ${short(p.position)}` : '');
    }
  } finally {
    probing = false;
    if (probed !== at) probe(probed);
  }
}

// ---- the numbers

function draw_numbers() {
  if (!chosen.size) lines.metrics().slice(0, 3).forEach((name) => chosen.add(name));
  fill_table($('table').tBodies[0], lines, chosen, (name) => {
    if (!chosen.delete(name)) chosen.add(name);
    draw_numbers();
  });
  $('plots').replaceChildren(...[...chosen].map((name) => {
    const figure = document.createElement('figure'), caption = document.createElement('figcaption');
    caption.textContent = name;
    figure.append(caption, plot(name, lines.rows));
    return figure;
  }));
  document.body.dataset.lines = lines.text.length;
}

function say_status() {
  const parts = [];
  if (shown) parts.push(`${shown.width} × ${shown.height}`, shown.frames === undefined ? '' : `${shown.frames} frames`, shown.name);
  if (ended !== undefined) parts.push(ended === 0 ? 'finished' : `finished with status ${ended}`);
  $('status').textContent = parts.filter(Boolean).join(', ') || 'waiting for the first picture';
}

// ---- news

async function take(answer) {
  const body = await answer.arrayBuffer(), length = new DataView(body).getUint32(0, true);
  const facts = JSON.parse(new TextDecoder().decode(new Uint8Array(body, 4, length)));
  news = { picture: facts.picture, line: facts.line };
  facts.lines.forEach((line) => lines.add(line));
  ended = facts.ended;
  if (facts.width) {
    shown = { ...facts, rgb: new Float32Array(body.slice(4 + length)) };
    await show();
  }
  if (facts.lines.length) draw_numbers();
  say_status();
}

async function listen() {
  const codes = await ask('/srgb');
  if (codes.status === 401) return void ($('status').textContent = 'this link is not the one that vcview printed');
  srgb = await codes.json();
  for (;;) {
    try {
      const answer = await ask(`/next?picture=${news.picture}&line=${news.line}${ended === undefined ? '' : '&end=1'}`);
      if (answer.status === 200) await take(answer);
      await new Promise(requestAnimationFrame);
    } catch {
      if (ended === undefined) $('status').textContent = 'the connection to vcview has ended';
      return;
    }
  }
}

// ---- what people do

for (const id of ['tone', 'style', 'top', 'decades', 'divisions', 'mask', 'compare', 'hold']) $(id).addEventListener('change', show);
$('stops').addEventListener('input', () => { $('stops-value').value = $('stops').value; show(); });
$('fit').addEventListener('click', () => view.fit());
$('keep').addEventListener('click', () => {
  if (!shown) return;
  kept = shown.rgb;
  $('compare').disabled = false;
  show();
});

let drag = null;
const canvas = $('canvas');
canvas.addEventListener('pointerdown', (e) => {
  drag = { x: e.clientX, y: e.clientY };
  canvas.setPointerCapture(e.pointerId);
});
canvas.addEventListener('pointermove', (e) => {
  if (drag && $('compare').value === 'wipe' && e.shiftKey) {
    const at = view.pixel(e.clientX, e.clientY);
    if (at) { view.wipe = at.x / shown.width; show(); }
  } else if (drag) {
    view.moveBy(e.clientX - drag.x, e.clientY - drag.y);
    drag = { x: e.clientX, y: e.clientY };
  }
  probe(view.pixel(e.clientX, e.clientY));
});
canvas.addEventListener('pointerup', () => { drag = null; });
canvas.addEventListener('wheel', (e) => {
  e.preventDefault();
  view.zoomBy(2 ** (-e.deltaY / 300), e.clientX, e.clientY);
}, { passive: false });

function next_of(select) {
  if (select.disabled) return;
  select.selectedIndex = (select.selectedIndex + 1) % select.length;
  show();
}
const keys = {
  'f': () => view.fit(), '+': () => view.zoomBy(1.5), '=': () => view.zoomBy(1.5), '-': () => view.zoomBy(1 / 1.5),
  'ArrowLeft': () => view.moveBy(40, 0), 'ArrowRight': () => view.moveBy(-40, 0),
  'ArrowUp': () => view.moveBy(0, 40), 'ArrowDown': () => view.moveBy(0, -40),
  't': () => next_of($('tone')), 'c': () => next_of($('compare')), 'k': () => $('keep').click(),
  '[': () => { $('stops').stepDown(); $('stops').dispatchEvent(new Event('input')); },
  ']': () => { $('stops').stepUp(); $('stops').dispatchEvent(new Event('input')); },
};
document.addEventListener('keydown', (e) => {
  if (e.target.matches('input, select, textarea') || e.ctrlKey || e.metaKey || e.altKey || !keys[e.key]) return;
  if (e.key.startsWith('Arrow') && e.target !== canvas) return;
  e.preventDefault();
  keys[e.key]();
});

function save(name, type, data) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([data], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
$('save-png').addEventListener('click', () => view.image.toBlob((blob) => save('luxpipe.png', 'image/png', blob)));
$('save-tsv').addEventListener('click', () => save('luxpipe.tsv', 'text/tab-separated-values', lines.text.join('\n') + '\n'));
$('save-svg').addEventListener('click', () => {
  const rules = 'text{font:11px sans-serif}.axis{stroke:#999;fill:none}.curve{stroke:#0b5cad;fill:none}.interval{fill:#0b5cad33}.class{stroke:#777;stroke-dasharray:3 3}';
  const all = [...document.querySelectorAll('#plots figure')].map((f, k) =>
    `<g transform="translate(0,${170 * k})"><text x="4" y="12">${f.querySelector('figcaption').textContent}</text>` +
    `<g transform="translate(0,16)">${f.querySelector('svg').innerHTML}</g></g>`);
  save('luxpipe.svg', 'image/svg+xml',
    `<svg xmlns="http://www.w3.org/2000/svg" width="420" height="${170 * all.length}"><style>${rules}</style>${all.join('')}</svg>`);
});

$('command').addEventListener('submit', async (e) => {
  e.preventDefault();
  const answer = await ask('/control', { method: 'POST', body: $('command-text').value });
  $('command-text').setCustomValidity(answer.ok ? '' : await answer.text());
  $('command-text').reportValidity();
  if (answer.ok) $('command-text').value = '';
});
ask('/facts').then(async (answer) => { if (answer.ok) $('command').hidden = !(await answer.json()).control; });

listen();
