# SPDX-License-Identifier: BSD-3-Clause
# Nine tasks of a designer in the page of luxpipe-live, counted in actions: browser_tasks.py LINK SIZE MODEL
#   An action is a click, a drag, a key or a field that is typed.  The table at the end is that of docs/live.md.
import re, sys, time
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

# Where things are in the picture, and what they are called.
OFFICE = {'pane': 'pane', 'at pane': (.547, .43), 'blind': (.45, .37), 'lower': ('repeated', .8, 'blind.rad:2: 20 to '),
          'wall': (.8, .3), 'paint': 'wall_paint', 'was': '.67', 'colour': (.68, .67, .64)}
SHADE = {'blind': (.5, .4), 'lower': ('moved up', .3, 'roller_shade_1 moved up by -.')}
MODELS = {'office': OFFICE,
          'honeybee': {**SHADE, 'pane': 'Studio_Back_Glz0', 'at pane': (.5, .4), 'wall': (.1, .5),
                       'paint': 'generic_wall_0.50', 'was': '.5', 'colour': (.5, .5, .5)},
          'sketchup': {**SHADE, 'pane': 'Window', 'at pane': (.5, .4), 'wall': (.1, .5),
                       'paint': 'Wall_White', 'was': '.7', 'colour': (.70, .70, .68)}}
model = MODELS[sys.argv[3]]
page = Page(link_in(sys.argv[1]), 1440, 900)
side, SECONDS = int(sys.argv[2]), 300
size = (side, side)
text = page.text
rows = lambda: page.rows('#edits')
values = lambda: {name: v for name, *v, unit in page.rows('#table')}
done = []


class Task:
    """Counts what a person does; the task has to be done with at most so many actions."""
    def __init__(self, name, most): self.name, self.most, self.actions = name, most, 0

    def __enter__(self):
        self.begin = time.time()
        return self

    def __exit__(self, *_):
        done.append((self.name, self.actions, time.time() - self.begin))
        check(f'{self.name}: {self.most} actions or less', self.actions <= self.most, self.actions)

    def click(self, css, words=''):
        self.actions += 1
        page.click(css, words)

    def key(self, keys, css='#canvas'):
        self.actions += 1
        page.keys(css, keys)

    def type(self, css, words):
        self.actions += 1
        page.type(css, words)

    def drag(self, *places):
        self.actions += 1
        page.drag(size, *[(x * side, y * side) for x, y in places])

    def point(self, x, y): self.drag((x, y))

    def slide(self, label, share):
        """A press on the track of a slider: at this share of its width."""
        self.actions += 1
        def press(of):
            track = page.js('arguments[0].querySelector("input")', of)
            page.chrome.execute_script('arguments[0].scrollIntoView({block: "center"})', track)
            hand = ActionChains(page.chrome, duration=30)
            hand.move_to_element_with_offset(track, round((share - .5) * track.size['width']), 0).click().perform()
        page.one('.sliders label', label, press)


def difference(words):
    """The newest row of the table of edits is that one, with a difference of DGPf and its interval."""
    found = lambda: rows() and words in rows()[0][0] and re.search(r'\(.* to .*\)', rows()[0][2])
    check(f'"{words}" has a difference', soon(found, SECONDS), rows()[:2])


check('there are numbers', page.until('document.body.dataset.lines > 4', SECONDS))

with Task('glare now, and from where', 1) as t:
    check('a word and a number', soon(lambda: re.search('perceptible|disturbing|intolerable', text('#verdict'))
                                   and 'DGPf' in text('#glare'), SECONDS), text('#verdict'))
    t.click('#sources-panel summary')
    named = lambda: re.search(r'^\d+\t[\d.]+ %(\t[\d.]+){3}\t\w+', text('#sources tbody')) or \
        'no glare source' in text('#sources-say')
    check('sources by name, with their share', soon(named, SECONDS), text('#sources'))

with Task('desk, and a screen with its contrast', 8) as t:
    t.click('#draw-rect')
    t.drag((.3, .65), (.35, .7), (.7, .8))
    t.type('#regions [data-region=region1].name', 'desk')
    t.click('#draw-pair')
    t.drag((.42, .5), (.44, .55), (.5, .6))
    t.drag((.53, .5), (.55, .55), (.62, .6))
    for name in ('desk.TAL', 'low.TAL', 'high.TAL', 'low/high.CR'):
        check(f'{name} has a value and an interval',
              soon(lambda: all(re.match(r'[\d.]+$', v) for v in values().get(name, ['-'])), SECONDS), values())
    plots = lambda: page.js('[...document.querySelectorAll("#plots figcaption")].map((c) => c.innerText)')
    check('and a plot', soon(lambda: {'desk.TAL', 'low/high.CR'} <= set(plots())), plots())

with Task('an hour of December without glare', 1) as t:
    hour = '#day button.class0:not(.open):not([aria-current=true])'
    check('the hours come by themselves', soon(lambda: page.find(hour), SECONDS))
    which = page.one(hour).get_attribute('data-hour')
    t.click(f'#day button[data-hour="{which}"]')
    difference(f'21 Dec {which}:00')
    check('there is none', soon(lambda: text('#verdict') == '○ imperceptible', SECONDS), text('#verdict'))

with Task('a shade', 2) as t:
    t.point(*model['at pane'])
    t.click('#here button', f'Add a shade to {model["pane"]}')
    difference(f'roller_shade_1 added to {model["pane"]}')

with Task('the blind lower', 2) as t:
    t.point(*model['blind'])
    t.slide(*model['lower'][:2])
    difference(model['lower'][2])

with Task('a darker wall', 2) as t:
    t.point(*model['wall'])
    t.slide('reflectance', .4)
    difference(f'{model["paint"]}: {model["was"]} to .')
    numbers = re.escape(model['paint']) + r'\s+0\s+0\s+5 (\S+) (\S+) (\S+)'
    colour = lambda: map(float, re.search(numbers, text('#model-text')).groups())
    was = model['colour']
    hue = lambda r, g, b: r < .5 and abs(g / r - was[1] / was[0]) < 1e-4 and abs(b / r - was[2] / was[0]) < 1e-4
    check('the hue stays', soon(lambda: hue(*colour())), text('#model-text'))

with Task('look left by 45 degrees, and back', 4) as t:
    t.click('.menu summary', 'View')
    before = page.js('document.getElementById("azimuth").value')
    t.click('#left')
    check('it is 45 degrees', soon(lambda: rows()[0][0].startswith('view') and float(page.js(
        'document.getElementById("azimuth").value')) == (float(before) - 45) % 360, SECONDS), (before, rows()[:2]))
    t.click('#back')
    check('and back', soon(lambda: page.js('document.getElementById("azimuth").value') == before, SECONDS))

with Task('before and after, side by side', 1) as t:
    t.key('c')
    check('two pictures', soon(lambda: page.js('document.getElementById("compare").value') == 'beside'))

with Task('save', 2) as t:
    t.click('.menu summary', 'Save')
    t.click('#save-png')

with Task('dark, narrow, by keyboard, at 200 %', 0) as t:
    page.chrome.refresh()
    page.until('document.body.dataset.lines > 4', SECONDS)
    page.check_contrast()
    for width, height in ((390, 800), (720, 450)):
        page.resize(width, height)
        check(f'all is within {width} pixels', soon(page.fits))
    stops = page.js("""[...document.querySelectorAll('button, select, input, summary, a[href], [tabindex="0"]')]
        .filter((e) => !e.disabled && e.tabIndex >= 0 && e.checkVisibility()).map((e) => e.id)""")
    check('no more than 20 stops of the tab key lead to the regions', 0 < stops.index('draw-circle') <= 20, stops)

print(f'\n{"task":40}actions  seconds')
for name, actions, seconds in done: print(f'{name:40}{actions:7}  {seconds:7.1f}')
page.end()
