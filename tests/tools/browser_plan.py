# SPDX-License-Identifier: BSD-3-Clause
# The plan beside the picture, while ptrace renders: browser_plan.py LINK
#   LINK: what vcview printed.
import json, math, os, re, sys
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

page = Page(link_in(sys.argv[1]))
SECONDS = 90  # for a machine with other work
rows = lambda: {grid: cells for grid, *cells in page.rows('#plan-numbers')}
mean = lambda: float(rows()['desk'][0].split()[0])
says = lambda: page.text('#plan-say')
frames = lambda: int(re.findall(r'^(\d+) frames$', says())[0])  # none while the map is of another model
state = lambda: json.loads(re.search(rb'"plan":(\{.*?\})', page.ask('/next?picture=99999&line=99999')[1])[1])
drawn = """[...document.querySelectorAll('#plan img')].every((i) => i.complete && i.naturalWidth > 300)"""


def told():
    """Has the page the numbers that the server has of what it shows?"""
    shown = int(page.js('document.body.dataset.plan'))
    plan = json.loads(page.ask(f'/plan?picture={shown}')[1])
    return plan['number'] == shown and abs(mean() / plan['numbers']['desk.mean'] - 1) < .01


check('there is a map with a row for each grid', soon(lambda: frames() > 0, SECONDS), says())
check('whatever its name is', list(rows()) == ['desk', '<b>&'], rows())
check('it is drawn', page.until(drawn))
check('with intervals after a while', soon(lambda: re.search(r'\d to \d', rows()['desk'][0]), SECONDS), rows())
check('the numbers are those of the server', soon(told, SECONDS), rows())
check('both halves of the drawing are shown, each in its frame', page.js("""[...document.querySelectorAll('#plan div')]
    .every((d) => d.clientWidth > 200 && Math.abs(d.firstChild.clientWidth / d.clientWidth - 2) < .02)"""))

# what stands under the pointer, and from point to point by keys
said = lambda: page.text('#plan-point')
lines = [line.split() for line in open('desk.pts')]
map_places = lambda map: re.findall(r'<path d="M(\d+) (\d+)h(\d+)v(\d+)h-\d+z"><title>(.*?)</title>', map)
plan = lambda: json.loads(page.ask(f"/plan?picture={page.js('document.body.dataset.plan')}")[1])


def pointed(half, k):
    """Points at the middle of a point's cell, in a half of the drawing; is it said?"""
    map = plan()['map']
    width, (x, y, w, h, _) = int(re.search(r'width="(\d+)"', map)[1]), map_places(map)[k]
    again = int(re.search(r'<use href="#points" x="(\d+)"', map)[1])
    page.chrome.execute_script("""const [half, x, y, width] = arguments;
        const image = document.querySelectorAll('#plan img')[half];
        image.scrollIntoView({ block: 'center' });
        const box = image.getBoundingClientRect(), by = box.width / width;
        image.dispatchEvent(new PointerEvent('pointermove',
            { clientX: box.left + x * by, clientY: box.top + y * by, bubbles: true }));""",
        half, half * again + int(x) + int(w) / 2, int(y) + int(h) / 2, width)
    grid, at = ('desk', lines[k]) if k < 40 else ('<b>&', [(1, 1, .1), (2, 1, .1)][k - 40])
    wanted = f"{grid}: [\\d.]+( ± [\\d.]+)? lx at {', '.join(f'{float(v):g}' for v in at[:3])}"
    return re.fullmatch(wanted, said())


check('the point under the pointer is said, in both halves', all(
    soon(lambda: pointed(half, k), SECONDS) for half in (0, 1) for k in (0, 7, 33, 41)), said())
check('and marked in both', page.js("""[...document.querySelectorAll('#plan b')].every((b) => b.checkVisibility() &&
    ((m, d) => m.left > d.left && m.right < d.right && m.top > d.top && m.bottom < d.bottom)(b.getBoundingClientRect(),
    b.parentElement.getBoundingClientRect()))"""))
check('with its words beside the mark', page.js("""[...document.querySelectorAll('#plan b')].every((b) =>
    getComputedStyle(b, '::after').content === JSON.stringify(document.getElementById('plan-point').textContent))"""))
page.focus('#plan')
soon(lambda: pointed(0, 5), SECONDS)
place = lambda: [round(float(v), 2) for v in said().split(' at ')[1].split(', ')]
steps = []
for key in (Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ARROW_UP, Keys.ARROW_LEFT, Keys.ARROW_DOWN):
    page.keys('#plan', key)
    steps.append(place())
check('arrow keys go from point to point', steps == [[3.45, .4, .76], [3.45, 1.3, .76], [3.45, 2.2, .76],
                                                     [3, 2.2, .76], [3, 1.3, .76]], steps)
for _ in range(9): page.keys('#plan', Keys.ARROW_DOWN)
check('and to the next grid', said().startswith('<b>&: ') and place()[1:] == [1, .1], said())
for _ in range(9): page.keys('#plan', Keys.ARROW_RIGHT)
check('where they end at the last point', place() == [2, 1, .1], said())

before = page.js('document.querySelector("#plan img").src')
page.type('#plan-limit', '2000')
heading = lambda: page.text('#plan-numbers thead')
check('another limit has another share', soon(lambda: '≥ 2000 lx' in heading(), SECONDS), heading())
check('and another map', page.until(f'document.querySelector("#plan img").src != "{before}"') and page.until(drawn))
check('where the same point is chosen', said().startswith('<b>&: ') and place() == [2, 1, .1], said())
page.type('#plan-limit', '-3')
check('a wrong limit is refused', soon(lambda: not page.js('document.getElementById("plan-limit").validity.valid')))
check('and changes nothing', state()['limit'] == 2000)
page.type('#plan-limit', '2000')
page.chrome.execute_script("""const ask = window.fetch; window.mute = true;
    window.fetch = (path, ...more) => window.mute && String(path).startsWith('/plan?picture') ?
        (window.muted = true, Promise.reject(new TypeError())) : ask(path, ...more);""")
page.ask('/plan?limit=1500', 'POST', b'')
muted = lambda: page.until('window.muted', SECONDS)
check('an answer that was lost leaves the map as it was', muted() and '≥ 2000 lx' in heading())
page.js('(window.mute = false)')
check('and is asked for again', soon(lambda: '≥ 1500 lx' in heading(), SECONDS), heading())
page.ask('/plan?limit=2000', 'POST', b'')
check('as another window asks', soon(lambda: '≥ 2000 lx' in heading(), SECONDS), heading())

page.chrome.execute_cdp_cmd('Browser.setDownloadBehavior', {'behavior': 'allow', 'downloadPath': os.getcwd()})
page.menu('Save')
page.click('#save-plan')
check('the map is saved', soon(lambda: os.path.exists('plan.svg') and open('plan.svg').read().endswith('</svg>\n')))

page.click('#report')
report = lambda: open('report.html').read()
check('the report has the plan', soon(lambda: os.path.exists('report.html') and 'class="plan"' in report() and
                                      'Mean illuminance of &lt;b&gt;&amp;' in report(), SECONDS))

day = mean()
page.keys('#skies label:nth-of-type(2) input', *[Keys.ARROW_RIGHT] * 8)
check('a change of the sky begins the plan anew', soon(
    lambda: frames() > 0 and state()['edit'] > 0 and not state()['waits'] and mean() < .8 * day, SECONDS), rows())
page.chrome.refresh()
same = lambda: '≥ 2000 lx' in heading() and frames() > 0 and mean() < .8 * day
check('a reload shows the same', soon(same, SECONDS))
undone = lambda: page.one('#undo').is_enabled() and page.one('#undo').click()
soon(lambda: undone() or not page.one('#undo').is_enabled(), SECONDS)
check('Undo brings the first numbers back', soon(lambda: frames() > 0 and mean() > .8 * day, SECONDS), rows())

# the eye, where it is pressed, and where it is dragged to
page.resize(1700, 1000)  # wide enough for all words of the head: the map stays where it is
page.js('(document.getElementById("sky-panel").open = false)')  # nor do hours push it down
eye_at = lambda: [float(v) for v in re.findall(r'-?[\d.]+', page.js('document.getElementById("eye-at").textContent'))]
azimuth = lambda: float(page.js('document.getElementById("azimuth").value'))
metre = lambda: page.js('document.querySelector("#plan u").getBoundingClientRect().width')


def drag_on_map(k, *by):
    """From the middle of a point's cell, so many metres right and up."""
    page.js('document.querySelector("#plan img").scrollIntoView({ block: "center" })')
    map = plan()['map']
    x, y, w, h, _ = map_places(map)[k]
    box = page.js('(({ left, top, width }) => [left, top, width])(arguments[0].getBoundingClientRect())',
                  page.one('#plan img'))
    scale = box[2] / int(re.search(r'width="(\d+)"', map)[1])
    at = (box[0] + (int(x) + int(w) / 2) * scale, box[1] + (int(y) + int(h) / 2) * scale)
    hand = ActionBuilder(page.chrome)
    hand.pointer_action.move_to_location(round(at[0]), round(at[1])).pointer_down()
    if by: hand.pointer_action.move_to_location(round(at[0] + by[0] * metre()), round(at[1] - by[1] * metre()))
    hand.pointer_action.pointer_up()
    hand.perform()


check('north and a metre are told, and the eye is shown in each level grid', page.until('''
    (document.querySelector("#plan em").textContent === "▲ N1 m" &&
        document.querySelectorAll("#plan i").length === 2)'''.strip()))
height = eye_at()[2]
drag_on_map(3)
near = lambda at: math.dist(eye_at()[:2], at) < .12 and eye_at()[2] == height
check('a press puts the eye there, at its height', soon(lambda: near((2.1, .4)), SECONDS), eye_at())
check('it looks as before', azimuth() == 180, azimuth())
drag_on_map(20, 1, 1)
check('a drag says where it looks', soon(lambda: near((2.55, 2.2)) and abs(azimuth() - 45) < 4, SECONDS),
      (eye_at(), azimuth()))
check('the mark is there', soon(lambda: page.js(
    'document.querySelector("#plan i").style.rotate').startswith('0.7')))
for _ in range(2): page.click('#undo')
check('Undo takes the eye back', soon(lambda: near((2, 2.7)) and azimuth() == 180, SECONDS), (eye_at(), azimuth()))

for w in (1280, 390):
    page.resize(w, 900)
    check(f'nothing is wider than a page of {w} pixels', page.fits())
page.check_contrast()
page.check_keyboard()
page.end()
