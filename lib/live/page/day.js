// Glare over the hours of the date, as vcview has it rendered in idle time: a column an hour, with its class as colour
// and sign; a dashed one where the interval holds two classes.  A click goes to that hour.
import { limits, verdict } from '/judge.js';
import { keep, one_stop } from '/table.js';

const $ = (id) => document.getElementById(id);
const height_of = (dgp) => Math.max(.05, Math.min(1, (dgp - .15) / .4));

export class Day {
  constructor(sliders) { Object.assign(this, { sliders, known: '' }); }

  // { file, hours: [[hour, DGPf, low, high]], ended }, or null.
  take(day) {
    const now = day && this.sliders.hour(day.file), key = JSON.stringify([day, now]);
    if (key === this.known) return;
    this.known = key;
    this.file = day?.file;
    keep(
      $('day'), day?.hours ?? [], ([hour]) => hour,
      ([hour]) => {
        const column = Object.assign(document.createElement('button'), { type: 'button' });
        column.dataset.hour = hour;
        column.append(' ', document.createElement('i'), document.createElement('span'), String(hour));
        column.addEventListener('click', () => this.sliders.go_to(this.file, hour));
        return column;
      },
      (column, [hour, value, low, high]) => {
        const { text, kind, number } = verdict('DGPf', { DGPf: value, 'DGPf.lo': low, 'DGPf.hi': high });
        column.title = `${hour}:00 ${text.replace(/^[^a-z]+/, '')}, ${number}`;
        column.className = `${kind} ${text.includes(' to ') || kind === 'looking' ? 'open' : ''}`;
        column.style.setProperty('--high', height_of(value));
        column.setAttribute('aria-label', column.title);
        column.setAttribute('aria-current', String(now === hour));
        column.firstChild.data = kind === 'looking' ? '?' : text[0] ?? '';
        column.querySelector('i').textContent = value.toFixed(2).replace(/^0/, '');
      });
    one_stop($('day'), $('day').children);
    $('day').style.setProperty('--limit', height_of(limits[0]));
    $('day-say').className = `note ${day?.ended ? 'ended' : ''}`;
    $('day-say').textContent = !day ?
      '' :
      day.hours.length ?
      `DGPf by the hour; at the line (${limits[0].toFixed(2).replace(/^0/, '')}) glare is perceptible` :
      day.ended ?
      'no hours of the day: at noon no light reaches the eye' :
      'the hours of the day come when the picture has 32 frames';
  }
}
