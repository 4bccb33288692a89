# SPDX-License-Identifier: BSD-3-Clause
# The page of vcview in a headless Chromium, compared with what the programs wrote: browser.py LINK STREAM LINES PIXELS
#   LINK: what vcview printed; STREAM: the pictures that it reads; LINES: its output; PIXELS: the last picture in
#   falsecolor, 8-bit RGB.  A sentence for each check; status 1 if one fails.
import re, struct, sys, time
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

link, stream, lines, falsecolor = sys.argv[1:5]
options = webdriver.ChromeOptions()
for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--window-size=1280,1000'):
    options.add_argument(argument)
options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
page = webdriver.Chrome(options=options)
failures = 0


def check(sentence, true):
    global failures
    failures += not true
    print('ok' if true else 'not ok', '-', sentence)


def until(script, seconds=60):
    end = time.time() + seconds
    while time.time() < end:
        if page.execute_script('return ' + script): return True
        time.sleep(.1)
    return False


def last_picture(name):
    data = open(name, 'rb').read()
    at = 0
    while at < len(data):
        size = re.compile(rb'\n\n-Y (\d+) \+X (\d+)\n').search(data, at)
        height, width = int(size[1]), int(size[2])
        at = size.end() + 12 * width * height
    return width, height, struct.unpack(f'<{3 * width * height}f', data[size.end():at])


link = re.search(r'http://\S+', open(link).read())[0]
want = open(lines).read().splitlines()
width, height, floats = last_picture(stream)

page.get(link)
check('all lines arrive', until(f'document.body.dataset.lines == {len(want)}'))
check('the status says how far it is', until('document.getElementById("status").textContent.includes("frames")'))
time.sleep(1)

# the table has the last line's numbers
names, last = want[0].split('\t'), want[-1].split('\t')
rows = page.find_elements(By.CSS_SELECTOR, '#table tbody tr')
cells = {r[0].text: r[1].text for r in (row.find_elements(By.TAG_NAME, 'td') for row in rows)}
check('the table has the last line', all(
    abs(float(cells[n]) - float(v)) <= 5e-4 * abs(float(v)) for n, v in zip(names, last) if n in cells) and cells)
check('curves are drawn', len(page.find_elements(By.CSS_SELECTOR, '#plots path.curve')) > 0)

# falsecolor's bytes are those of the file
bytes_of = page.execute_async_script('''
    const done = arguments[arguments.length - 1];
    const token = location.hash.slice(1), ask = (p) => fetch(p, { headers: { 'X-Luxpipe-Token': token } });
    (async () => {
        const body = await (await ask('/next?picture=0&line=0')).arrayBuffer();
        const length = new DataView(body).getUint32(0, true);
        const facts = JSON.parse(new TextDecoder().decode(new Uint8Array(body, 4, length)));
        const rgb = new Float32Array(body.slice(4 + length));
        const table = await (await ask('/table?top=' + facts.top + '&decades=3')).json();
        const { falsecolor } = await import('/picture.js');
        done([Array.from(falsecolor(rgb, table)), Array.from(rgb), facts]);
    })().catch((e) => done([[], [], String(e)]));''')
ours, rgb, facts = bytes_of
check('the floats are those of the stream', rgb == list(floats))
want_bytes = open(falsecolor, 'rb').read()
check('falsecolor has the bytes of the file', bytes(v for i, v in enumerate(ours) if i % 4 != 3) == want_bytes)

# the probe tells luminance under the pointer
canvas = page.find_element(By.ID, 'canvas')
good = 0
for k in range(10):
    x, y = (7 * k + 3) % width, (11 * k + 5) % height
    box = canvas.rect
    scale = min(box['width'] / width, box['height'] / height)
    page.execute_script('''
        const c = document.getElementById('canvas'), box = c.getBoundingClientRect();
        c.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + box.width / 2 + arguments[0],
            clientY: box.top + box.height / 2 + arguments[1], bubbles: true }));''',
                        (x + .5 - width / 2) * scale, (y + .5 - height / 2) * scale)
    text = page.find_element(By.ID, 'probe').text
    r, g, b = floats[3 * (y * width + x):][:3]
    luminance = 179 * (0.265074126 * r + 0.670114631 * g + 0.064811243 * b)
    found = re.match(rf'pixel {x}, {y}: (\S+) cd', text)
    good += bool(found) and abs(float(found[1]) - luminance) <= 1e-3 * abs(luminance) + .06
check('the probe tells the luminance of ten pixels', good == 10)

# keys: tone, keep, compare; nothing is restarted
body = page.find_element(By.TAG_NAME, 'body')
before = page.execute_script('return document.getElementById("tone").value')
body.send_keys('t')
check('t changes the tone', page.execute_script('return document.getElementById("tone").value') != before)
body.send_keys('k')
check('k keeps the picture to compare with', until('!document.getElementById("compare").disabled', 5))
body.send_keys('c')
check('c changes the comparison', page.execute_script('return document.getElementById("compare").value') == 'wipe')
for key in (Keys.TAB,) * 3: body.send_keys(key)
check('the keyboard reaches what can be changed',
      page.execute_script('return document.activeElement !== document.body'))

for w in (1280, 390):
    page.set_window_size(w, 900)
    time.sleep(.3)
    check(f'nothing is wider than a page of {w} pixels',
          page.execute_script('return document.documentElement.scrollWidth <= document.documentElement.clientWidth'))
errors = [e for e in page.get_log('browser')
          if e['level'] == 'SEVERE' and 'favicon' not in e['message']]
for e in errors: print('#', e['message'])
check('the console has no errors', not errors)
page.get(link.split('#')[0] + '#00')
page.refresh()
check('a wrong link is said', until('document.getElementById("status").textContent.includes("not the one")', 10))
page.quit()
sys.exit(failures > 0)
