// The model: sliders for the day and hour of skies and for any number in the files of -edit.  Their values go to vcview as
// a text that stands for the file; vcview holds it for all windows, each of which says what version it has changed.  The
// file itself is written only by Save.
import { date_of, numbers_in, range_of, skies_in, things_in, with_number, with_sky } from '/model_text.js';
import { tell } from '/messages.js';
import { ask, command, tag_of, text_of } from '/net.js';
import { fill, keep, one_stop } from '/table.js';
import { TextFile } from '/text_file.js';

const $ = (id) => document.getElementById(id);
const clock = (h) => `${Math.floor(h)}:${String(Math.round(h % 1 * 60)).padStart(2, '0')}`;
const date = (day) => { const [m, d] = date_of(day); return `${d} ${new Date(2001, m - 1, 1).toLocaleString('en', { month: 'short' })}`; };

// Words for what differs in two texts of a file: the day and hour of a sky, or a number before and after, and of what.
function difference_of(before, after, name) {
  const sky = skies_in(after).find((s, k) => { const b = skies_in(before)[k]; return b && (b.day !== s.day || b.hour !== s.hour); });
  if (sky) return `${date(sky.day)} ${clock(sky.hour)}`;
  const old = numbers_in(before), all = numbers_in(after), changed = all.findIndex((n, k) => old[k]?.value !== n.value);
  if (changed < 0) return name;
  const thing = things_in(after).find((t) => !t.command && t.start <= all[changed].start && all[changed].end <= t.end);
  return `${thing?.name ?? name}: ${old[changed]?.value ?? ''} → ${all[changed].value}`;
}

export class Sliders {
  constructor() {
    this.files = [];  // { file: as on the disk, text: as it is shown, version: of that }
    this.chosen = null;  // the index of a number
    this.place_sky = with_sky;  // (text, k, day, hour, from): with its sky k there; from: { day, hour } before
    $('model-file').addEventListener('change', () => { this.chosen = null; this.show(); });
    $('model-revert').addEventListener('click', () => this.set(this.now.file.text));
    $('model-save').addEventListener('click', () => this.save());
  }

  get now() { return this.files[$('model-file').selectedIndex]; }

  async use(n, facts) {
    const one = { file: new TextFile(n, facts), text: '', version: 0, going: false, small: false };
    this.files.push(one);
    $('model-file').append(new Option(facts.name));
    $('model-panel').hidden = false;
    $('model-file').parentElement.hidden = this.files.length < 2;
    await this.fetch(one);
    this.show();
  }

  // The file as it is on the disk, and the text that stands for it.
  async fetch(one) {
    try {
      const answer = await ask(`/overlay?n=${one.file.n}`);
      await one.file.read();  // second, so that the version is never newer than the text
      const stands = answer.status === 200;
      one.text = stands ? await text_of(answer, one.file.name) : one.file.text;
      one.version = Number(tag_of(answer));
      if (!stands || one.base === undefined) one.base = one.file.text;
    } catch (e) { return this.say(e.message); }
    one.sent = one.rested = one.text;
  }

  // The state of the design: [version, is there a text that stands for the file] of each file.
  async take(texts) {
    let shown = false;
    for (const one of this.files) {
      const [version, stands] = texts[one.file.n], [text, on_disk] = [one.text, one.file.text];
      if (version <= one.version || one.sending || one.going) continue;
      await this.fetch(one);
      if (!stands && text !== on_disk && text !== one.text)
        this.say(`${one.file.name} was changed on the disk and is shown as there; Undo brings back what was changed here.`);
      shown ||= one.text !== text;
    }
    this.texts = texts;
    if (shown && this.files.length) this.show();
    else if (this.files.length) this.mark();
  }

  say(text) { $('model-say').textContent = text; }

  // ---- changes

  // going: a slider is still moved; said: words for the edit.
  set(text, going = false, said = '') {
    const one = this.now;
    if (text === one.text) return;
    this.say('');
    one.said = said;
    one.going = going;
    one.text = text;
    this.send(one);
    if (!going) this.show();
    else this.mark();
  }

  stop() {
    const one = this.now;
    one.going = false;
    if (one.small) this.send(one);
    this.show();
  }

  // Sends the newest text when the one before it has gone: small pictures while a slider moves, so that all of its way is one
  // edit, and the full one at rest.
  async send(one) {
    if (one.sending) { one.again = true; return; }
    one.sending = true;
    one.again = false;
    let wrong = '';
    if (one.going && !one.small) {
      wrong = await command('preview');
      one.small = !wrong;
    }
    if (!wrong && one.text !== one.sent) wrong = await this.send_text(one);
    if (!one.going && one.small && one.text === one.sent) {
      wrong ||= await command('go');
      one.small = Boolean(wrong);
      one.rested = one.sent;
    }
    if (wrong || one.wrong) this.say(wrong);  // else what Save has said meanwhile stays
    one.wrong = wrong;
    setTimeout(() => {
      one.sending = false;
      if (one.again || one.small > one.going) this.send(one);
      else if (this.texts) this.take(this.texts);
    }, wrong ? 1000 : 100);
  }

  async send_text(one) {
    const text = one.text, said = one.said || difference_of(one.rested, text, one.file.name);
    const question = new URLSearchParams({ n: one.file.n, version: one.version, said, going: one.going ? '1' : '' });
    try {
      const answer = await ask(`/overlay?${question}`, { method: 'POST', body: text });
      if (answer.status === 412) {
        const { text: newest, sent, rested } = one;
        await this.fetch(one);
        if (one.text === sent) {  // the same text under another version: it was saved
          Object.assign(one, { text: newest, rested, said });
          return this.send_text(one);
        }
        one.going = false;
        this.show();
        tell(`${one.file.name} was changed in another window meanwhile and is shown as there; not taken: ${said}`);
        return '';
      }
      if (!answer.ok) return (await answer.text()).trim();
      one.version = Number(tag_of(answer));
    } catch (e) { return e.message; }
    one.sent = text;
    if (!one.going) one.rested = text;
    return '';
  }

  async save() {
    const one = this.now;
    // Only over what was shown as the file's, or was written by another save of ours.
    const is_ours = (text) => text === one.base || text === one.written;
    const said = await one.file.save((text) => is_ours(text) ? one.written = one.text : null);
    this.say(said === 'conflict' ? `${one.file.name} was changed by another program meanwhile and is as that program left it.`
      : said || `${one.file.name} is saved`);
    this.mark();
  }

  // ---- what is shown

  mark() {
    const one = this.now, differs = one.text !== one.file.text;
    $('model-save').disabled = $('model-revert').disabled = !differs;
  }

  show() {
    const skies = this.files.flatMap((one) => skies_in(one.text).flatMap((sky, k) => ['day', 'hour'].map((what) => ({ one, sky, k, what }))));
    keep($('skies'), skies, ({ one, sky, k, what }) => [one.file.n, k, sky.program, what], ({ one, sky, k, what }) => {
      const change = (v, going) => {
        const now = skies_in(one.text)[k], { day, hour } = { ...now, [what]: v };
        if (!one.going) one.from = now;
        this.choose(one);
        this.set(this.place_sky(one.text, k, day, hour, one.from), going);
      };
      return what === 'day' ? this.slider(`${sky.program}: day`, 1, 365, 1, sky.day, date, change) : this.slider('hour', 0, 24, .25, sky.hour, clock, change);
    }, (label, { sky, what }) => label.show(sky[what]));
    $('sky-panel').hidden = !$('skies').children.length;
    this.show_text();
    this.show_number();
    this.mark();
  }

  // Words for the first sky of all files.
  when() {
    const sky = this.files.flatMap((one) => skies_in(one.text))[0];
    return sky ? `${date(sky.day)} ${clock(sky.hour)}` : '';
  }

  // The hour of a file's first sky, and another one in its place.
  hour(n) { return skies_in(this.files.find((one) => one.file.n === n)?.text ?? '')[0]?.hour; }
  go_to(n, hour) {
    const one = this.files.find((f) => f.file.n === n);
    this.choose(one);
    this.set(this.place_sky(one.text, 0, skies_in(one.text)[0].day, hour));
  }

  // The file that Undo, Revert and Save are about.
  choose(one) {
    if (one === this.now) return;
    $('model-file').selectedIndex = this.files.indexOf(one);
    this.chosen = null;
    this.show_text();
    this.show_number();
  }

  slider(title, least, largest, step, value, words, set) {
    const label = document.createElement('label'), input = document.createElement('input'), output = document.createElement('output');
    Object.assign(input, { type: 'range', min: least, max: largest, step });
    label.show = (v) => { input.value = v; output.value = words(v); };
    label.show(value);
    input.addEventListener('input', () => { output.value = words(Number(input.value)); set(Number(input.value), true); });
    input.addEventListener('change', () => this.stop());
    label.append(title, input, output);
    return label;
  }

  // The text, its numbers as buttons.
  show_text() {
    const { text } = this.now, parts = [];
    let at = 0;
    numbers_in(text).forEach(({ start, end }, k) => {
      const button = document.createElement('button');
      Object.assign(button, { type: 'button', textContent: text.slice(start, end) });
      button.setAttribute('aria-pressed', String(k === this.chosen));
      button.addEventListener('click', () => { this.chosen = k; this.range = null; this.show(); $('model-text').querySelectorAll('button')[k].focus(); });
      parts.push(text.slice(at, start), button);
      at = end;
    });
    const top = $('model-text').scrollTop;
    $('model-text').replaceChildren(...parts, text.slice(at));
    one_stop($('model-text'), $('model-text').querySelectorAll('button'));
    $('model-text').scrollTop = top;
  }

  show_number() {
    const number = numbers_in(this.now.text)[this.chosen];
    if (!number) return $('model-number').replaceChildren();
    this.range ??= number.whole ? [1, Math.max(8, 2 * number.value)] : range_of(number.value);
    keep($('model-number'), [number.value], () => [this.now.file.n, this.chosen, this.range], () => this.number_field(number), (span, value) => {
      span.firstChild.show(value);
      fill(span.lastChild, value);
    });
  }

  number_field(number) {
    const [least, largest] = this.range, step = number.whole ? 1 : (largest - least) / 200, set = (v, going) => this.set(with_number(this.now.text, numbers_in(this.now.text)[this.chosen], v), going);
    const field = document.createElement('input');
    Object.assign(field, { type: 'number', step: 'any', defaultValue: number.value });
    field.setAttribute('aria-label', 'value of the chosen number');
    field.addEventListener('change', () => { this.range = null; set(Number(field.value)); });
    const span = document.createElement('span');
    span.append(this.slider('number', least, largest, step, number.value, (v) => String(Number(v.toPrecision(4))),
      (v, going) => { field.defaultValue = field.value = v; set(v, going); }), field);
    return span;
  }
}
