# SPDX-License-Identifier: BSD-3-Clause
# A headless Chromium on the page of vcview, and sentences that must hold: what browser*.py share.
import json, re, sys, time, urllib.request
from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

failures = 0


def check(sentence, true, more=''):
    global failures
    failures += not true
    print('ok' if true else 'not ok', '-', sentence, '' if true else more)


def link_in(name):
    return re.search(r'http://\S+', open(name).read())[0]


def soon(question, seconds=20):
    """Until question() is true, or not."""
    end = time.time() + seconds
    while time.time() < end:
        if question(): return True
        time.sleep(.05)
    return False


class Page:
    def __init__(self, link, width=1280, height=1000):
        options = webdriver.ChromeOptions()
        for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', f'--window-size={width},{height}'):
            options.add_argument(argument)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
        self.chrome = webdriver.Chrome(options=options)
        self.link = link
        self.chrome.get(link)

    def js(self, script, *arguments):
        return self.chrome.execute_script('return ' + script, *arguments)

    def until(self, script, seconds=30):
        return soon(lambda: self.js(script), seconds)

    def find(self, css):
        return self.chrome.find_elements(By.CSS_SELECTOR, css)

    def one(self, css):
        return self.chrome.find_element(By.CSS_SELECTOR, css)

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

    def click(self, size, *places):
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

    def errors(self):
        return [e['message'] for e in self.chrome.get_log('browser')
                if e['level'] == 'SEVERE' and 'Failed to load resource' not in e['message']]

    def end(self):
        found = self.errors()
        check('the console has no errors', not found, found)
        self.chrome.quit()
        sys.exit(failures > 0)
