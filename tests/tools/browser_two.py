# SPDX-License-Identifier: BSD-3-Clause
# Two browsers change one design at random, and reload: browser_two.py LINK LINES TRIES SEED PTRACE-ARGUMENTS
#   LINES: the table of vcmetrics.  After each change sliders, texts, picture and numbers of both browsers belong to one
#   model: that of vcview, which a batch run with the same seed renders bit by bit.
import json, random, re, struct, subprocess, sys, time
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

lines, tries, dice, scene = sys.argv[2], int(sys.argv[3]), random.Random(int(sys.argv[4])), sys.argv[5]
link, SECONDS = link_in(sys.argv[1]), 300
windows = [Page(link), Page(link)]
files = [f['name'] for f in json.loads(windows[0].ask('/facts')[1])['files']]
blind, sky = files.index('blind.rad'), files.index('sky_day.rad')


def model():
    """Texts by file, as vcview has them."""
    answers = {n: windows[0].ask(f'/overlay?n={n}') for n in (blind, sky)}
    return {n: body.decode() if status == 200 else open(files[n]).read() for n, (status, body, _) in answers.items()}


def choose(page, n):
    page.js(f'((s) => {{ s.value = "{files[n]}"; s.dispatchEvent(new Event("change")); }})('
            'document.getElementById("model-file"))')


def shown(page):
    """Texts by file, and the hour's slider, as the window has them."""
    texts = {}
    for n in (sky, blind):
        choose(page, n)
        texts[n] = page.js('document.getElementById("model-text").textContent')
    return texts, float(page.js('document.querySelectorAll("#skies input")[1].value'))


def newest():
    """Facts and floats of the newest picture."""
    body = windows[0].ask('/next?picture=0&line=0')[1]
    length = struct.unpack('<I', body[:4])[0]
    return json.loads(body[4:4 + length]), body[4 + length:]


def batch(texts, frames):
    """Floats of the sum of so many frames of this model, and its Ev."""
    for n, name in ((blind, 'blind.now'), (sky, 'sky.now')): open(name, 'w').write(texts[n])
    subprocess.run(f'ptrace -w- {scene} -frames 0:{frames} materials.rad layout.rad blind.now sky.now | ptaccum -every '
                   f'{frames} > batch.str; vcmetrics -metrics Ev < batch.str > batch.txt', shell=True, check=True)
    data = open('batch.str', 'rb').read()
    size = list(re.finditer(rb'\n\n-Y (\d+) \+X (\d+)\n', data))[-1]
    return data[size.end():size.end() + 12 * int(size[1]) * int(size[2])], open('batch.txt').read().split('\n')[-2]


def slide(page):
    keys = [dice.choice((Keys.ARROW_LEFT, Keys.ARROW_RIGHT))] * dice.randrange(1, 4)
    page.keys('#skies label:nth-of-type(2) input', *keys)


def lower(page):
    page.until("document.body.dataset.lines", SECONDS)
    choose(page, blind)
    slats = re.search(r'-a (\S+)', page.js('document.getElementById("model-text").textContent'))[1]
    page.click('#model-text button', slats)
    page.keys('#model-number input[type=range]', *[dice.choice((Keys.ARROW_LEFT, Keys.ARROW_RIGHT))] *
              dice.randrange(1, 5))


def undo(page):
    page.js('document.getElementById("undo").click()')  # disabled: nothing happens


for page in windows: page.until('document.body.dataset.lines > 4', SECONDS)
done, wrong = 0, []
for k in range(tries):
    page = windows[dice.randrange(2)]
    if dice.random() < .2: page.chrome.refresh()
    page.until('document.querySelectorAll("#skies input").length == 2 && document.body.dataset.lines', SECONDS)
    what = dice.choice((slide, slide, lower, lower, undo))
    what(page)
    if dice.random() < .2: slide(windows[1 - windows.index(page)])  # at the same time
    time.sleep(.5)

    def agree():
        texts = model()
        hour = float(re.search(r'!gensky \d+ \d+ (\S+)', texts[sky])[1])
        return all(shown(w) == (texts, hour) for w in windows)
    if not soon(agree, SECONDS):
        wrong.append((k, what.__name__, 'texts or sliders', [shown(w) for w in windows], model()))
        continue
    texts = model()

    until = time.time() + SECONDS
    while time.time() < until:
        facts, floats = newest()
        if facts.get('frames', 0) >= 4 and facts['what'] != 'preview':
            windows[0].ask('/control', 'POST', b'pause\n')  # which the next change ends
            time.sleep(.2)
            facts, floats = newest()
            same, row = batch(texts, facts['frames'])
            if same == floats: break
        time.sleep(.5)
    else:
        wrong.append((k, what.__name__, 'picture', facts))
        continue
    line = [r for r in open(lines).read().splitlines() if r.startswith(f'{facts["frames"]}\t') and
            r.split('\t')[2] == str(facts['edit'])]
    if line and line[0].split('\t')[3] != row.split('\t')[2]: wrong.append((k, 'numbers', line[0], row))
    done += 1
check(f'after {done} changes texts, sliders, picture and numbers belong to one model', done == tries and not wrong,
      wrong[:3])
windows[1].chrome.quit()
windows[0].end()
