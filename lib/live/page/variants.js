// Variants: the design under a name, with its picture and numbers, all held by vcview.  One of them is the base, with which
// each edit is compared; the picture of any can stand beside the one at hand.
import { ask, post, unpack } from '/net.js';
import { fill, keep, row_of } from '/table.js';

const $ = (id) => document.getElementById(id);
const act = (what, name = '', to = '') => post(`/variant?${new URLSearchParams({ do: what, name, to })}`);

export class Variants {
  // say(text); other(picture): the one to compare with, or null; numbers(edit): cells of its row.
  constructor(say, other, numbers) {
    Object.assign(this, { say, other, numbers, all: [], known: '' });
    $('keep').addEventListener('click', () => this.keep());
    $('base-before').addEventListener('change', async () => this.say(await act('base')));
    $('with').addEventListener('change', () => { this.picked = $('with').value; this.fetch(); });
  }

  async keep() { this.say(await act('keep')); }

  // all: [{ name, edit, shown, numbers }]; base: a name; before: the edit before this one, whose picture has no name; -1: none.
  take(all, base, before) {
    [this.all, this.base] = [all, base];
    $('base-before').checked = !base;
    this.others = [...(before < 0 ? [] : [{ name: '', edit: before }]), ...all];
    const picked = this.others.some((v) => v.name === this.picked) ? this.picked : base;
    keep($('with'), this.others, (v) => v.name, ({ name }) => new Option(name || 'the edit before', name));
    $('with').value = picked;
    $('variants-panel').hidden = !all.length;
    $('compare').disabled = !this.others.length;
    $('with').parentElement.hidden = this.others.length < 2;
    const as_text = JSON.stringify([all.map((v) => [v.name, v.edit, v.shown]), base]);
    if (as_text !== this.filled) this.fill();
    this.filled = as_text;
    this.fetch();
  }

  // Its picture, anew where that is another one.
  async fetch() {
    const chosen = this.others.find((v) => v.name === $('with').value), key = chosen ? `${chosen.name} ${chosen.edit} ${chosen.shown}` : '';
    if (key === this.known) return;
    this.known = key;
    const answer = chosen && await ask(`/variant?name=${encodeURIComponent(chosen.name)}`);
    if (this.known === key) this.other(answer?.ok ? (await unpack(answer)).rgb : null, chosen?.name);
  }

  fill() {
    keep($('variants').tBodies[0], this.all, (v) => v.name, ({ name }) => {
      const row = row_of(4);
      const control = (tag, facts, label, event, does) => {
        const e = Object.assign(document.createElement(tag), facts);
        e.setAttribute('aria-label', label);
        e.addEventListener(event, async () => this.say(await does(e)));
        return e;
      };
      row.cells[0].append(control('input', { type: 'radio', name: 'base' }, `compare with ${name}`, 'change', () => act('base', name)));
      row.cells[1].append(control('input', { className: 'name', defaultValue: name }, 'name', 'change', async (e) => {
        const wrong = await act('call', name, e.value.trim());
        if (wrong) e.value = name;
        return wrong;
      }));
      row.cells[3].append(control('button', { type: 'button' }, `show ${name}`, 'click', () => act('show', name)),
        control('button', { type: 'button', textContent: '×' }, `delete ${name}`, 'click', () => act('drop', name)));
      return row;
    }, (row, v) => {
      const [radio, name, show] = row.querySelectorAll('input, button');
      radio.checked = v.name === this.base;
      fill(name, v.name);
      Object.assign(show, { textContent: v.shown ? 'shown' : 'Show', disabled: v.shown });
    });
    this.show_numbers();
  }

  show_numbers() {
    [...$('variants').tBodies[0].rows].forEach((row, k) => {
      const v = this.all[k];
      const known = v.numbers.find((n) => n.startsWith('DGP')) ?? v.numbers[0];
      row.cells[2].textContent = this.numbers(v.edit) || known || '–';
    });
  }
}
