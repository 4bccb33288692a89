// Asks vcview for news, again as soon as the last answer is drawn; so a slow page gets fewer pictures, not late ones.
import { Camera } from '/camera.js';
import { Edits } from '/edits.js';
import { ask, command } from '/net.js';
import { PictureView } from '/picture.js';
import { Lines, fill_table, plot } from '/plot.js';
import { follow } from '/pointer.js';
import { Probe } from '/probe.js';
import { Regions } from '/regions.js';
import { wire_saving } from '/save.js';
import { Sliders } from '/sliders.js';
import { Sources } from '/sources.js';
import { Tones } from '/tones.js';
import { Eye } from '/view.js';

const $ = (id) => document.getElementById(id);

const view = new PictureView($('canvas')), tones = new Tones(view), lines = new Lines(), chosen = new Set(), known = new Set();
let news = { picture: 0, line: 0, files: 0 }, shown = null, ended;

const regions = new Regions(view, () => shown?.eye ? shown : null);
const sources = new Sources(view), edits = new Edits(), sliders = new Sliders();
const camera = new Camera(() => shown, () => regions.pivot());
const probe = new Probe([(x, y) => regions.at(x, y).map((name) => `in ${name}`).join(', '), (x, y) => sources.at(x, y)]);

function draw_numbers() {
  const names = lines.metrics().filter((name) => !name.endsWith('.px'));  // a band in the plot of its metric
  if (!known.size) names.slice(0, 2).forEach((name) => chosen.add(name));
  else names.filter((name) => !known.has(name)).forEach((name) => chosen.add(name));  // of a region that is new
  names.forEach((name) => known.add(name));
  fill_table($('table').tBodies[0], lines, chosen, (name) => {
    if (!chosen.delete(name)) chosen.add(name);
    draw_numbers();
  });
  $('plots').replaceChildren(...[...chosen].filter((name) => lines.columns.includes(name)).map((name) => {
    const figure = document.createElement('figure'), caption = document.createElement('figcaption');
    caption.textContent = name;
    figure.append(caption, plot(name, lines.runs));
    return figure;
  }));
  edits.fill(lines.runs, [...chosen].filter((name) => lines.columns.includes(name)));
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
  if (facts.files !== news.files) {
    regions.reload();
    sliders.reload();
  }
  news = { picture: facts.picture, line: facts.line, files: facts.files };
  facts.lines.forEach((line) => lines.add(line));
  ended = facts.ended;
  if (facts.width) {
    const same = shown && shown.view === facts.view && shown.width === facts.width && shown.height === facts.height;
    shown = { ...facts, rgb: new Float32Array(body.slice(4 + length)), eye: facts.view ? same ? shown.eye : new Eye(facts.view) : null };
    await tones.show(shown);
    if (!document.body.dataset.picture) performance.mark('picture');
    if (!same) regions.fetch_outlines();
    edits.note(facts.edit, facts.what, sliders.said);
    camera.painted(facts.edit, facts.what);
    if (facts.what !== 'preview') sources.show(news.picture);
    document.body.dataset.picture = news.picture;
  }
  if (facts.lines.length) draw_numbers();
  say_status();
}

async function listen() {
  const codes = await ask('/srgb');
  if (codes.status === 401) return void ($('status').textContent = 'this link is not the one that vcview printed');
  tones.srgb = await codes.json();
  const facts = await (await ask('/facts')).json();
  $('command').hidden = !facts.control;
  if (facts.control) camera.show();
  facts.files.forEach((f, n) => (f.regions ? regions : sliders).use(n, f));
  for (;;) {
    try {
      const answer = await ask(`/next?picture=${news.picture}&line=${news.line}&files=${news.files}${ended === undefined ? '' : '&end=1'}`);
      if (answer.status === 200) await take(answer);
      await new Promise(requestAnimationFrame);
    } catch (e) {
      if (ended === undefined) $('status').textContent = 'the connection to vcview has ended';
      return;
    }
  }
}

// ---- what people do

$('fit').addEventListener('click', () => view.fit());
follow(view, [regions, camera], (at) => probe.show(at, shown), (e, at) => {
  if (!(tones.wiping && e.shiftKey)) return false;
  tones.wipe_to(Math.max(0, Math.min(1, at.x / shown.width)));
  return true;
});

const keys = {
  'f': () => view.fit(), '+': () => view.zoomBy(1.5), '=': () => view.zoomBy(1.5), '-': () => view.zoomBy(1 / 1.5),
  'ArrowLeft': () => view.moveBy(40, 0), 'ArrowRight': () => view.moveBy(-40, 0),
  'ArrowUp': () => view.moveBy(0, 40), 'ArrowDown': () => view.moveBy(0, -40),
  't': () => tones.next_of($('tone')), 'c': () => tones.next_of($('compare')), 'k': () => tones.keep(),
  '[': () => tones.brighter(-.25), ']': () => tones.brighter(.25),
};
document.addEventListener('keydown', (e) => {
  if (e.target.matches('input, select, textarea') || e.ctrlKey || e.metaKey || e.altKey) return;
  const on_canvas = e.target === $('canvas');
  if ((on_canvas && regions.key(e)) || camera.key(e)) return void e.preventDefault();
  if (!keys[e.key] || (e.key.startsWith('Arrow') && !on_canvas)) return;
  e.preventDefault();
  keys[e.key]();
});

$('command').addEventListener('submit', async (e) => {
  e.preventDefault();
  const wrong = await command($('command-text').value);
  $('command-text').setCustomValidity(wrong);
  $('command-text').reportValidity();
  if (!wrong) $('command-text').value = '';
});
$('command-text').addEventListener('input', () => $('command-text').setCustomValidity(''));
wire_saving(view, lines);

listen();
