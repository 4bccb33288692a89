# SPDX-License-Identifier: BSD-3-Clause
# Two windows on one design, reloads, a broken scene, a lost network, a killed tracer: browser_design.py LINK VCVIEW
#   LINK: what vcview printed; VCVIEW: the process whose ptrace is killed at the end.
import os, re, signal, subprocess, sys, time
from selenium.webdriver.common.keys import Keys
from browser_page import Page, check, link_in, soon

page = Page(link_in(sys.argv[1]))
chrome, SECONDS = page.chrome, 90
text = page.text
slats = lambda: page.js('[...document.querySelectorAll("#model-text button")].map((b) => b.textContent)')
names = lambda: [row[0] for row in page.rows('#edits')]
windows = [chrome.current_window_handle]
runs = lambda: re.match('running|settled', text('#state'))


def window(k):
    chrome.switch_to.window(windows[k])


def lower(number):
    """The slider of this number goes to its end."""
    page.click('#model-text button', number)
    page.keys('#model-number input[type=range]', Keys.END)


classes = 'imperceptible|perceptible|disturbing|intolerable'
check('the verdict is a class in words, with a sign, a number and its interval',
      soon(lambda: re.fullmatch(rf'[○◔◑●] (({classes}) to )?({classes})', text('#verdict')) and
           re.fullmatch(r'DGPf \.\d{3} \(\.\d{3} to \.\d{3}\)', text('#glare')), SECONDS), text('header'))
check('and what the programs do', soon(lambda: runs(), SECONDS), text('#state'))
check('it is in sight wherever the page stands', page.js(
    'window.scrollTo(0, 9999), document.getElementById("verdict").getBoundingClientRect().top >= 0'))
page.js('window.scrollTo(0, 0)')

# one screen, and the keyboard
box = lambda css: page.js('document.querySelector(arguments[0]).getBoundingClientRect().bottom', css)
one_screen = '''document.documentElement.scrollHeight <= innerHeight &&
    ((c) => Math.abs(c.width / c.height - 1) < .02)(document.getElementById("canvas"))'''
for width, height in ((1440, 900), (844, 390), (720, 450)):  # the last: 1440 x 900 at 200 %
    page.resize(width, height)
    check(f'all is on one screen of {width} x {height}, and the picture has no bars', soon(
        lambda: page.fits() and box('#legend') <= height and page.js(one_screen)), box('#legend'))
page.resize(1920, 1080)
sides = lambda: page.js('''["#canvas", "#side"].map((css) => document.querySelector(css).getBoundingClientRect())
    .map(({ left, right }) => [left, right])''')
check('a square picture leaves no strip beside it', soon(lambda: 0 < sides()[1][0] - sides()[0][1] < 20), sides())
page.resize(390, 800)
check('a telephone has the picture in its upper half', soon(lambda: box('#picture > .bar') < 170 and
                                                           page.fits()), box('#picture > .bar'))
page.js('window.scrollTo(0, 9999)')
check('at 390 pixels the picture stays in sight', soon(lambda: page.fits() and 0 < box('#canvas') < 800),
      box('#canvas'))
chrome.execute_cdp_cmd('Emulation.clearDeviceMetricsOverride', {})
stops = page.js("""[...document.querySelectorAll('button, select, input, summary, a[href], [tabindex="0"]')]
    .filter((e) => !e.disabled && e.tabIndex >= 0 && e.checkVisibility()).map((e) => e.id)""")
check('no more than 20 stops of the tab key lead to the regions', 0 < stops.index('draw-circle') < 20, stops)
heard = page.js("""(window.heard = 0, new MutationObserver(() => heard++).observe(document.getElementById('verdict'),
    { childList: true, characterData: true, subtree: true }), document.body.dataset.picture)""")
check('the verdict is announced where it changes, not with each picture', soon(
    lambda: int(page.js('document.body.dataset.picture')) > int(heard) + 3) and page.js('heard') <= 1, page.js('heard'))

# a change, and a reload
lower('20')
check('a blind is lowered', soon(lambda: 'blind.rad: 20 → 40' in names(), SECONDS), names())
chrome.refresh()
check('after a reload the page shows what is rendered', soon(lambda: '40' in slats() and '20' not in slats(), SECONDS),
      slats())
check('edits keep their names', soon(lambda: 'blind.rad: 20 → 40' in names(), SECONDS), names())

# a second window
chrome.switch_to.new_window('tab')
windows.append(chrome.current_window_handle)
chrome.get(page.link)
check('a second window shows the same', soon(lambda: '40' in slats() and 'blind.rad: 20 → 40' in names(), SECONDS),
      (slats(), names()))
check('Undo says what it takes back', soon(lambda: 'blind.rad: 20 → 40' in page.one('#undo').get_attribute('title')))
page.click('#undo')
check('which can undo it', soon(lambda: '20' in slats()), slats())
check('and Redo what it makes again', soon(lambda: 'blind.rad: 20 → 40' in page.one('#redo').get_attribute('title')))
window(0)
check('the first one follows', soon(lambda: '20' in slats() and 'undone: blind.rad: 20 → 40' in names(), SECONDS),
      (slats(), names()))

# a change of what is no more: this window hears nothing for a while
page.js('window.deaf = true')
body = open('blind.rad').read().replace('-a 20', '-a 30')
version = page.ask('/overlay?n=1')[2].get('ETag').strip('"')
check('another window is faster',
      page.ask(f'/overlay?n=1&version={version}&said=faster', 'POST', body.encode())[0] == 200)
lower('20')
check('a stale change is refused, and shown',
      soon(lambda: 'not taken: blind.rad: 20 → 40' in text('#messages')), text('#messages'))
check('the page shows the other one', soon(lambda: '30' in slats()), slats())
chrome.refresh()
soon(lambda: '30' in slats(), SECONDS)

# a broken scene
version = page.ask('/overlay?n=1')[2].get('ETag').strip('"')
page.ask(f'/overlay?n=1&version={version}&said=broken', 'POST', b'void plastic\n')
check('what is wrong in the scene is said in the page',
      soon(lambda: 'ptrace: blind.rad:' in text('#messages'), SECONDS), text('#messages'))
page.click('#undo')
check('as long as it is so', soon(lambda: not text('#messages'), SECONDS), text('#messages'))

# variants
variants = lambda: page.rows('#variants')
page.keys('body', 'k')
check('k keeps the design as a variant, which is the base', soon(
    lambda: len(variants()) == 1 and page.one('#variants input[type=radio]').is_selected()), variants())
check('with its number', soon(lambda: re.match(r'DGPf \.\d{3} \(', variants()[0][2]), SECONDS), variants())
lower('30')
check('the base stands beside each change', soon(
    lambda: '30 → ' in names()[0] and any('A (base)' in n for n in names()), SECONDS), names())
rows = lambda: [' '.join(row) for row in page.rows('#edits')]
check('with which changes are compared', soon(
    lambda: re.search('better|worse|lower|higher|not told', rows()[0]), SECONDS), rows())
page.keys('body', 'k')
page.type('#variants tbody tr:nth-child(2) .name', 'low blind')
check('it is given a name', soon(lambda: variants()[1][1] == 'low blind'), variants())
page.keys('#compare', 'side')
halves = lambda: page.js("""((c) => [.25, .75].map((x) => [...c.getContext('2d').getImageData(x * c.width,
    c.height / 2, 1, 1).data].slice(0, 3).join(' ')))(document.getElementById('canvas'))""")
for name in ('A', Keys.DELETE):
    page.type('#variants tbody tr:nth-child(2) .name', name)
    check('another one must be its own, which is told', soon(
        lambda: 'a name of its own' in text('#messages') and variants()[1][1] == 'low blind'), variants())
    page.click('#messages button')
check('two variants stand side by side in one scale', soon(lambda: len(set(halves())) == 2), halves())
page.click('#variants tbody tr:nth-child(1) button')
check('a variant is shown by one action', soon(lambda: '30' in slats() and names()[0].startswith('A'), SECONDS),
      (slats(), names()))
chrome.refresh()
check('variants outlive a reload', soon(lambda: [v[1] for v in variants()] == ['A', 'low blind'], SECONDS), variants())
check('and can be shown again', soon(
    lambda: page.one('#variants tbody tr:nth-child(2) button').is_enabled(), SECONDS))

# views
page.keys('#canvas', 'w')
check('a step is an edit', soon(lambda: names()[0].startswith('view'), SECONDS), names())
check('Back can be used', soon(lambda: page.one('#back').is_enabled()))
page.menu('View')
page.click('#back')
check('Back goes back', soon(lambda: names()[0] == 'view' and names()[1].startswith('view'), SECONDS), names())
check('to the first view', soon(lambda: not page.one('#back').is_enabled(), SECONDS))

# the network goes and comes back
chrome.execute_cdp_cmd('Network.enable', {})
chrome.execute_cdp_cmd('Network.emulateNetworkConditions',
                       {'offline': True, 'latency': 0, 'downloadThroughput': -1, 'uploadThroughput': -1})
check('a lost connection is said', soon(lambda: 'lost' in text('#state'), SECONDS), text('#state'))
chrome.execute_cdp_cmd('Network.emulateNetworkConditions',
                       {'offline': False, 'latency': 0, 'downloadThroughput': -1, 'uploadThroughput': -1})
check('and comes back by itself', soon(lambda: 'lost' not in text('#state'), SECONDS), text('#state'))

# a variant is deleted, and comes back
page.click('#variants tbody tr:nth-child(2) button', '×')
check('a variant is deleted by a click', soon(lambda: [v[1] for v in variants()] == ['A']), variants())
page.click('#undo')
check('and comes back by another', soon(lambda: [v[1] for v in variants()] == ['A', 'low blind']), variants())
page.click('#base-before')
check('edits are compared with the one before again', soon(lambda: 'edit before' in text('#edits-say')))

# letters on a row are nobody's
page.focus('#table tbody tr')
before = names()
page.keys('#table tbody tr', 'w', 'k')
time.sleep(1)
check('a letter on a row walks nowhere and keeps nothing', names() == before and len(variants()) == 2, names())


# the tracer is killed
def kill():
    ps = lambda *of: subprocess.run(['ps', *of], capture_output=True, text=True).stdout
    own = ps('-p', sys.argv[2], '-o', 'ni=').strip()  # the tracers of hours and plan have less right to the processor
    all = [line.split() for line in ps('--ppid', sys.argv[2], '-o', 'ni=,pid=,comm=').splitlines()]
    newest = [int(pid) for nice, pid, name in all if nice == own and name == 'ptrace']
    return newest and os.kill(newest[0], signal.SIGKILL) is None


begun = len(names())
kill()
check('a program that dies is named and started again', soon(
    lambda: 'ptrace was ended by signal 9' in page.one('#all-messages').get_attribute('textContent') and
    runs(), SECONDS), text('#state'))
check('with the design', soon(lambda: len(names()) > begun and '30' in slats(), SECONDS), names())
soon(kill)
check('the end of the programs is said', soon(lambda: 'have ended' in text('#state'), SECONDS), text('#state'))
page.click('#again')
check('a click starts them again', soon(runs, SECONDS), text('#state'))
check('what was typed is there', soon(lambda: '30' in slats()), slats())
page.click('#model-save')
check('and can be saved', soon(lambda: '-a 30 ' in open('blind.rad').read()))
check('as can the picture', page.ask('/save?as=exr')[1][:4] == b'\x76\x2f\x31\x01')
page.errors()  # of the network
page.end()
