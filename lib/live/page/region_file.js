// The text of a region file (vcregion(5)) and changes of it.  A change is a function of the text, so that it can be
// made again in a text that somebody else has changed meanwhile; it gives null where that has changed the same region.

const code_of = (line) => {
  const at = line.search(/#(?=(?:[^"]*"[^"]*")*[^"]*$)/);
  return at < 0 ? line : line.slice(0, at);
};

// [{ name, definition, from, to, lead, comments }]: from..to are its lines, lead the blanks behind its name.
export function regions_of(text) {
  const all = [];
  text.split('\n').forEach((line, k) => {
    const code = code_of(line).trimEnd(), comment = line.slice(code_of(line).length).trim(), last = all[all.length - 1];
    if (!code.trim()) return;
    if (/^[ \t]/.test(line)) {
      if (!last) return;
      last.definition += ' ' + code.trim();
      last.to = k;
      if (comment) last.comments.push(comment);
      return;
    }
    const [, name, lead, definition] = /^(\S+)(\s*(?:=\s*)?)(.*)$/.exec(code);
    all.push(
      { name, definition: definition.trim(), from: k, to: k, lead: lead || ' ', comments: comment ? [comment] : [] });
  });
  return all;
}

const word = (name) => new RegExp(`(^|[\\s()&!])${name.replace(/[-]/g, '\\-')}(?=$|[\\s()&!])`, 'g');

// Lines of nothing but a comment between those of a region.
const own_comments = (lines, region) =>
  lines.slice(region.from, region.to + 1).filter((l) => l.trim() && !code_of(l).trim());

// Another name, another definition, or both; a new name also in what other regions are made of.
// seen: the view in which it was drawn, for shapes of the picture; absent: as it was.
export const replace = (region, name, definition, mine = false, seen = undefined) => (text) => {
  const now = regions_of(text).find((r) => r.name === region.name);
  if (!now || (!mine && now.definition !== region.definition)) return null;
  const lines = text.split('\n');
  const lead = now.lead.includes('=') || now.lead.length < 2 ?
    now.lead :
    ' '.repeat(Math.max(1, now.lead.length + now.name.length - name.length));
  lines.splice(
    now.from, now.to - now.from + 1, ...own_comments(lines, now),
    [name + lead + definition, ...with_view(now.comments, seen)].join('  '));
  if (name === now.name) return lines.join('\n');
  return lines
    .map((line) => {
      const code = code_of(line), own = /^\S+/.exec(code)?.[0] ?? '';
      if (own === name) return line;
      return own + code.slice(own.length).replace(word(now.name), `$1${name}`) + line.slice(code.length);
    })
    .join('\n');
};

// From where a shape of the picture was drawn stands behind it: the eye and, but for directions, which way it looked.
const of_view = '# drawn from ', numbers = (v) => v.map((x) => Number(x.toFixed(4)) + 0).join(' ');
export const seen_from = ({frame}, eye) => frame === 'direction' ? numbers(eye.vp) :
  frame === 'fraction' || frame === 'pixel'                      ? `${numbers(eye.vp)} towards ${numbers(eye.vd)}` :
                                                                   '';
// Is it the same part of the picture, but no more of the room?  all: the regions, of which it may be another one's
// name.
export function is_elsewhere(region, all, eye) {
  const other = all.find((r) => r !== region && r.name === region.definition);
  if (other) return is_elsewhere(other, all.filter((r) => r !== region), eye);
  const [vp, vd] = (region.comments.find((c) => c.startsWith(of_view))?.slice(of_view.length) ?? '').split(' towards ');
  return Boolean(vp) && (vp !== numbers(eye.vp) || (vd !== undefined && vd !== numbers(eye.vd)));
}
const with_view = (comments, seen) => seen === undefined ?
  comments :
  [...comments.filter((c) => !c.startsWith(of_view)), ...(seen ? [of_view + seen] : [])];

export const add = (name, definition, seen) => (text) => {
  const names = regions_of(text).map((r) => r.name);
  if (names.includes(name)) return null;
  return (text && !text.endsWith('\n') ? text + '\n' : text) +
    `${[`${name}  ${definition}`, ...with_view([], seen)].join('  ')}\n`;
};

export const set_region = (name, definition, seen) => (text) => {
  const now = regions_of(text).find((r) => r.name === name);
  return now ? replace(now, name, definition, false, seen)(text) : add(name, definition, seen)(text);
};

export const remove = (region, mine = false) => (text) => {
  const now = regions_of(text).find((r) => r.name === region.name);
  if (!now) return text;
  if (!mine && now.definition !== region.definition) return null;
  const lines = text.split('\n');
  lines.splice(now.from, now.to - now.from + 1, ...own_comments(lines, now));
  return lines.join('\n');
};

export function free_name(text, start = 'region') {
  const names = new Set(regions_of(text).map((r) => r.name));
  for (let k = 1;; k++)
    if (!names.has(`${start}${k}`)) return `${start}${k}`;
}
