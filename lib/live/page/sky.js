// The first sky of all files: clear, overcast, or as an hour of a weather file has it, whose place and time it takes.
// The file is read by this window alone; what it says of the hour stands in the text.
import { skies_in, with_sky } from '/model_text.js';
import { kind_of, of_weather, skies, weather_of, with_sky_kind, with_weather } from '/sky_text.js';

const a_file = 'file';
const $ = (id) => document.getElementById(id);

export class Sky {
  constructor(sliders) {
    this.sliders = sliders;
    sliders.place_sky = (text, k, day, hour, from) => this.weather && !k && kind_of(text) === of_weather ?
      with_weather(text, this.weather, day, hour, from) :
      with_sky(text, k, day, hour);
    $('sky-kind').append(...Object.entries(skies).map(([kind, words]) => new Option(words, kind)));
    $('sky-kind').addEventListener('change', () => {
      if ($('sky-kind').value !== a_file) return this.choose($('sky-kind').value);
      this.take();
      $('weather').click();
    });
    $('weather').addEventListener('change', () => this.read());
  }

  // The file of the first sky.
  get one() { return this.sliders.files.find((f) => skies_in(f.text).length); }

  choose(kind) {
    const { one } = this, [{ day, hour }] = skies_in(one.text), is_hour = kind === of_weather;
    $('sky-kind').setCustomValidity('');
    this.sliders.choose(one);
    this.sliders.set(is_hour ? with_weather(one.text, this.weather, day, hour) : with_sky_kind(one.text, kind), false,
      `sky: ${is_hour ? `an hour of ${this.weather.place}` : skies[kind]}`);
  }

  async read() {
    const [file] = $('weather').files, weather = file && weather_of(await file.text());
    $('weather').value = '';
    $('sky-kind').setCustomValidity(file && !weather ? 'neither an EPW nor a WEA file' : '');
    $('sky-kind').reportValidity();
    if (!weather || !this.one) return;
    this.weather = weather;
    this.choose(of_weather);
  }

  take() {
    const { one } = this, kind = one && kind_of(one.text), words = this.weather?.place ?? 'a weather file';
    $('sky-kind').parentElement.parentElement.hidden = !one;
    if (!one) return;
    const keeps = [...$('sky-kind').options].filter((o) => o.value in skies);
    const more = this.weather || kind === of_weather ? [new Option(`hour of ${words}`, of_weather)] : [];
    const file = new Option(`an hour of ${this.weather ? 'another' : 'a'} weather file ...`, a_file);
    $('sky-kind').replaceChildren(...keeps, ...more, file, ...kind ? [] : [new Option('of its own', '')]);
    $('sky-kind').value = kind ?? '';
    if (more.length) more[0].disabled = !this.weather;
  }
}
