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
export const replace = (region, name, definition, mine = false) => (text) => {
  const now = regions_of(text).find((r) => r.name === region.name);
  if (!now || (!mine && now.definition !== region.definition)) return null;
  const lines = text.split('\n');
  const lead = now.lead.includes('=') || now.lead.length < 2 ? now.lead
    : ' '.repeat(Math.max(1, now.lead.length + now.name.length - name.length));
  lines.splice(now.from, now.to - now.from + 1, ...own_comments(lines, now),
    [name + lead + definition, ...now.comments].join('  '));
  if (name === now.name) return lines.join('\n');
  return lines.map((line) => {
    const code = code_of(line), own = /^\S+/.exec(code)?.[0] ?? '';
    if (own === name) return line;
    return own + code.slice(own.length).replace(word(now.name), `$1${name}`) + line.slice(code.length);
  }).join('\n');
};

export const add = (name, definition) => (text) => {
  const names = regions_of(text).map((r) => r.name);
  if (names.includes(name)) return null;
  return (text && !text.endsWith('\n') ? text + '\n' : text) + `${name}  ${definition}\n`;
};

export const set_region = (name, definition) => (text) => {
  const now = regions_of(text).find((r) => r.name === name);
  return now ? replace(now, name, definition)(text) : add(name, definition)(text);
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
  for (let k = 1; ; k++) if (!names.has(`${start}${k}`)) return `${start}${k}`;
}
