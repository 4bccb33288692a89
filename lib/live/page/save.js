// Files for the user: the page's own texts and pictures, and what vcview holds.

import { ask } from '/net.js';

const $ = (id) => document.getElementById(id);

function offer(name, data, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([data], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// The plots below one another, with rules of their own: the page's colours are of its theme.
function plots_svg() {
  const rules = 'text{font:11px sans-serif;fill:#444}.axis{stroke:#999;fill:none}.curve{stroke:#0b5cad;fill:none}.ghost{stroke:#888;fill:none}' +
    '.interval{fill:#0b5cad33}.class{stroke:#777;stroke-dasharray:3 3}.stop{stroke:#0a7a3c}';
  const all = [...document.querySelectorAll('#plots figure')].map((f, k) =>
    `<g transform="translate(0,${140 * k})"><text x="4" y="12">${f.querySelector('figcaption').textContent}</text>` +
    `<g transform="translate(0,16)">${f.querySelector('svg').innerHTML}</g></g>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="420" height="${140 * all.length}"><style>${rules}</style>${all.join('')}</svg>`;
}

async function offer_picture(as) {
  const answer = await ask(`/save?as=${as}`);
  if (answer.ok) offer(`luxpipe.${as}`, await answer.blob(), 'application/octet-stream');
}

export function wire_saving(view, lines) {
  for (const as of ['hdr', 'exr']) $(`save-${as}`).addEventListener('click', () => offer_picture(as));
  $('save-png').addEventListener('click', () => view.sheet().toBlob((blob) => offer('luxpipe.png', blob, 'image/png')));
  $('save-svg').addEventListener('click', () => offer('luxpipe.svg', plots_svg(), 'image/svg+xml'));
  $('save-csv').addEventListener('click', () => offer('luxpipe.csv', lines.csv(), 'text/csv'));
}
