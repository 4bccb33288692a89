# SPDX-License-Identifier: BSD-3-Clause
# The page of luxpipe-live while ptrace renders: browser_live.py LINK LINES SIZE
#   LINK: what vcview printed; LINES: the table that vcmetrics writes; SIZE: sides of the square picture.
import re, sys
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

lines, size = sys.argv[2], (int(sys.argv[3]),) * 2
page = Page(link_in(sys.argv[1]))
SECONDS = 90  # for a machine with other work
names = lambda: [row[0] for row in page.rows('#table')]
edits = lambda: page.rows('#edits')  # newest first: [name, frames, Ev ...]


def told_apart(name, at=0):
    """Has the edit of this name, in this place of the table, a difference of Ev with its interval?"""
    def found():
        rows = edits()
        difference = r' to [+−][\d.e+]+\) *(not told|higher|lower)'
        return len(rows) > at and name in rows[at][0] and re.search(difference, rows[at][2])
    return soon(found, SECONDS)


check('a picture and its numbers come', page.until(
    'document.body.dataset.picture > 0 && document.body.dataset.lines > 3', SECONDS))
page.js('document.getElementById("edits-more").click()')  # Ev, too
check('there is no column of a region yet', not any('TAL' in n for n in names()), names())

page.keys('#canvas', 'w')
check('a step ahead is an edit, compared with what was before', told_apart('view'), edits())
check('it was seen in a preview', page.until('performance.getEntriesByName("preview").length > 0'))

hour = '#skies label:nth-of-type(2) input'
page.keys(hour, Keys.ARROW_LEFT)
check('the sun is moved, and the light at the eye differs', told_apart('21 Dec 13:45'), edits())
page.chrome.execute_script('''
    const slide = (type, value) => {
        arguments[0].value = value;
        arguments[0].dispatchEvent(new Event(type, { bubbles: true }));
    };
    for (let k = 0; k < 12; k++) setTimeout(() => slide('input', 13 - k / 4), 60 * k);
    setTimeout(() => slide('change', 10.25), 900);''', page.one(hour))
check('a slider that is dragged is one edit', told_apart('21 Dec 10:15') and soon(lambda: len(edits()) == 4), edits())

page.js('document.getElementById("model-file").selectedIndex = 1')
page.chrome.execute_script('document.getElementById("model-file").dispatchEvent(new Event("change"))')
page.click('#model-text button', '20')
check('slats are counted', page.find('#model-number input[type=range][step="1"][min="1"]'))
page.keys('#model-number input[type=range]', Keys.END)
check('a blind is lowered', told_apart('blind.rad: 20 → 40') and soon(lambda: len(edits()) == 5), edits())
check('which is written to no file yet', '-a 20 ' in open('blind.rad').read())
page.click('#undo')
check('and undone', soon(lambda: len(edits()) == 6, SECONDS), edits())

page.click('#draw-circle')
page.drag(size, (size[0] * .5, size[1] * .7), (size[0] * .55, size[1] * .7), (size[0] * .65, size[1] * .7))
check('a region that is drawn is measured', soon(lambda: any(n == 'region1.TAL' for n in names()), SECONDS), names())
page.click('#draw-rect')
page.drag(size, (size[0] * .2, size[1] * .6), (size[0] * .25, size[1] * .65), (size[0] * .4, size[1] * .75))
check('two regions offer a contrast ratio', soon(lambda: page.one('#contrast').is_displayed(), SECONDS))
for which, region in (('low', 'region1'), ('high', 'region2')):
    page.one(f'#contrast-{which} option[value="{region}"]')
    page.chrome.execute_script(f"""const of = document.getElementById('contrast-{which}');
        of.value = '{region}'; of.dispatchEvent(new Event('change'));""")
    check(f'{region} is chosen', soon(lambda: re.search(rf'(?m)^{which} +{region}$', open('my.regions').read())),
          open('my.regions').read())
ratio = lambda: [float(v) for name, *values in page.rows('#table') if name == 'low/high.CR' for v in values
                 if re.match(r'[\d.]+$', v)]
check('it has an interval', soon(lambda: 0 < ratio()[1] <= ratio()[2], SECONDS), page.rows('#table'))
plots = lambda: page.js('[...document.querySelectorAll("#plots figcaption")].map((c) => c.innerText)')
check('and a plot', soon(lambda: 'low/high.CR' in plots()), plots())
check('the page shows what vcmetrics writes', soon(lambda: page.js('document.body.dataset.lines')
                                                  == str(len(open(lines).read().splitlines())), SECONDS))
page.click('#sources-panel summary')
check('glare sources are listed', page.until('document.querySelectorAll("#sources tbody tr").length > 0', SECONDS))
page.menu('Save')
page.keys('#command-text', 'pause', Keys.ENTER)
check('a word is obeyed', soon(lambda: page.js('document.getElementById("command-text").value') == ''))
page.end()
