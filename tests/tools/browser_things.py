# SPDX-License-Identifier: BSD-3-Clause
# Things by name in the page of luxpipe-live: paints, glazings, fabrics, a shade and a blind before a window:
# browser_things.py LINK SIZE
import math, os, random, re, sys
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

page = Page(link_in(sys.argv[1]))
size, SECONDS = (int(sys.argv[2]),) * 2, 90
text = lambda: page.text('#model-text')
edits = lambda: [row[0] for row in page.rows('#edits')]
here = lambda: page.text('#here')
point = lambda x, y: page.click_at(size, (size[0] * x, size[1] * y))
options = lambda: page.js('[...document.querySelector("#here select").options].map((o) => o.text)')


def choose(name, n=0):
    page.one('#here select', '', lambda e: page.js('''((select) => { select.value = arguments[1];
        select.dispatchEvent(new Event('change')); return select.value === arguments[1]; })(
        document.querySelectorAll('#here select')[arguments[2]])''', e, name, n))


check('a picture comes', page.until('document.body.dataset.picture > 0 && document.body.dataset.lines > 3', SECONDS))
# Where the head ends and its buttons are, at each frame of the page: what moves under the pointer loses a click.
page.chrome.execute_script("""const places = window.places = new Set(), look = () => {
        places.add(['#undo', '#redo', '#report', '#side'].map((css) => {
            const at = document.querySelector(css).getBoundingClientRect();
            return `${css} ${at.x} ${at.y}`; }).join(', '));
        requestAnimationFrame(look); };
    look();""")
files = page.js('[...document.querySelectorAll("#model-file option")].map((o) => o.text)')
check('the scene has the name of its own folder', page.text('#where').startswith(os.path.basename(os.getcwd()) + ', '),
      page.text('#where'))
check('files of the library are none to edit',
      files == ['materials.rad', 'open.rad', 'latin.rad', 'sky_day.rad'], files)
point(.8, .3)
check('a wall is a material of its own', soon(lambda: 'wall_paint' in here() and options()[0] == 'of its own'), here())
check('and may be any paint of the library', {'paint white', 'wall 50', 'brick red'} <= set(options()), options())
choose('paint_white')
check('which is an edit with its name', soon(lambda: 'wall_paint: paint white' in edits(), SECONDS), edits())
check('its numbers are those of the library', re.search(r'wall_paint\s+0\s+0\s+5 \.8 \.8 \.8 0 0', text()), text())
check('and it is shown as such', page.js('document.querySelector("#here select").value') == 'paint_white')

point(.547, .43)
check('a pane is a glazing', soon(lambda: 'pane' in here() and 'double low e' in options()), here())
choose('sun_protection_30')
check('another one is an edit', soon(lambda: 'glazing: sun protection 30' in edits(), SECONDS), edits())
page.click('#here button', 'Add a shade to pane')
check('a shade has a fabric of the library', soon(lambda: 'roller_shade_1 added to pane' in edits(), SECONDS), edits())
check('in a file whose text is known', page.js('document.getElementById("model-file").value') == 'open.rad')
check('that is named', page.js('document.querySelector("#here select").value') == 'fabric_grey_3', here())
choose('fabric_white_5')
check('and changed by name',
      soon(lambda: 'roller_shade_1_fabric: fabric white 5' in edits() and '.2209 .2632' in text(), SECONDS), edits())
page.click('#undo')
page.click('#undo')
check('undone', soon(lambda: 'roller_shade_1' not in text(), SECONDS))
point(.547, .43)
page.click('#here button', 'Add a blind to pane')
check('a blind is added', soon(lambda: 'blind_1 added to pane' in edits(), SECONDS), edits())
labels = lambda: page.js('[...document.querySelectorAll("#here label")].map((l) => l.firstChild.data)')
check('it has slats of the library, as many as there are, one tilt, and a place', labels() == [
    'material', 'reflectance', 'turned, degrees', 'repeated', 'moved along x', 'moved along y', 'moved up'], labels())
check('which are named', page.js('document.querySelector("#here select").value') == 'slat_white')
check('its picture is rendered', soon(lambda: page.rows('#edits')[0][0] == 'blind_1 added to pane' and
                                      int(page.rows('#edits')[0][1]) > 0, SECONDS), page.rows('#edits'))
point(.547, .43)
check('the picture has its slats', soon(lambda: 'blind_1' in here(), SECONDS), here())
check('nothing moved while the numbers came and went', len(page.js('[...places]')) == 1, page.js('[...places]'))

# The sky
sky = lambda: re.search(r'^!.*$', page.text('#model-text'), re.M).group()
kind = lambda: page.js('document.getElementById("sky-kind").selectedOptions[0].text')


def choose_sky(value):
    page.chrome.execute_script("""const of = document.getElementById('sky-kind');
        of.value = arguments[0]; of.dispatchEvent(new Event('change'));""", value)


check('the sky has its name', soon(lambda: kind() == 'clear, with sun'), kind())
choose_sky('-c')
check('another one is an edit', soon(lambda: 'sky: overcast' in edits(), SECONDS), edits())
check('of the same place', sky() == '!gensky 12 21 14 -c -a 42.36 -o 71.06 -m 75 -g .2', sky())
page.one('#weather').send_keys(os.path.abspath('days.wea'))
check('an hour of a weather file is one, with its place', soon(lambda: 'sky: an hour of Made up' in edits(), SECONDS),
      edits())
check('and time', sky() == '!gendaylit 12 21 13.5 -W 695 41 -a 42.36 -o 71.06 -m 75 -g .2', sky())
check('it is called so', soon(lambda: kind() == 'hour of Made up'), kind())
slid = lambda: page.js('[...document.querySelectorAll("#skies output")].map((o) => o.value)')
page.keys('#skies label:nth-of-type(2) input', Keys.ARROW_LEFT)
check('the hour before has its own radiation', soon(lambda: '12 21 12.5 -W 7' in sky()), sky())
check('and the slider stands there', soon(lambda: slid() == ['21 Dec', '12:30']), slid())
page.keys('#skies label:nth-of-type(1) input', Keys.ARROW_RIGHT)
check('after the last day of the file there is none', soon(lambda: slid() == ['21 Dec', '12:30']), slid())
page.keys('#skies label:nth-of-type(1) input', Keys.ARROW_LEFT)
check('the day before is that of the file', soon(lambda: ' 9 21 12.5 -W ' in sky()), sky())
check('and shown so', soon(lambda: slid() == ['21 Sep', '12:30']), slid())
page.keys('#skies label:nth-of-type(1) input', Keys.ARROW_RIGHT)
check('and back', soon(lambda: ' 12 21 12.5 -W ' in sky() and slid() == ['21 Dec', '12:30']), (sky(), slid()))
choose_sky('+s')
check('back to a clear one', soon(lambda: sky().startswith('!gensky 12 21 12.5 +s -a 42.36')), sky())
with open('wrong.epw', 'w') as file: file.write('nothing')
page.one('#weather').send_keys(os.path.abspath('wrong.epw'))
check('a file that is no weather is told', soon(lambda: page.js(
    'document.getElementById("sky-kind").validationMessage') == 'neither an EPW nor a WEA file'))
epw = 'LOCATION,Town,-,-,x,1,51.5,-.25,1,0\n' + 'x\n' * 7 + ''.join(
    f'2001,1,{day},{hour},60,?,1,1,1,1,1,1,1,1,{100 * day + hour},{hour}\n' for day in (1, 2) for hour in range(1, 25))
texts = page.chrome.execute_async_script("""
    const [epw, done] = arguments;
    import('/sky_text.js').then((m) => {
        const weather = m.weather_of(epw);
        done([weather, ...['!gendaylit 3 1 +9 -W 1 2 -O 0 -g .3', '# x\\n!gensky 6 1 9:30 -a 1 +i -B 55 | x',
            '!gensky 1 1 8 -u'].flatMap((l) =>
                [m.kind_of(l), m.with_sky_kind(l, '-s'), m.with_weather(l, weather, 2, 9)])]);
    });""", epw)
check('EPW: west of Greenwich, hours by their middles', {k: texts[0][k] for k in (
    'place', 'latitude', 'longitude', 'meridian')} == {'place': 'Town', 'latitude': 51.5, 'longitude': .25,
                                                       'meridian': -15} and len(texts[0]['hours']) == 48, texts[0])
told = '!gendaylit 1 2 8.5 -W 209 9 -a 51.5 -o 0.25 -m -15'
check('lines of other programs and options', texts[1:] == [
    'weather', '!gensky 3 1 +9 -s -g .3', told + ' -g .3',
    '+i', '# x\n!gensky 6 1 9:30 -s -a 1 | x', '# x\n' + told + ' | x', None, '!gensky 1 1 8 -s', told], texts[1:])

quoted = page.chrome.execute_async_script("""
    import('/model_text.js').then(({ things_in }) => arguments[0](things_in(
        'void glass "Clear  Glass" 0 0 3 .8 .8 .8\\nvoid plastic a\\'b c\\'d 0 0 5 1 1 1 0 0')
            .map((t) => [t.name, t.reals.length])));""")
check('names may have blanks', quoted == [['Clear  Glass', 3], ['ab cd', 5]], quoted)
half = page.chrome.execute_async_script("""
    import('/model_text.js').then(({ skies_in, with_sky }) => arguments[0]([
        skies_in('!gensky 6 1 9:30 +s')[0].hour, with_sky('!gensky 6 1 9:30 +s', 0, 152, 10)]));""")
check('half past nine is half past nine', half == [9.5, '!gensky 6 1 10 +s'], half)

# The hours of the day, and what is said of them
said = page.chrome.execute_async_script('''
    const [done] = arguments, hours = (n) => [...Array(n).keys()].map((h) => [h, .36, .355, .365]);
    import('/day.js').then(({ Day }) => {
        const day = new Day({ hour: () => 12 }), buttons = () => [...document.querySelectorAll('#day button')];
        done([[0, false], [12, false], [12, true], [25, true], [0, true]].map(([n, ended]) => {
            day.take({ file: 0, hours: hours(n), ended });
            const texts = buttons().flatMap((b) => [b.querySelector('i'), b.lastChild].map((of) => {
                const range = document.createRange();
                range.selectNodeContents(of);
                return [of.data === undefined, range.getBoundingClientRect()];
            })), over = [true, false].filter((kind) => {
                const row = texts.filter(([is]) => is === kind).map(([, box]) => box);
                return row.some((box, k) => k && box.left < row[k - 1].right);
            });
            const say = document.getElementById('day-say'), heights = [];
            for (let width = 150; width < 500; width += 5) {
                say.style.width = `${width}px`;
                heights.push(say.getBoundingClientRect().height);
            }
            say.style.width = '';
            return [say.innerText, String(heights), over.length];
        }));
    });''')
check('a day whose noon is dark has no hours, and waits for none', said[4][0] ==
      'no hours of the day: at noon no light reaches the eye' and said[0][0].endswith('32 frames'), said)
check('its words keep their height when the last hour comes', said[1][1] == said[2][1], said)
check('numbers of hours do not touch', not any(over for *_, over in said), said)

# Windows of any direction: the slats hang before them, on the eye's side, the outer edge lower.
random.seed(62)
for k in range(20):
    around, width, low, high = (random.uniform(a, b) for a, b in ((0, 2 * math.pi), (.3, 6), (0, 1.5), (1.7, 4)))
    along = (math.cos(around), math.sin(around))
    x, y, side = random.uniform(-50, 50), random.uniform(-50, 50), random.choice((1, -1))
    inward = (-along[1] * side, along[0] * side)
    corners = [[x + along[0] * u, y + along[1] * u, z] for u, z in ((0, low), (width, low), (width, high), (0, high))]
    random.shuffle(corners)
    if abs(sum(a * b for a, b in zip(*([c - d for c, d in zip(corners[k], corners[0])] for k in (1, 2))))) < 1e-9:
        corners = corners[::-1]
    eye = [x + along[0] + 3 * inward[0], y + along[1] + 3 * inward[1], 1.2]
    added = page.chrome.execute_async_script('''
        const [corners, eye, done] = arguments;
        import('/shades.js').then(({ with_blind }) => done(with_blind('', corners, eye, (name) => `void ${name}`)[0]));
        ''', corners, eye)
    n = [float(v) for v in re.search(r'!genbox .*', added).group().split() if re.match(r'[-\d.]+$', v)]
    box, tilt, count, apart, turn, at = n[0:3], math.radians(n[6]), int(n[7]), n[10], math.radians(n[12]), n[13:16]
    wrong = [] if abs(box[0] - width) < 1e-3 else [box]
    for slat in (0, count - 1):
        edges = []
        for u in (0, box[0]):
            for v in (-.025, .025):
                local = (u, v * math.cos(tilt), v * math.sin(tilt) + slat * apart)
                place = (local[0] * math.cos(turn) - local[1] * math.sin(turn) + at[0] - x,
                         local[0] * math.sin(turn) + local[1] * math.cos(turn) + at[1] - y, local[2] + at[2])
                of_wall = place[0] * along[0] + place[1] * along[1]
                off = place[0] * inward[0] + place[1] * inward[1]
                edges.append((off, place[2]))
                if not (-.01 < of_wall < width + .01 and .02 < off < .08 and low - .02 < place[2] < high + .02):
                    wrong.append((slat, of_wall, off, place[2], width, low, high))
        wrong += [] if max(edges)[1] > min(edges)[1] else ['the inner edge is lower']
    check(f'a blind before window {k}', not wrong, (wrong, added, corners))
page.end()
