// Which sky the line of a text makes, another one in its place, and the hours of a weather file.
import { date_of, sky_line } from '/model_text.js';

const one_line = new RegExp(sky_line.source);

// gensky's skies, and what a person calls them.
export const skies = {
  '+s': 'clear, with sun', '-s': 'clear, without sun', '-c': 'overcast',
  '+i': 'intermediate, with sun', '-i': 'intermediate, without sun',
};
export const of_weather = 'weather';

// Line k of those that make a sky, by a function of its words.
function with_line(text, k, change) {
  let at = 0;
  return text.replace(/^!.*$/gm, (line) => {
    return one_line.test(line) && at++ === k ? change(line) : line;
  });
}

// Of the first sky of a text; null: another one.
export function kind_of(text) {
  let kind = null;
  with_line(text, 0, (line) => {
    const said = (/ ([+-][sicu])(?= |$)/.exec(line)?.[1] ?? '+s').replace('+c', '-c');
    kind = /\bgendaylit\s/.test(line) ? / -W /.test(line) ? of_weather : null : said in skies ? said : null;
    return line;
  });
  return kind;
}

// Without what only the other program, or another sky, has.
const bare = (line) => line.replace(/ [+-][sicu](?= |$)/g, '').replace(/ -[BbRrt] \S+/g, '')
  .replace(/ -[WGPL] \S+ \S+/g, '').replace(/ -[EO] \S+/g, '');
const after_time = (line, words) => {
  const [all] = one_line.exec(line);
  return `${all} ${words}${line.slice(all.length)}`;
};

export const with_sky_kind = (text, kind) => with_line(text, 0, (line) =>
  after_time(bare(line).replace(/\bgendaylit\b/, 'gensky'), kind));

// The hour of a weather file that is nearest to the time, and its place.  Moved from a time: not that hour again.
export function with_weather(text, weather, day, hour, from) {
  const at = hour_of(weather, day, hour, from), [month, date] = date_of(at.day);
  return with_line(text, 0, (line) => {
    const time = bare(line).replace(/\b(gensky|gendaylit)([ \t]+\S+){3}/, `gendaylit ${month} ${date} ${at.hour}`);
    const place = [['-a', weather.latitude], ['-o', weather.longitude], ['-m', weather.meridian]];
    const rest = place.reduce((all, [name]) => all.replace(new RegExp(` ${name} \\S+`), ''), time);
    return after_time(rest, `-W ${at.direct} ${at.diffuse} ${place.map(([name, v]) => `${name} ${v}`).join(' ')}`);
  });
}

const day_of = (month, date) => {
  for (let day = 1; day <= 365; day++) if (String(date_of(day)) === `${month},${date}`) return day;
  return 59;  // 29 February
};
const hour_of = ({ hours }, day, hour, from) => {
  const far = (h) => Math.abs(h.day - day) * 24 + Math.abs(h.hour - hour);
  const of = (all) => all.reduce((best, h) => far(h) < far(best) ? h : best), at = of(hours);
  if (at.day !== from?.day || at.hour !== from.hour) return at;
  const beyond = hours.filter((h) => (h.day - at.day) * (day - at.day) > 0 || (h.hour - at.hour) * (hour - at.hour) > 0);
  return beyond.length ? of(beyond) : at;
};

// EPW or WEA: { place, latitude, longitude (west), meridian, hours: [{ day, hour (its middle), direct, diffuse }] };
// null: it is neither.
export function weather_of(text) {
  const lines = text.split(/\r?\n/), number = (name) => Number(new RegExp(`^${name} +(\\S+)`, 'm').exec(text)?.[1]);
  let weather, hours;
  if (/^LOCATION,/.test(text)) {
    const [, place, , , , , latitude, longitude, zone] = lines[0].split(',');
    weather = { place, latitude: Number(latitude), longitude: -Number(longitude), meridian: -15 * Number(zone) };
    hours = lines.slice(8).map((l) => l.split(',')).filter((f) => f.length > 15)
      .map((f) => [f[1], f[2], f[3] - .5, f[14], f[15]]);
  } else {
    weather = {
      place: /^place +(.*)/m.exec(text)?.[1].replace(/_/g, ' '), latitude: number('latitude'),
      longitude: number('longitude'), meridian: number('time_zone')
    };
    hours = lines.slice(6).map((l) => l.trim().split(/\s+/)).filter((f) => f.length >= 5);
  }
  weather.hours = hours.map((f) => f.map(Number)).filter((f) => f.every(Number.isFinite))
    .map(([month, date, hour, direct, diffuse]) => ({ day: day_of(month, date), hour, direct, diffuse }));
  const { place, latitude, longitude, meridian } = weather;
  return place && weather.hours.length && [latitude, longitude, meridian].every(Number.isFinite) ? weather : null;
}
