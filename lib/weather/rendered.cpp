// SPDX-License-Identifier: BSD-3-Clause
// See rendered.h.
#include "weather/rendered.h"

#include <algorithm>
#include <cstdint>

#include "weather/lines.h"

namespace weather {
namespace {

// Columns of the line of names.
struct Names {
    static constexpr size_t none = SIZE_MAX;
    size_t count = 0, sky = none, view = none, state = none, point = none;

    void read(const Lines& in) {
        count = in.fields();
        for (size_t i = 0; i < count; ++i) {
            const std::string& name = in.field(i, "a name");
            if (name == "sky") sky = i;
            if (name == "view") view = i;
            if (name == "state") state = i;
            if (name == "point" || name == "E") point = i;
        }
        if (sky == none) in.fail("has no column sky with the names of hours (vcmetrics, of ptrace -wea)");
    }
};

}  // namespace

void read_rendered(const std::string& path, Rendered& all) {
    Lines in(path);
    Names names;
    std::string header;
    std::map<Rendered::key_type, std::map<std::string, size_t>> rows;  // and by hour
    size_t most = 1;
    while (in.next()) {
        if (in.text()[0] == '#' || in.text() == header) continue;
        in.split(in.text().find('\t') != std::string::npos ? '\t' : ',');
        if (names.count == 0) {
            names.read(in);
            header = in.text();
            continue;
        }
        if (in.fields() != names.count) in.fail("has fewer columns than the first line: the table was cut off in it");
        const std::string& sky = in.field(names.sky, "the hour");
        if (!parse_name(sky)) in.fail("\"" + sky + "\" is not the name of an hour (0621_1430)");
        const auto name = [&](size_t at) { return at == Names::none ? "" : in.field(at, "a name"); };
        const size_t n = ++rows[{name(names.view), name(names.state)}][sky];
        if (names.point != Names::none) most = std::max(most, n);
    }
    for (const auto& [key, hours] : rows)
        for (const auto& [hour, n] : hours)
            if (n >= most) all[key].insert(hour);
}

}  // namespace weather
