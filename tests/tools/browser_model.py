# SPDX-License-Identifier: BSD-3-Clause
# Camera, sliders and the table of edits in the page of vcview: browser_model.py LINK GOT SIZE
#   LINK: what vcview printed; GOT: what arrives in the FIFO; SIZE: sides of the square picture.
import re, sys
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

size = (int(sys.argv[3]),) * 2
page = Page(link_in(sys.argv[1]))
got = lambda: open(sys.argv[2]).read()
arrives = lambda words: soon(lambda: re.search(words, got()))
numbers = lambda line: [float(v) for v in re.findall(r'-?[\d.]+(?:e-?\d+)?', line)]

# before and after, as the program's columns say it
check('there is a row for each edit', page.until('document.querySelectorAll("#edits tbody tr").length == 4'))
rows = [row.text for row in page.find('#edits tbody tr')]
check('less glare is better', 'better' in rows[0] and '−0.05' in rows[0], rows[0])
check('more glare is worse', 'worse' in rows[1], rows[1])
check('an interval that holds 0 tells nothing apart', 'not told apart yet' in rows[2], rows[2])
check('illuminance is higher or lower', 'lower' in rows[1] and 'higher' in rows[0], rows)
check('earlier edits are ghosts in the plots', len(page.find('#plots figure:first-child path.ghost')) == 3)
check('the stop is marked', len(page.find('#plots figure:first-child line.stop')) == 1)

# camera
page.until('document.body.dataset.picture > 0')
canvas = page.one('#canvas')
canvas.send_keys('w')
# at rest the full picture is asked for; a drag before that would replace it
check('w walks ahead', arrives(r'(?m)^view -vp 2 2\.[0-9]+ 1\.[0-9]+ -vd 0 -0\.99'), got())
page.one('#drag').send_keys('look')
page.drag(size, (size[0] * .5, size[1] * .5), (size[0] * .55, size[1] * .5), (size[0] * .6, size[1] * .5))
views = lambda: re.findall(r'^view -vp (.*) -vd (.*)$', got(), re.M)
check('dragging looks around: what was held stays under the pointer', soon(
    lambda: len(views()) >= 2 and abs(abs(numbers(views()[-1][1])[0]) - .309) < .02), views())
page.one('#drag').send_keys('orbit')
page.drag(size, (size[0] * .5, size[1] * .5), (size[0] * .6, size[1] * .5), (size[0] * .75, size[1] * .5))
check('dragging turns around what is ahead',
      soon(lambda: len(views()) >= 3 and abs(numbers(views()[-1][0])[0] - 2) > .3))
field = page.one('#command-text')
field.send_keys('aim 2 1 1', Keys.ENTER)
check('words pass to the renderer', arrives(r'(?m)^aim 2 1 1$'), got())

# sliders
check('skies have sliders for day and hour', len(page.find('#skies input')) == 2)
hour = page.find('#skies input')[1]
hour.send_keys(Keys.ARROW_RIGHT)
check('the hour arrives as a text for the file',
      arrives(r'overlay sky.rad \d+\n# a sky\n!gensky 12 21 14.25 \+s'), got())
number = [b for b in page.find('#model-text button') if b.text == '.2'][0]
number.click()
page.one('#model-number input[type=number]').send_keys(Keys.CONTROL + 'a' + Keys.NULL, '.35', Keys.TAB)
check('any number is changed', arrives(r'14\.25 \+s .* -g 0\.35\n'), got())
check('nothing is saved before it is asked for', '-g .2' in open('sky.rad').read())
sizes = [(int(n), len(t)) for n, t in
         re.findall(r'overlay sky.rad (\d+)\n((?:# a sky\n).*?)(?=overlay|view|preview|go|\Z)', got(), re.S)]
check('texts have the length that is announced', sizes and all(n == m for n, m in sizes), sizes)
page.one('#model-undo').click()
check('that is undone', soon(lambda: re.findall(r'-g (\S+)\n', got())[-1] == '.2'))
page.one('#model-save').click()
check('saved on demand', soon(lambda: '14.25 +s' in open('sky.rad').read()))

page.check_keyboard()
page.check_contrast()
for w in (1280, 390):
    page.resize(w, 900)
    check(f'nothing is wider than a page of {w} pixels', page.fits())
page.end()
