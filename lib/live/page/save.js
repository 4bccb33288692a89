// Files for the user: the page's own texts and pictures, and what vcview holds.
import { ask } from '/net.js';
import { element } from '/plot.js';

const $ = (id) => document.getElementById(id);

export function offer(name, data, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([data], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// The plots below one another, with rules of their own: the page's colours are of its theme.
export function plots_svg() {
  const rules =
    'text{font:11px sans-serif;fill:#444}.axis{stroke:#999;fill:none}.curve{stroke:#0b5cad;fill:none}' +
    '.ghost{stroke:#888;fill:none}' +
    '.interval{fill:#0b5cad33}.class{stroke:#777;stroke-dasharray:3 3}.stop{stroke:#0a7a3c}';
  const figures = [...document.querySelectorAll('#plots figure')];
  const sheet = element('svg', { width: 420, height: 152 * figures.length });
  figures.forEach((f, k) => {
    const drawn = f.querySelector('svg').cloneNode(true);
    const facts = { y: 152 * k + 16, width: 420, height: 132 };
    Object.entries(facts).forEach(([name, value]) => drawn.setAttribute(name, value));
    sheet.append(element('text', { x: 4, y: 152 * k + 12 }, f.querySelector('figcaption').textContent), drawn);
  });
  return new XMLSerializer().serializeToString(sheet).replace('>', `><style>${rules}</style>`);
}

// The answer, or what is wrong, where the command is.
async function offer_answer(path, name, type = 'application/octet-stream') {
  let wrong = 'the connection to vcview has ended', answer;
  try {
    do answer = await ask(path); while (answer.status === 204);  // not there yet
    if (answer.ok) return offer(name, await answer.blob(), type);
    wrong = (await answer.text()).trim();
  } catch { /* told below */ }
  $('status').textContent = `${name} is not saved: ${wrong}`;
}

// view(): options of the present view.
export function wire_saving(view, lines, options) {
  $('save-vf').addEventListener('click', () => offer('view.vf', `rvu ${options()}\n`, 'text/plain'));
  for (const as of ['hdr', 'exr'])
    $(`save-${as}`).addEventListener('click', () => offer_answer(`/save?as=${as}`, `luxpipe.${as}`));
  $('report').addEventListener(
    'click', () => offer_answer(`/report?picture=${document.body.dataset.picture}`, 'report.html', 'text/html'));
  $('save-png').addEventListener('click', () => view.sheet().toBlob((blob) => offer('luxpipe.png', blob, 'image/png')));
  $('save-svg').addEventListener('click', () => offer('luxpipe.svg', plots_svg(), 'image/svg+xml'));
  $('save-csv').addEventListener('click', () => offer('luxpipe.csv', lines.csv(), 'text/csv'));
}
