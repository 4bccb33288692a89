# SPDX-License-Identifier: BSD-3-Clause
# A headless Chromium on the page of vcview, and sentences that must hold: what browser*.py share.
#   The page answers when it can: what follows an action waits for what it needs (soon, one, click, keys).  SLOW=8 makes
#   the browser that much slower and each answer 50 ms late for each, to find what does not.
import json, os, re, sys, time, urllib.request
from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

failures = 0


def check(sentence, true, more=''):
    global failures
    failures += not true
    print('ok' if true else 'not ok', '-', sentence, '' if true else more)


def link_in(name):
    return re.search(r'http://\S+', open(name).read())[0]


def soon(question, seconds=20):
    """Until question() is true, or not.  What is not there yet, or no more, is no answer."""
    end = time.time() + seconds
    while True:
        try:
            if question(): return True
        except (WebDriverException, LookupError):
            pass
        if time.time() > end: return False
        time.sleep(.05)


# Answers to /next wait while the window is deaf.
DEAF = """const ask = window.fetch; window.fetch = async (path, ...more) => {
    const answer = await ask(path, ...more);
    while (window.deaf && String(path).startsWith('/next')) await new Promise((go) => setTimeout(go, 20));
    return answer;
};"""


class Page:
    def __init__(self, link, width=1280, height=1000):
        options = webdriver.ChromeOptions()
        for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', f'--window-size={width},{height}'):
            options.add_argument(argument)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
        self.chrome = webdriver.Chrome(options=options)
        self.link = link
        self.chrome.execute_cdp_cmd('Page.addScriptToEvaluateOnNewDocument', {'source': DEAF})
        slow = int(os.environ.get('SLOW', 1))
        if slow > 1:
            self.chrome.execute_cdp_cmd('Emulation.setCPUThrottlingRate', {'rate': slow})
            self.chrome.set_network_conditions(latency=50 * slow, download_throughput=1e9, upload_throughput=1e9)
        self.chrome.get(link)

    def js(self, script, *arguments):
        return self.chrome.execute_script('return ' + script, *arguments)

    def until(self, script, seconds=30):
        return soon(lambda: self.js(script), seconds)

    def find(self, css):
        return self.chrome.find_elements(By.CSS_SELECTOR, css)

    def one(self, css, words='', does=lambda e: True, seconds=30):
        """The first element of a selector, with these words (or among its words), which does it: when there is one."""
        found = []

        def done():
            all = self.find(css)
            found[:] = [e for e in all if not words or words in e.text]
            found.sort(key=lambda e: words != '' and e.text != words)
            return found and does(found[0]) is not False
        if not soon(done, seconds): raise LookupError(f'{css} {words}: none, or none that can be used')
        return found[0]

    def click(self, css, words=''):
        def press(e):
            self.chrome.execute_script('arguments[0].scrollIntoView({block: "center"})', e)
            return e.is_displayed() and e.is_enabled() and e.click() is None
        return self.one(css, words, press)

    def keys(self, css, *keys):
        return self.one(css, '', lambda e: e.is_displayed() and e.is_enabled() and e.send_keys(*keys) is None)

    def type(self, css, words, *keys):
        self.keys(css, Keys.CONTROL + 'a' + Keys.NULL, words, *keys or [Keys.TAB])

    def focus(self, css):
        self.one(css, '', lambda e: self.js('arguments[0].focus() || document.activeElement === arguments[0]', e))

    def text(self, css):
        return self.js('document.querySelector(arguments[0]).innerText', css)

    def rows(self, css):
        """Words in the cells of a table's rows; fields have their value."""
        return self.js("""[...document.querySelectorAll(arguments[0] + ' tbody tr')].map((r) => [...r.cells].map((c) =>
            c.querySelector('input')?.value ?? c.innerText))""", css)

    def menu(self, name):
        """Opens a menu of the bar above the picture; another one, which may cover it, is closed."""
        self.chrome.execute_script("""document.querySelectorAll('.menu[open]').forEach((m) => {
            m.open = m.firstElementChild.textContent === arguments[0]; })""", name)
        if name not in [s.text for s in self.find('.menu[open] > summary')]: self.click('.menu > summary', name)

    def pixel_to_canvas(self, x, y, width, height):
        """From pixels (y from the top) to offsets from the middle of the canvas, as it shows the whole picture."""
        box = self.one('#canvas').size
        scale = min(box['width'] / width, box['height'] / height)
        return (x - width / 2) * scale, (y - height / 2) * scale

    def drag(self, size, *places, release=True):
        """The pointer from pixel to pixel of the picture, pressed."""
        canvas = self.one('#canvas')
        self.chrome.execute_script('arguments[0].scrollIntoView({block: "center"})', canvas)
        actions = ActionChains(self.chrome, duration=30)
        for k, place in enumerate(places):
            x, y = self.pixel_to_canvas(*place, *size)
            actions.move_to_element_with_offset(canvas, round(x), round(y))
            if k == 0: actions.click_and_hold()
        if release: actions.release()
        actions.perform()

    def click_at(self, size, *places):
        for place in places: self.drag(size, place)

    def ask(self, path, method='GET', body=None, **headers):
        """A question past the page: status, text, headers."""
        host, token = re.match(r'(http://[^/]+)/#(\w+)', self.link).groups()
        request = urllib.request.Request(host + path, data=body, method=method,
                                         headers={'X-Luxpipe-Token': token, **headers})
        try:
            with urllib.request.urlopen(request, timeout=30) as answer:
                return answer.status, answer.read(), answer.headers
        except urllib.error.HTTPError as e:
            return e.code, e.read(), e.headers

    def fits(self):
        return self.js('document.documentElement.scrollWidth <= document.documentElement.clientWidth')

    def resize(self, width, height):
        self.chrome.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': width, 'height': height, 'deviceScaleFactor': 1, 'mobile': False})
        time.sleep(.3)

    def check_keyboard(self):
        """The tab key reaches all that can be used, in the order of the page, and shows where it is."""
        stops = """[...document.querySelectorAll('button, select, input, summary, a[href], [tabindex="0"]')]
            .filter((e) => !e.disabled && e.tabIndex >= 0 && e.checkVisibility())"""
        for _ in range(9):  # hours of the day, say, may come while we look
            wanted = self.js(f'(window.all = {stops}).length')
            ActionChains(self.chrome).send_keys(Keys.TAB).perform()  # whoever uses keys sees the focus
            self.chrome.execute_script('all[0].focus()')
            seen, outlined = [], 0
            for k in range(wanted + 5):
                if k: ActionChains(self.chrome).send_keys(Keys.TAB).perform()
                k = self.js('all.indexOf(document.activeElement)')
                if k < 0: break
                seen.append(k)
                outlined += self.js('getComputedStyle(document.activeElement).outlineStyle !== "none"')
            if self.js(f'((now) => now.length === all.length && now.every((e, k) => e === all[k]))({stops})'): break
        check('the tab key reaches all that can be used, in the order of the page', seen == list(range(wanted)),
              (wanted, seen, self.js('all.filter((e, k) => !arguments[0].includes(k)).map((e) => e.outerHTML)', seen)))
        check('what has the focus is outlined', outlined == len(seen), (outlined, len(seen)))

    def check_contrast(self):
        """Text stands out from what is behind it by WCAG 2.2, 1.4.3 (AA), and borders of what can be used, and of the
        bands of intervals, by 1.4.11; in light and in dark."""
        for scheme in ('light', 'dark'):
            self.chrome.execute_cdp_cmd('Emulation.setEmulatedMedia',
                                        {'features': [{'name': 'prefers-color-scheme', 'value': scheme}]})
            poor = self.js("""((all) => all.filter(([ratio]) => ratio < 4.5))((() => {
                const numbers = (c) => c.match(/[\\d.]+/g).map(Number), clear = (c) => numbers(c)[3] === 0;
                const light = (c) => numbers(c).slice(0, 3).map((v) => v / 255)
                    .map((v) => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4)
                    .reduce((sum, v, k) => sum + v * [.2126, .7152, .0722][k], 0);
                return [...document.querySelectorAll('body *')].filter((e) => e.offsetParent && !e.disabled &&
                    [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim())).map((e) => {
                    let behind = e;
                    const ground = () => getComputedStyle(behind).backgroundColor;
                    while (behind !== document.body && clear(ground())) behind = behind.parentElement;
                    const [a, b] = [light(getComputedStyle(e).color), light(ground())].sort((p, q) => q - p);
                    return [(a + .05) / (b + .05), e.outerHTML.slice(0, 80)];
                });
            })())""")
            check(f'text is readable in {scheme}', not poor, poor)
            poor = self.js("""[...document.querySelectorAll('button, select, input, .panel, .interval')]
                .filter((e) => e.checkVisibility() && !e.disabled && e.type !== 'range' && e.type !== 'radio' &&
                    e.type !== 'checkbox' && !e.hasAttribute('aria-pressed')).map((e) => {
                    const light = (c) => c.match(/[\\d.]+/g).slice(0, 3).map((v) => v / 255)
                        .map((v) => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4)
                        .reduce((sum, v, k) => sum + v * [.2126, .7152, .0722][k], 0);
                    const css = getComputedStyle(e);
                    const edge = light(e.matches('.interval') ? css.stroke : css.borderTopColor);
                    let behind = e.parentElement;
                    while (behind !== document.body && /, 0\\)$/.test(getComputedStyle(behind).backgroundColor))
                        behind = behind.parentElement;
                    const [a, b] = [edge, light(getComputedStyle(behind).backgroundColor)].sort((p, q) => q - p);
                    return [(a + .05) / (b + .05), e.outerHTML.slice(0, 80)];
                }).filter(([ratio]) => ratio < 3)""")
            check(f'borders and bands stand out in {scheme}', not poor, poor)
        self.chrome.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': []})

    def errors(self):
        return [e['message'] for e in self.chrome.get_log('browser')
                if e['level'] == 'SEVERE' and 'Failed to load resource' not in e['message']]

    def end(self):
        found = self.errors()
        check('the console has no errors', not found, found)
        self.chrome.quit()
        sys.exit(failures > 0)
