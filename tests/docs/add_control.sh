# SPDX-License-Identifier: BSD-3-Clause
# CONTRIBUTING's recipe "Add a control", followed in a copy of lib/live: `snow`, a checkbox that makes the ground of a
# sky white.  Writes the page's file as CMake does, compiles it by the command of the build, and links a vcview with it.
. "${TOP:?}/tests/lib.sh"
build=${BIN%/bin}
needs cmake ninja vcview mkstream ptaccum python3
[ -f "$build/build.ninja" ] || skip 'not a build of ninja'
mkdir -p tree/lib
cp -r "$TOP/lib/live" tree/lib
cp -r "$TOP/library" tree
cp -r tree before
cd tree || exit 2

# 1. the script
cat > lib/live/page/snow.js << 'END'
// Snow: a ground that reflects more.  What the text of the sky says is shown, whoever has changed it.
import { numbers_in, with_number } from '/model_text.js';

const box = document.getElementById('snow');
const ground = (text) => numbers_in(text).find((n) => n.option === '-g');

export class Snow {
  constructor(sliders) {
    this.sliders = sliders;
    box.addEventListener('change', () => {
      const one = this.file(), value = box.checked ? .7 : .2;
      sliders.choose(one);
      sliders.set(with_number(one.text, ground(one.text), value), false, box.checked ? 'snow' : 'no snow');
    });
  }
  file() { return this.sliders.files.find((one) => ground(one.text)); }
  take() {
    const one = this.file();
    box.parentElement.hidden = !one;
    box.checked = one && ground(one.text).value > .5;
  }
}
END
# 2. its element
element='<label hidden><input id="snow" type="checkbox"> snow</label>'
sed -i "s|^      <div id=.skies. class=.sliders.></div>|&\n      $element|" lib/live/page/index.html
# 3. where it is made, and where it hears of changes
sed -i -e "s|^import { Sources }.*|import { Snow } from '/snow.js';\n&|" \
    -e 's|^const day = new Day(sliders)|const snow = new Snow(sliders);\n&|' \
    -e 's|^  await sliders.take(state.texts);|&\n  snow.take();|' lib/live/page/main.js
# 4. the file
sed -i 's|plot.js pointed.js|snow.js &|' lib/live/CMakeLists.txt

recipe() { sed -n '/^## Add a control/,/^A control that/s/^[0-9]\. `\([a-z]*\/[^`]*\)`.*/\1/p' "$TOP/CONTRIBUTING.md"; }
cd ..
check 'the files that were touched are those of the recipe, and no others' '
    { diff -rq before tree || true; } | sed -E "s|^Only in tree/(.*): |\1/|; s|^Files before/(.*) and .*|\1|" |
        sort > touched
    recipe | sed "s/NAME/snow/" | sort | diff - touched'

# CMake, but for the library: what it writes of the page.
{
    echo 'cmake_minimum_required(VERSION 3.18)'
    echo 'project(page NONE)'
    for step in lux_library target_include_directories; do printf 'function(%s)\nendfunction()\n' $step; done
    echo 'add_subdirectory(lib/live)'
} > tree/CMakeLists.txt
build_commands "$build" vcview > commands
page=$PWD/page/lib/live/page.cpp
check 'a program links with it' '
    cmake -S tree -B page > log 2>&1
    sed -n "s|^[^ ]*ccache ||; s| -MD -MT [^ ]* -MF [^ ]*||; s| -o [^ ]*| -o $PWD/page.o|
        s| -c .*/live/page.cpp\$| -c $page|p" commands | tail -1 > command
    tail -1 commands | sed "s| -o bin/vcview | $PWD/page.o -Wl,-z,muldefs -o $PWD/snowy |" >> command
    (cd "$build" && bash -e "$TMP/command")'

cp "$TOP/examples/scenes/office/sky_day.rad" .
mkstream frames 0 2 | ptaccum -every 1 > sums.str
mkfifo ctl
cat ctl > got & reader=$!
sleep 1000 > ctl & holder=$!
./snowy -stay -control ctl -edit sky_day.rad -- cat < sums.str > rest 2> said & running=$!
for ((k = 0; k < 100; k++)); do ! grep -q http said || break; sleep .1; done
ask() { python3 "$TOP/tests/tools/ask.py" "$@"; }  # METHOD PATH
check 'the page has the control' '
    ask GET / | grep -q "id=.snow"; ask GET /snow.js | grep -q "class Snow"; ask GET /main.js | grep -q "snow.take()"'
if command -v chromedriver > /dev/null && /usr/bin/python3 -c 'import selenium' 2> /dev/null; then
    cat > tick.py << 'END'
import sys
from browser_page import Page, check, failures, link_in, soon
page = Page(link_in('said'))
got = lambda: open('got').read()
box = page.one('#snow')
check('it is not ticked at first', soon(box.is_displayed) and not box.is_selected())
box.click()
check('a tick is an edit', soon(lambda: 'note snow [1]' in got() and ' -g 0.7' in got()), got())
page.one('#undo').click()
check('Undo has its words, and takes it back', soon(lambda: 'note undone: snow' in got()), got())
check('the box says what the text says', soon(lambda: not box.is_selected()))
page.chrome.quit()
sys.exit(failures > 0)
END
    check 'a tick is an edit with its words, which Undo takes back' '
        PYTHONPATH=$TOP/tests/tools PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 tick.py'
fi
kill $running $reader $holder
