// SPDX-License-Identifier: BSD-3-Clause
// Trials of break_files with the windows of OpenEXR pictures.  The file is written here, uncompressed, by the published
// layout of OpenEXR 2.0; it must measure as a RADIANCE picture of the pixels in its display window, where the data
// window does not reach black and told of, or be refused where the windows have nothing in common.
#include <cmath>
#include <cstring>
#include <sstream>

#include "file_trials.h"
#include "stream_model.h"

namespace breaking {
namespace {

struct Window {
    int x0, y0, x1, y1;
    bool is_empty() const { return x1 < x0 || y1 < y0; }
    bool holds(int64_t x, int64_t y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

template <class T>
void put(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);  // little endian, as the machines that we test are
}

void attribute(std::string& bytes, const std::string& name, const std::string& type, const std::string& value) {
    bytes += name + '\0' + type + '\0';
    put(bytes, int32_t(value.size()));
    bytes += value;
}

std::string box(const Window& w) {
    std::string bytes;
    for (int n : {w.x0, w.y0, w.x1, w.y1}) put(bytes, n);
    return bytes;
}

float value_at(int x, int y, int channel) {
    return float((unsigned(x) * 7 + unsigned(y) * 13 + unsigned(channel) * 5) % 97 + 1);
}

// Channels B G R of the data window; `lines`: of so many, where the window claims too many to be written.
std::string exr(const Window& data, const Window& shown, int lines, bool downward) {
    std::string bytes("\x76\x2f\x31\x01\x02\0\0\0", 8), channels, primaries, one, centre;
    for (const char* name : {"B", "G", "R"}) {
        channels += name + std::string(1, '\0');
        put(channels, int32_t(2));  // float
        put(channels, int32_t(0));
        put(channels, int32_t(1)), put(channels, int32_t(1));
    }
    channels += '\0';
    put(one, 1.f), put(centre, 0.f), put(centre, 0.f);
    attribute(bytes, "channels", "chlist", channels);
    for (const float value : {.64f, .33f, .29f, .6f, .15f, .06f, 1 / 3.f, 1 / 3.f})
        put(primaries, value);  // RADIANCE's
    attribute(bytes, "chromaticities", "chromaticities", primaries);
    attribute(bytes, "compression", "compression", std::string(1, '\0'));
    attribute(bytes, "dataWindow", "box2i", box(data));
    attribute(bytes, "displayWindow", "box2i", box(shown));
    attribute(bytes, "lineOrder", "lineOrder", std::string(1, downward ? '\1' : '\0'));
    attribute(bytes, "pixelAspectRatio", "float", one);
    attribute(bytes, "screenWindowCenter", "v2f", centre);
    attribute(bytes, "screenWindowWidth", "float", one);
    attribute(bytes, "VIEW", "string", "-vta -vh 180 -vv 180");
    bytes += '\0';
    const int width = data.is_empty() || lines == 0 ? 0 : data.x1 - data.x0 + 1;
    const size_t line_bytes = 8 + size_t(width) * 12, start = bytes.size() + size_t(lines) * 8;
    for (int k = 0; k < lines; ++k) put(bytes, uint64_t(start + line_bytes * size_t(downward ? lines - 1 - k : k)));
    for (int k = 0; k < lines; ++k) {
        const int y = data.y0 + (downward ? lines - 1 - k : k);
        put(bytes, int32_t(y));
        put(bytes, int32_t(width * 12));
        for (int channel = 0; channel < 3; ++channel)
            for (int x = 0; x < width; ++x) put(bytes, value_at(data.x0 + x, y, channel));
    }
    return bytes;
}

std::vector<double> second_row(const std::string& table) {
    std::istringstream in(table);
    std::string line, file;
    std::getline(in, line);
    std::getline(in, line);
    std::istringstream words(line);
    words >> file;
    std::vector<double> numbers;
    for (double v; words >> v;) numbers.push_back(v);
    return numbers;
}

// A data window of one of the kinds that programs write, and of some that none should.
Window data_window(const Window& shown, Dice& dice, int& lines) {
    Window d = shown;
    const int w = shown.x1 - shown.x0 + 1, h = shown.y1 - shown.y0 + 1;
    const auto move = [&](int dx, int dy) { d.x0 += dx, d.x1 += dx, d.y0 += dy, d.y1 += dy; };
    switch (dice.below(8)) {
    case 0: break;                                                                              // the same
    case 1: d.x0 += dice.within(0, w - 1), d.y1 -= dice.within(0, h - 1); break;                // a crop
    case 2: d.x0 -= dice.within(0, 5), d.y0 -= dice.within(0, 5), d.x1 += 3, d.y1 += 2; break;  // overscan
    case 3: move(dice.within(-w, w), dice.within(-h, h)); break;                                // shifted
    case 4: move(dice.chance(.5) ? 2 * w : -2 * w, 0); break;                                   // apart
    case 5: move(dice.chance(.5) ? 1000000 : -1000000, dice.within(-2, 2)); break;              // far apart
    case 6: std::swap(d.x0, d.x1), d.x1 -= 1; break;                                            // turned over
    default:                                                                                    // beyond all
        d.x1 = dice.chance(.5) ? 2147483647 : 1 << 20;
        if (dice.chance(.5)) d.y0 = -2147483647 - 1;
        lines = 0;
        return d;
    }
    lines = d.is_empty() ? 0 : d.y1 - d.y0 + 1;
    return d;
}

}  // namespace

Verdict try_windows(const Settings& s, Dice& dice, const std::string& folder) {
    const int w = dice.within(4, 14), h = w;
    const std::vector<int> corners = {0, 0, 0, 1, -1, 7, -20, 1000, -100000, 1 << 30, -(1 << 30), 2147483647 - 20};
    Window shown{dice.pick(corners), dice.pick(corners), 0, 0};
    shown.x1 = shown.x0 + w - 1, shown.y1 = shown.y0 + h - 1;
    int lines = 0;
    const bool near = std::abs(shown.x0) < 1 << 29 && std::abs(shown.y0) < 1 << 29;
    const Window data = near ? data_window(shown, dice, lines) : shown;
    if (!near) lines = h;
    std::string bytes = exr(data, shown, lines, dice.chance(.2));
    const bool cut = dice.chance(.1);
    if (cut) bytes.resize(bytes.size() - 1 - dice.below(bytes.size() - 1));
    write_file(folder + "/a.exr", bytes);

    ModelPicture p;
    p.width = w, p.height = h;
    p.lines = {"#?RADIANCE", "VIEW= -vta -vh 180 -vv 180"};
    int64_t there = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const int64_t X = int64_t(shown.x0) + x, Y = int64_t(shown.y0) + y;
            const bool has = !data.is_empty() && data.holds(X, Y);
            there += has;
            for (int channel = 2; channel >= 0; --channel) p.rgb.push_back(has ? value_at(int(X), int(Y), channel) : 0);
        }
    write_file(folder + "/b.hdr", write_picture(p));
    const Result r = run_tool(s, folder, "vcmetrics", {"-metrics", "Ev,Lavg,Lmax", "a.exr"});
    Verdict v;
    std::ostringstream story;
    for (const Window& window : {shown, data})
        story << window.x0 << " " << window.y0 << " " << window.x1 << " " << window.y1 << "\n";
    v.story = "display and data window:\n" + story.str() + r.describe() + r.out;
    v.find = complaint(r);
    const int status = r.stages[0].status;
    v.outcome = "windows: status " + std::to_string(status);
    if (!v.find.empty()) return v;
    const bool whole = there == int64_t(w) * h;
    if (status != 0) {
        if (whole && near && !cut && lines > 0) v.find = "a whole picture is refused";
        return v;
    }
    if (cut) v.find = "a cut file is measured";
    if (there == 0) v.find = "windows that have nothing in common are measured";
    if (!whole && r.stages[0].talk.empty()) v.find = "black pixels outside the data window pass in silence";
    if (!v.find.empty()) return v;
    const Result b = run_tool(s, folder, "vcmetrics", {"-metrics", "Ev,Lavg,Lmax", "b.hdr"});
    const std::vector<double> ours = second_row(r.out), wanted = second_row(b.out);
    bool same = ours.size() == 3 && wanted.size() == 3;
    for (size_t k = 0; same && k < 3; ++k) same = std::fabs(ours[k] - wanted[k]) <= 1e-5 * std::fabs(wanted[k]);
    if (!same) v.find = "other numbers than of the same pixels without windows: " + b.out;
    return v;
}

}  // namespace breaking
