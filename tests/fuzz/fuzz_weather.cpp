// SPDX-License-Identifier: BSD-3-Clause
// Weather files, and the words and files that choose hours: the first line chooses, the rest is the weather.
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "scene/object.h"
#include "weather/choose.h"
#include "weather/sky.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const size_t end = std::min(text.find('\n'), text.size());
    write_alone("t.epw", text.substr(std::min(end + 1, text.size())));
    try_to([&] {
        const weather::Weather w = weather::read_weather("t.epw");
        const weather::Choice c = weather::choose_hours(w, text.substr(0, end));
        const weather::Hour& h = w.hours.at(c.hours.at(0));
        if (const auto light = weather::light_of(w, h)) scene::read_scene({weather::sky_text(w, h, *light)}, {});
    });
    return 0;
}
