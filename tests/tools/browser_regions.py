# SPDX-License-Identifier: BSD-3-Clause
# Regions by pointer and keys in the page of vcview: browser_regions.py LINK REGIONS SIZE
#   LINK: what vcview printed; REGIONS: the file that it writes; SIZE: sides of the square picture.
import re, sys
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

name, side = sys.argv[2], int(sys.argv[3])
size = (side, side)
page = Page(link_in(sys.argv[1]))
text = lambda: open(name).read()
outlines = lambda: {k: v for k, v in page.js(
    'fetch("/outlines?n=0", {headers: {"X-Luxpipe-Token": location.hash.slice(1)}}).then((a) => a.json())'
    '.then((all) => all.map((r) => [r.name, r.rings ? r.rings.length : r.trouble]))')}

rows = lambda n: page.until(f'document.querySelectorAll("#regions .name").length == {n}')
check('the table has the regions of the file', rows(5))
check('every kind with a shape has an outline; one that asks for the scene says so',
      soon(lambda: [outlines().get(k) for k in ('desk', 'task', 'band', 'round')] == [1] * 4)
      and 'scene' in str(outlines()['wood']), outlines())
time_out = lambda words: soon(lambda: re.search(words, text()))


def near(start, *numbers):
    """Does the file get a line that begins so and goes on with these numbers, to a pixel?"""
    def found():
        line = re.search(start + '(.*)', text())
        return line and all(abs(float(v) - n) <= 1 / side for v, n in zip(line[1].split(), numbers))
    return soon(found)


kept = [line for line in text().splitlines() if line.startswith('#')]

page.click('#draw-circle')
page.drag(size, (side * .3, side * .3), (side * .35, side * .3), (side * .4, side * .3))
check('a circle that is drawn arrives in the file', time_out('region1  circle'), text())
page.click('#draw-rect')
page.drag(size, (side * .25, side * .25), (side * .3, side * .3), (side * .5, side * .5))
check('a rectangle arrives', near('region2  rect fraction', .25, .75, .5, .5), text())
page.click('#draw-polygon')
page.click_at(size, (side * .6, side * .3), (side * .7, side * .3), (side * .7, side * .4))
page.keys('#canvas', Keys.ENTER)
check('a polygon arrives', time_out('region3  polygon direction'), text())
check('the table has them', rows(8))
check('the name of the newest is chosen', page.until('document.activeElement.dataset.region === "region3"'))

page.type('#regions [data-region=region2].name', 'window')
check('a region is named', time_out('window +rect fraction'), text())
page.type('#regions [data-region=window].definition', 'rect fraction .1 .1 .2 .2')
check('a region is edited as text', time_out('window +rect fraction .1 .1 .2 .2'), text())
before = text()
page.type('#regions [data-region=window].definition', 'rect fraction .1')
check('what is wrong is said and not saved',
      page.until('document.getElementById("regions-say").textContent.includes("needs 4 numbers")') and text() == before)
page.type('#regions [data-region=window].definition', 'rect fraction .1 .1 .3 .3')
time_out('.3 .3')

page.focus('#regions [data-region=window].name')
page.keys('#canvas', Keys.SHIFT, Keys.ARROW_RIGHT)
moved = f'window +rect fraction  {round(.1 + 10 / side, 5):g}'
check('arrow keys move the region that is chosen', time_out(moved), text())
page.click('#undo')
check('that is undone', time_out('window +rect fraction .1 .1 .3 .3'), text())
shown = '''document.querySelector('#regions [data-region=window].definition').value === 'rect fraction .1 .1 .3 .3' '''
check('and shown', page.until(shown))
page.focus('#regions [data-region=window].name')
page.keys('#canvas', Keys.ARROW_RIGHT * 5 + Keys.ARROW_LEFT * 5 + Keys.ARROW_UP * 3)
moved = f'window +rect fraction  0.1 {.1 + 3 / side:.3f}'  # rounded with each key
check('keys that follow one another fast are all taken', time_out(moved), text())
page.keys('#canvas', Keys.ARROW_DOWN * 3)
check('and taken back', near('window +rect fraction', .1, .1, .3, .3), text())

# an answer that comes late is older than what was saved meanwhile
page.js('''(() => { const real = window.fetch; window.late = []; window.fetch = async (what, how) => {
    const answer = await real(what, how);
    if (!String(what).startsWith('/file?') || how?.method) return answer;
    window.late.push('asked');
    await new Promise((r) => setTimeout(r, 400));
    window.late.push('come');
    return answer; }; window.undelayed = () => { window.fetch = real; }; })()''')
page.keys('#canvas', Keys.ARROW_RIGHT)
page.until('late.length > 0')
page.keys('#canvas', Keys.ARROW_RIGHT)
page.until('late.includes("come")')
page.keys('#canvas', Keys.SHIFT, Keys.ARROW_RIGHT)
check('so a change after it fits', near('window +rect fraction', .1 + 12 / side, .1, .3 + 12 / side, .3), text())
page.js('window.undelayed()')
page.keys('#canvas', Keys.SHIFT, Keys.ARROW_LEFT)
page.keys('#canvas', Keys.ARROW_LEFT * 2)
check('and is taken back', near('window +rect fraction', .1, .1, .3, .3), text())
page.drag(size, (side * .3, side * .7), (side * .35, side * .65), (side * .4, side * .6))  # its upper right corner
check('a corner is moved by the pointer', near('window +rect fraction', .1, .1, .4, .4), text())
page.keys('#canvas', Keys.DELETE)
check('Delete deletes it', soon(lambda: 'window' not in text()), text())

# somebody else writes the file
with open(name, 'a') as file: file.write('byhand  circle view 20   # typed in an editor\n')
check('a region that is typed into the file appears', rows(8))
page.chrome.set_network_conditions(latency=1500, download_throughput=1e9, upload_throughput=1e9)
page.focus('#regions [data-region=region1].name')
with open(name, 'a') as file: file.write('another  circle view 30\n')
page.keys('#canvas', Keys.DELETE)
check('a change in the page meets one by hand: both are kept',
      soon(lambda: 'region1' not in text() and 'another  circle view 30\n' in text()), text())
page.focus('#regions [data-region=another].name')
page.js('window.deaf = true')
with open(name) as file: theirs = file.read().replace('another  circle view 30', 'another  circle view 33')
with open(name, 'w') as file: file.write(theirs)
page.keys('#canvas', Keys.DELETE)
check('both have changed the same region: the file stays, and the page says so',
      page.until('document.getElementById("regions-say").textContent.includes("another program")')
      and text() == theirs, text())
check('comments are kept', '# typed in an editor' in text() and
      all(line in text().splitlines() for line in kept), text())
page.js('window.deaf = false')
page.check_keyboard()
page.check_contrast()
page.end()
