# SPDX-License-Identifier: BSD-3-Clause
# A report of vcmetrics -report in Chromium: browser_report.py FILE
import base64, os, re, sys
from browser_page import Page, check

page = Page('file://' + os.path.abspath(sys.argv[1]))
check('it has its heading', page.one('h1').text == 'Glare report')
verdict = page.one('.verdict').text
check('the class stands first', re.match(r'Glare is (im)?perceptible', verdict), verdict)
check('both pictures are drawn', page.until("""[...document.querySelectorAll('svg image')].length === 2 &&
    [...document.querySelectorAll('svg image')].every((i) => i.getBoundingClientRect().width > 200)"""))
check('regions and sources are named in each', page.js("""[...document.querySelectorAll('figure')].every((f) =>
    ['desk', 'screen_low'].every((n) => [...f.querySelectorAll('text.region')].some((t) => t.textContent === n)) &&
    f.querySelectorAll('text.source').length > 1)"""))
check('names do not cover one another', page.js("""(() => {
    const boxes = [...document.querySelector('figure').querySelectorAll('text')].map((t) => t.getBoundingClientRect());
    return boxes.every((a, i) => boxes.every((b, k) => i <= k || a.right < b.left || b.right < a.left ||
        a.bottom < b.top + 4 || b.bottom < a.top + 4));
})()"""))
check('nothing was loaded', page.js('''performance.getEntriesByType("resource")
    .filter((e) => !e.name.startsWith("data:")).length''') == 0)
check('text is readable', page.js("""[...document.querySelectorAll('td, p, dd, th')].every((e) =>
    parseFloat(getComputedStyle(e).fontSize) >= 8)"""))
page.resize(390, 844)
check('it fits a narrow window', page.fits(), page.js('document.documentElement.scrollWidth'))
page.resize(1280, 1000)
printed = page.chrome.execute_cdp_cmd('Page.printToPDF', {'preferCSSPageSize': True, 'printBackground': True})
pdf = base64.b64decode(printed['data'])
pages = len(re.findall(rb'/Type\s*/Page\b', pdf))
check('it is two pages', pages == 2, pages)
check('of A4', re.search(rb'/MediaBox\s*\[\s*0 0 59[456][\d.]* 84[12]', pdf), re.findall(rb'/MediaBox[^]]*', pdf)[:1])
page.end()
