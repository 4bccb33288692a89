// The library of materials (library/*.rad): paints, glazings, fabrics and slats by name.
import { ask } from '/net.js';
import { reals_of, things_in } from '/model_text.js';

export class Library {
  all = [];

  async read() {
    const answer = await ask('/library.rad'), text = answer.ok ? await answer.text() : '';
    this.all = things_in(text).map((thing) => ({
      name: thing.name, called: thing.name.replace(/_/g, ' '), type: thing.type, reals: reals_of(text, thing),
      words: thing.reals.map(([from, to]) => text.slice(from, to)).join(' ')
    }));
  }

  // A material as lines of a scene, under another name.
  lines(library_name, name) {
    const { type, words, reals } = this.all.find((m) => m.name === library_name);
    return `void ${type} ${name}\n0\n0\n${reals.length} ${words}`;
  }

  // Those that a material of a text may become, and the one that it is like: of several the one whose kind it is called
  // by (blind_1_slat).
  kinds_of(text, thing) {
    const reals = reals_of(text, thing);
    const all = this.all.filter((m) => m.type === thing.type && m.reals.length === reals.length);
    const like = all.filter((m) => m.reals.every((v, k) => v === reals[k]));
    return [all, like.find((m) => thing.name.includes(m.name.split('_')[0])) ?? like[0]];
  }
}

// The text with the numbers of a material of the library; its name stays.
export const with_material = (text, { reals }, material) =>
  text.slice(0, reals[0][0]) + material.words + text.slice(reals[reals.length - 1][1]);
