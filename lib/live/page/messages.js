// Messages: one line each in the head until it is dismissed or its cause is gone; all can be read below.
import { post } from '/net.js';
import { keep } from '/table.js';

const $ = (id) => document.getElementById(id);
const own = [];  // of this window: [text]
let theirs = [], all = [];

function show() {
  const news = [...theirs.slice(-3).map(([number, text]) => ({ number, text })), ...own.map((text) => ({ text }))];
  keep($('messages'), news, ({ number, text }) => `${number} ${text}`, ({ number, text }) => {
    const line = document.createElement('p'), away = document.createElement('button');
    Object.assign(away, { type: 'button', textContent: '×' });
    away.setAttribute('aria-label', `dismiss: ${text}`);
    away.addEventListener('click', () => {
      if (number !== undefined) return void post(`/dismiss?number=${number}`);
      own.splice(own.indexOf(text), 1);
      show();
    });
    line.append(text, ' ', away);
    return line;
  });
  $('messages').hidden = !news.length;
  const lines = [...all, ...own];
  keep($('all-messages'), lines.map((text, k) => ({ text, k })), ({ text, k }) => `${k} ${text}`,
    ({ text }) => Object.assign(document.createElement('p'), { textContent: text }));
  $('messages-panel').hidden = !lines.length;
}

// As vcview has them.  notices: [number, text] of those that stand.
export function show_messages({ messages, notices }) {
  [all, theirs] = [messages, notices];
  show();
}

// What this window has to say, until it is dismissed.
export function tell(text) {
  if (own.includes(text)) return;
  own.push(text);
  show();
}
