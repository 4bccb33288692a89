// A text that vcview may write for us: read, and changed by functions of its text, one after another, so that no answer
// is older than what is known.
import { ask, tag_of, text_of } from '/net.js';

export class TextFile {
  constructor(n, facts) {
    this.n = n;
    Object.assign(this, facts);
    this.text = '';
    this.tag = 'none';
    this.turn = Promise.resolve();
  }

  in_turn(work) { return (this.turn = this.turn.then(work, work)); }
  read() { return this.in_turn(() => this.fetch()); }
  // change: text -> text, or null where it does not fit.  '' when done, 'conflict', or what is wrong.
  save(change) { return this.in_turn(() => this.write(change)); }

  async fetch() {
    const answer = await ask(`/file?n=${this.n}`);
    if (!answer.ok) throw new Error((await answer.text()).trim());
    this.text = await text_of(answer, this.name);
    this.tag = tag_of(answer);
  }

  async write(change) {
    for (let trial = 0; trial < 3; trial++) {
      const next = change(this.text);
      if (next === null) return 'conflict';
      if (next === this.text) return '';
      const answer =
        await ask(`/file?n=${this.n}`, { method: 'PUT', body: next, headers: { 'If-Match': `"${this.tag}"` } });
      if (answer.status === 412) {  // somebody else was faster: the same change in the new text
        await this.fetch();
        continue;
      }
      if (!answer.ok) return (await answer.text()).trim();
      this.text = next;
      this.tag = tag_of(answer);
      return '';
    }
    return 'conflict';
  }
}
