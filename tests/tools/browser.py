# SPDX-License-Identifier: BSD-3-Clause
# The page of vcview in a headless Chromium, compared with what the programs wrote:
#   browser.py LINK STREAM LINES PIXELS SOURCES SAVED
#   LINK: what vcview printed; STREAM: the pictures that it reads; LINES: its output; PIXELS: the last picture in
#   falsecolor, 8-bit RGB; SOURCES: its glare sources, a JSON object a line; SAVED: a folder for what the page saves.
#   A sentence for each check; status 1 if one fails.
import json, os, re, struct, sys
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

stream, lines, falsecolor, sources, saved = sys.argv[2:7]


def last_picture(name):
    data = open(name, 'rb').read()
    at = 0
    while at < len(data):
        size = re.compile(rb'\n\n-Y (\d+) \+X (\d+)\n').search(data, at)
        height, width = int(size[1]), int(size[2])
        at = size.end() + 12 * width * height
    return width, height, struct.unpack(f'<{3 * width * height}f', data[size.end():at])


want = open(lines).read().splitlines()
width, height, floats = last_picture(stream)
page = Page(link_in(sys.argv[1]))
check('all lines arrive', page.until(f'document.body.dataset.lines == {len(want)}'))
check('the status says how far it is', page.until('document.getElementById("status").textContent.includes("frames")'))

# the table has the last line's numbers
names, last = want[0].split('\t'), want[-1].split('\t')
cells = {name: value for name, value, *_ in page.rows('#table')}
check('the table has the last line', all(
    abs(float(cells[n]) - float(v)) <= 5e-4 * abs(float(v)) for n, v in zip(names, last) if n in cells) and cells)
check('curves are drawn', len(page.find('#plots path.curve')) > 0)

# falsecolor's bytes are those of the file
bytes_of = page.chrome.execute_async_script('''
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
good = 0
for k in range(50):
    x, y = (7 * k + 3) % width, (11 * k + 5) % height
    dx, dy = page.pixel_to_canvas(x + .5, y + .5, width, height)
    page.chrome.execute_script('''
        const c = document.getElementById('canvas'), box = c.getBoundingClientRect();
        c.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + box.width / 2 + arguments[0],
            clientY: box.top + box.height / 2 + arguments[1], bubbles: true }));''', dx, dy)
    text = page.one('#probe').text
    r, g, b = floats[3 * (y * width + x):][:3]
    luminance = 179 * (0.265074126 * r + 0.670114631 * g + 0.064811243 * b)
    found = re.match(rf'pixel {x}, {y}: (\S+) cd', text)
    good += bool(found) and abs(float(found[1]) - luminance) <= 1e-3 * abs(luminance) + .06
check('the probe tells the luminance of 50 pixels', good == 50, good)

# the page's own projection is the server's
wrong = page.chrome.execute_async_script('''
    const [asked, done] = arguments;
    (async () => {
        const { Eye } = await import('/view.js'), { ask } = await import('/net.js');
        const [options, width, height] = asked;
        const eye = new Eye(options);
        let wrong = 0;
        for (let k = 0; k < 50; k++) {
            const x = (13 * k + 2) % width, y = (17 * k + 9) % height, at = [(x + .5) / width, 1 - (y + .5) / height];
            const server = (await (await ask(`/pixel?x=${x}&y=${y}`)).json()).direction, ours = eye.direction(at);
            if (!server) { wrong += ours !== null; continue; }
            const back = eye.place(ours);
            wrong += Math.hypot(...server.map((v, i) => v - ours[i])) > 1e-9;
            wrong += Math.hypot(back[0] - at[0], back[1] - at[1]) > 1e-9;
        }
        done(wrong);
    })().catch((e) => done(String(e)));''', [facts['view'], width, height])
check('directions in the page are those of the server', wrong == 0, wrong)

# glare sources
want_sources = [json.loads(line) for line in open(sources)]
page.click('#sources-panel summary')
check('the sources of vcmetrics -sources are listed', want_sources and page.until(
    f'document.querySelectorAll("#sources tbody tr").length == {len(want_sources)}'))
got = page.chrome.execute_async_script('''
    const done = arguments[arguments.length - 1];
    import('/net.js').then(({ ask }) => ask('/sources?picture=1')).then((a) => a.json())
        .then((a) => done(a.sources));''')
without = lambda s: {k: v for k, v in s.items() if k not in ('frame', 'seconds')}
check('with all of their numbers', [without(s) for s in got] == [without(s) for s in want_sources], got)
rows = page.rows('#sources')
check('the table has number, share and luminance, the largest share first', all(
    int(r[0]) == s['source'] and r[1] == f"{100 * s['DGPshare']:.1f} %" and abs(float(r[2]) / s['L'] - 1) < 6e-4
    for r, s in zip(rows, sorted(want_sources, key=lambda s: -s['DGPshare']))), rows)

# its number stands at its brightest pixel
bright = [.265 * r + .67 * g + .065 * b for r, g, b in zip(floats[::3], floats[1::3], floats[2::3])]
top = max(range(width * height), key=lambda i: bright[i])
labels = page.chrome.execute_async_script('''
    const [outlines, width, height, bright, done] = arguments;
    import('/overlay.js').then(({ brightest }) =>
        done(outlines.map((o) => brightest(o, width, height, (x, y) => bright[y * width + x]))));''',
    [s['outline'] for s in want_sources], width, height, bright)
check('a source has its label at its brightest pixel', [top % width + .5, top // width + .5] in labels, (top, labels))

# files
page.chrome.execute_cdp_cmd('Browser.setDownloadBehavior',
                            {'behavior': 'allow', 'downloadPath': os.path.abspath(saved)})
page.menu('Save')
for kind in ('hdr', 'exr', 'png', 'svg', 'csv'):
    page.click(f'#save-{kind}')
    name = f'{saved}/luxpipe.{kind}'
    check(f'{kind} is saved', soon(lambda: os.path.exists(name) and os.path.getsize(name)))

page.click('#report')
name = f'{saved}/report.html'
check('a report is made by one click', soon(lambda: os.path.exists(name) and os.path.getsize(name)))
values = set(re.findall('<data value="([^"]*)"', open(name).read()))
table = [line.split('\t') for line in open(lines).read().split('\n')]
numbers = {n for name, n in zip(table[0], table[-2]) if name not in ('frame', 'seconds', 'tails', 'errors')}
check('with the numbers of the last line', numbers <= values, values)

# keys: tone, keep, compare; nothing is restarted
check('a photo first', page.js('document.getElementById("tone").value') == 'photo')
page.click('#luminance')
check('falsecolor is one click away', page.js('document.getElementById("tone").value') == 'falsecolor' and
      soon(lambda: page.one('#legend').is_displayed()))
before = page.js('document.getElementById("tone").value')
page.keys('body', 't')
page.menu('Scale')
check('the scale of falsecolor is of falsecolor alone', not page.one('#legend').is_displayed()
      and not page.one('#top').is_displayed() and page.one('#stops').is_displayed())
check('t changes the tone', page.js('document.getElementById("tone").value') != before)
page.keys('body', 'k')
check('k keeps the picture to compare with', page.until('!document.getElementById("compare").disabled', 5))
page.keys('body', 'c')
check('c changes the comparison', page.js('document.getElementById("compare").value') == 'beside')
for kind, shown in (('falsecolor', True), ('photo', False)):
    page.chrome.execute_script(f"""const tone = document.getElementById('tone');
        tone.value = '{kind}'; tone.dispatchEvent(new Event('change'));""")
    for compare in ('no', 'difference'):
        page.chrome.execute_script(f"""const compare = document.getElementById('compare');
            compare.value = '{compare}'; compare.dispatchEvent(new Event('change'));""")
        check(f'the scale under {kind}, compared: {compare}', soon(
            lambda: page.one('#legend').is_displayed() == (shown or compare == 'difference'), 5))
        words = page.text('#caption')
        check('a comparison says with what', ('compared with' in words) == (compare == 'difference'), words)
page.check_keyboard()
page.check_contrast()

for w in (1280, 390):
    page.resize(w, 900)
    check(f'nothing is wider than a page of {w} pixels', page.fits())
found = page.errors()
check('the console has no errors before the wrong link', not found, found)
page.chrome.get(page.link.split('#')[0] + '#00')
page.chrome.refresh()
check('a wrong link is said', page.until('document.getElementById("state").textContent.includes("not the one")', 10))
page.errors()
page.end()
