// Asks vcview for news, again as soon as the last answer is drawn; so a slow page gets fewer pictures, not late ones.
import { Camera } from '/camera.js';
import { Day } from '/day.js';
import { Edits } from '/edits.js';
import { glare_of, verdict } from '/judge.js';
import { Library } from '/library.js';
import { show_messages } from '/messages.js';
import { ask, command, Lost, post, tag_of, unpack } from '/net.js';
import { PictureView } from '/picture.js';
import { Plan } from '/plan.js';
import { Lines, fill_table, plot } from '/plot.js';
import { Pointed } from '/pointed.js';
import { follow } from '/pointer.js';
import { Probe } from '/probe.js';
import { Regions } from '/regions.js';
import { wire_saving } from '/save.js';
import { Sky } from '/sky.js';
import { Sliders } from '/sliders.js';
import { Sources } from '/sources.js';
import { Tones } from '/tones.js';
import { Variants } from '/variants.js';
import { show_verdict } from '/verdict.js';
import { Eye } from '/view.js';

const $ = (id) => document.getElementById(id);

const view = new PictureView($('canvas')), tones = new Tones(view), lines = new Lines(), chosen = new Set(), known = new Set();
let design = {};  // of the newest state: first, waits
let news = { picture: 0, line: 0, files: 0, design: 0 }, shown = null, ended, lost = false, refused = false, paused = false, steps = 0, came, scene = '';

const regions = new Regions(view, () => shown?.eye ? shown : null);
const edits = new Edits(draw_edits), sliders = new Sliders();
const camera = new Camera(() => shown, () => regions.pivot());
const variants = new Variants((text) => camera.say(text), (rgb, name) => tones.compare_with(rgb, name), (edit) => {
  const rows = lines.runs.find((r) => r.edit === edit)?.rows, last = rows?.[rows.length - 1];
  return rows && verdict(glare_of(lines.columns, last), last).number;
});
const sky = new Sky(sliders);
const day = new Day(sliders), plan = new Plan(camera);
const library = new Library(), pointed = new Pointed(() => shown, sliders, library);
const sources = new Sources(view, (x, y) => pointed.called(x, y));
const probe = new Probe([(x, y) => regions.at(x, y).map((name) => `in ${name}`).join(', '), (x, y) => sources.at(x, y)], (x, y) => pointed.words(x, y));

function draw_numbers() {
  const names = lines.metrics().filter((name) => !name.endsWith('.px'));  // a band in the plot of its metric
  if (!known.size) names.filter((name, k) => k < 2 || /(^|\.)(TAL|CR)\b/.test(name)).forEach((name) => chosen.add(name));
  else names.filter((name) => !known.has(name)).forEach((name) => chosen.add(name));  // of a region that is new
  names.forEach((name) => known.add(name));
  fill_table($('table').tBodies[0], lines, chosen, (name) => {
    if (!chosen.delete(name)) chosen.add(name);
    draw_numbers();
  }, (name) => regions.of_elsewhere(name));
  $('plots').replaceChildren(...[...chosen].filter((name) => lines.columns.includes(name)).map((name) => {
    const figure = document.createElement('figure'), caption = document.createElement('figcaption');
    caption.textContent = name;
    figure.append(caption, plot(name, lines.runs));
    return figure;
  }));
  draw_edits();
  document.body.dataset.lines = lines.text.length;
}

function draw_edits() {
  edits.fill(lines.runs, [...chosen].filter((name) => lines.columns.includes(name)), glare_of(lines.columns, lines.rows.at(-1)));
}

// The scene, its hour and the view, in the head and in the tab.
function say_where() {
  const where = [scene, sliders.when(), shown?.name, camera.called()].filter(Boolean).join(', ');
  if ($('where').textContent !== where) $('where').textContent = where || 'luxpipe';
  document.title = where ? `${where} – luxpipe` : 'luxpipe';
}

// lost, ended, paused: of the programs; the picture's facts beside them.
function say_status() {
  const since = came === undefined ? undefined : (performance.now() - came) / 1000;
  show_verdict(lines, { lost, refused, ended, paused, what: shown?.what, since, ...design });
  say_where();
  const parts = shown ? [`${shown.width} × ${shown.height}`, shown.frames === undefined ? '' : `${shown.frames} frames`] : [];
  $('status').textContent = parts.filter(Boolean).join(', ');
}
setInterval(say_status, 5000);

// ---- news

// State that vcview holds for all windows.
async function take_state(state) {
  paused = state.paused;
  design = { first: state.first, waits: state.waits, rests: state.rests };
  $('go').hidden = !state.rests;
  edits.take(state.edits, state.earlier, state.variants, state.base, state.against);
  lines.keeps = new Set(state.variants.map((v) => v.edit));
  variants.take(state.variants, state.base, state.before);
  show_messages(state);
  camera.take(state.views, state.places);
  steps = Math.max(steps, state.steps[0]);
  [['undo', 'Takes back', 'Ctrl-Z'], ['redo', 'Makes again', 'Ctrl-Shift-Z']].forEach(([id, does, key], k) => {
    const [count, words] = [state.steps[1 + k], state.steps[3 + k] || 'nothing'];
    Object.assign($(id), { disabled: !count, title: `${does}: ${words} (${key})` });
  });
  $('again').hidden = !state.again;
  await sliders.take(state.texts);
  sky.take();
  day.take(state.day);
  plan.take(state.plan);
}

async function take(answer) {
  const facts = await unpack(answer);
  if (facts.files !== news.files) regions.reload();
  news = { picture: facts.picture, line: facts.line, files: facts.files, design: facts.design };
  facts.lines.forEach((line) => lines.add(line));
  ended = facts.ended;
  if (facts.state) await take_state(facts.state);
  if (facts.width) {
    const same = shown && shown.view === facts.view && shown.width === facts.width && shown.height === facts.height;
    shown = { ...facts, eye: facts.view ? same ? shown.eye : new Eye(facts.view) : null };
    came = performance.now();
    await tones.show(shown);
    if (!document.body.dataset.picture) performance.mark('picture');
    if (!same) { sources.forget(); regions.fetch_outlines(); regions.mark_rows(); }
    camera.painted(facts.edit, facts.what);
    plan.show_eye();
    if (facts.what !== 'preview') sources.show(news.picture);
    document.body.dataset.picture = news.picture;
  }
  if (facts.lines.length) { draw_numbers(); variants.show_numbers(); }
  else if (facts.state) draw_edits();
  say_status();
}

// False: this window may not ask.
async function begin() {
  const codes = await ask('/srgb');
  refused = codes.status === 401;
  say_status();
  if (refused) return false;
  tones.srgb = await codes.json();
  const facts = await (await ask('/facts')).json();
  $('command').hidden = $('views').hidden = !facts.control;
  if (facts.control) camera.show();
  scene = facts.scene;
  if (facts.control && facts.files.some((f) => !f.regions)) $('probe').textContent = 'Click a thing to change it; point at it for values.';
  await library.read();
  await Promise.all(facts.files.map((f, n) => (f.regions ? regions : sliders).use(n, f)));
  return true;
}

// Goes on by itself after the connection was lost, with growing pauses.
async function listen() {
  for (let pause = 0, begun = false; ;) {
    try {
      if (!begun && !await begin()) return;
      begun = true;
      const question = new URLSearchParams({ ...news, ...(ended === undefined ? {} : { end: 1 }) });
      const answer = await ask(`/next?${question}`);
      if (answer.status === 200) await take(answer);
      if (answer.status === 401) return void (await begin());
      if (lost) { lost = false; say_status(); }
      pause = 0;
      await new Promise(requestAnimationFrame);
    } catch (e) {
      if (!(e instanceof Lost)) throw e;
      lost = true;
      say_status();
      pause = Math.min(30, 2 * pause || 1);
      await new Promise((go) => setTimeout(go, 1000 * pause));
    }
  }
}

// ---- what people do

// One after another: each is of the state that the one before has left.
let undoing = Promise.resolve();
const take_back = (what) => {
  undoing = undoing.then(async () => {
    const answer = await ask(`/${what}?state=${steps}`, { method: 'POST' });
    if (answer.ok) steps = Number(tag_of(answer));
    sliders.say(answer.ok ? '' : (await answer.text()).trim());
  }).catch((e) => sliders.say(e.message));
};
for (const what of ['undo', 'redo']) $(what).addEventListener('click', () => take_back(what));
$('go').addEventListener('click', () => command('go').then((wrong) => camera.say(wrong)));
$('again').addEventListener('click', () => post('/start').then((wrong) => camera.say(wrong)));
$('fit').addEventListener('click', () => view.fit());
$('canvas').addEventListener('pointerdown', () => document.querySelectorAll('.menu[open]').forEach((m) => { m.open = false; }));
for (const menu of document.querySelectorAll('.menu')) {
  menu.addEventListener('toggle', () => { if (menu.open) document.querySelectorAll('.menu[open]').forEach((m) => { m.open = m === menu; }); });
  menu.addEventListener('keydown', (e) => { if (e.key === 'Escape') { menu.open = false; menu.firstElementChild.focus(); } });
}
follow(view, [regions, camera], (at) => probe.show(at, shown), (e, at) => {
  if (!(tones.wiping && e.shiftKey)) return false;
  tones.wipe_to(Math.max(0, Math.min(1, at.x / shown.width)));
  return true;
}, (at) => pointed.choose(at.x, at.y));

const keys = {
  'f': () => view.fit(), '+': () => view.zoomBy(1.5), '=': () => view.zoomBy(1.5), '-': () => view.zoomBy(1 / 1.5),
  'ArrowLeft': () => view.moveBy(40, 0), 'ArrowRight': () => view.moveBy(-40, 0),
  'ArrowUp': () => view.moveBy(0, 40), 'ArrowDown': () => view.moveBy(0, -40),
  't': () => tones.next_of($('tone')), 'l': () => tones.luminance(), 'c': () => tones.next_of($('compare')), 'k': () => variants.keep(),
  '[': () => tones.brighter(-.25), ']': () => tones.brighter(.25),
};
// Whoever types, or has chosen a row or a number, means that.
const takes_letters = 'input, select, textarea, table, pre, #day, #plan, [contenteditable]';
document.addEventListener('keydown', (e) => {
  const z = e.key.toLowerCase() === 'z' && (e.ctrlKey || e.metaKey);
  if (z && !e.target.matches('input:not([type=range])'))
    return e.preventDefault(), void take_back(e.shiftKey ? 'redo' : 'undo');
  if (e.target.closest(takes_letters) || e.ctrlKey || e.metaKey || e.altKey) return;
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
wire_saving(view, lines, () => shown?.view ?? '');

listen();
