// SPDX-License-Identifier: BSD-3-Clause
// Trials of break_files with numbers: in the headers of pictures and in times of day.
// A header's number is all of its word, read as strtod() reads it; a word that is more than a number must not pass in
// silence.  A time of day has many spellings.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>

#include "file_trials.h"

namespace breaking {
namespace {

std::string printed(const char* form, double value) {
    char text[64];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

// A white picture of 8 x 8 with these lines in its header; its pixels are 2.
std::string picture(const std::vector<std::string>& lines) {
    std::string bytes = "#?RADIANCE\n";
    for (const std::string& line : lines) bytes += line + "\n";
    bytes += "FORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 8\n";
    for (int i = 0; i < 64; ++i) bytes += std::string("\x80\x80\x80\x82", 4);
    return bytes;
}

std::optional<double> first_value(const std::string& table) {
    std::istringstream in(table);
    std::string line, word;
    std::getline(in, line);
    if (!std::getline(in, line)) return std::nullopt;
    return std::strtod(line.substr(line.rfind('\t') + 1).c_str(), nullptr);
}

}  // namespace

std::string spelled_number(Dice& dice, double value) {
    const std::string plain = printed("%.10g", value);
    switch (dice.below(17)) {
    case 0: return printed("%.9e", value);
    case 1: return "+" + plain;
    case 2: return "0" + plain;
    case 3: return plain + (plain.find('.') == std::string::npos ? ".00" : "00");
    case 4: return printed("%.1f", value) + ",5";
    case 5: return printed("%.0f", value) + "," + std::to_string(dice.within(0, 9));
    case 6: return "1,8e2";
    case 7: return plain + dice.pick(choices("x . f , ; % deg e e+ d0 L ' _ :"));
    case 8: return plain + "." + std::to_string(dice.within(0, 9));
    case 9: return "0x" + std::to_string(dice.within(1, 9));
    case 10: return dice.pick(choices("nan inf -inf infinity NaN 1e999 1e-999 -0 0 ."));
    case 11: return "-" + plain;
    case 12: return plain + "," + plain;
    case 13: return std::to_string(dice.within(1, 9)) + "'" + std::to_string(dice.within(100, 999));
    case 14: return "\xe2\x88\x92" + plain;  // the minus of typography
    case 15: return plain + "\xc2\xa0";      // a blank that is none
    default: return plain;
    }
}

std::optional<double> number_in(const std::string& text) {
    if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end || end == text.c_str() || !std::isfinite(value)) return std::nullopt;
    return value;
}

Verdict try_header(const Settings& s, Dice& dice, const std::string& folder) {
    const int kind = dice.within(0, 3);
    const double meant = kind == 0 ? .25 * dice.within(1, 40) : kind == 1 ? dice.within(10, 180) : dice.within(1, 3);
    const std::string word = spelled_number(dice, meant);
    const std::optional<double> value = number_in(word);
    std::vector<std::string> lines = {"VIEW= -vta -vh 180 -vv 180"}, other = lines;
    const std::string plain = printed("%.17g", value.value_or(1));
    if (kind == 0) lines.push_back("EXPOSURE=" + word), other.push_back("EXPOSURE=" + plain);
    if (kind == 1) {
        lines = {"VIEW= -vta -vh " + word + " -vv 180"};
        other = {"VIEW= -vta -vh " + plain + " -vv 180"};
    }
    if (kind == 2) lines.push_back("COLORCORR=1 " + word + " 1"), other.push_back("COLORCORR=1 " + plain + " 1");
    if (kind == 3) lines.push_back("PIXASPECT=" + word), other.push_back("PIXASPECT=" + plain);
    write_file(folder + "/a.hdr", picture(lines));
    write_file(folder + "/b.hdr", picture(other));
    const Result r = run_tool(s, folder, "vcmetrics", {"-metrics", "Ev", "a.hdr"});

    Verdict v;
    v.story = lines.back() + "\n" + r.describe() + r.out;
    v.find = complaint(r);
    v.outcome = "header: status " + std::to_string(r.stages[0].status);
    if (!v.find.empty() || r.stages[0].status != 0) return v;
    const bool silent = r.stages[0].talk.empty();
    if (!value && silent) v.find = "a word that is no number passes in silence";
    if (!value || !v.find.empty()) return v;
    const Result b = run_tool(s, folder, "vcmetrics", {"-metrics", "Ev", "b.hdr"});
    const auto ev = first_value(r.out), wanted = first_value(b.out);
    if (!ev || !wanted || !(std::fabs(*ev - *wanted) <= 1e-6 * std::fabs(*wanted)))
        v.find = "another number than that of the plain spelling, " + plain + ": " + b.out;
    if (kind == 0 && ev && wanted && silent) {  // pixels of 2 / exposure, over a hemisphere
        const double pi = 3.14159265358979, law = 179 * pi * 2 * 128.5 / 128 / *value;
        if (std::fabs(*ev / law - 1) > .1) v.find = "the law says " + printed("%g", law);
    }
    return v;
}

Verdict try_clock(const Settings& s, Dice& dice, const std::string& folder) {
    if (dice.chance(.2)) {  // the clock of the files
        write_file(folder + "/a.hdr", picture({"VIEW= -vta -vh 180 -vv 180"}));
        const std::string epoch =
            dice.chance(.5) ? std::to_string(dice.within(0, 2000000000)) : spelled_number(dice, dice.within(1, 99999));
        const Result r = run_tool(s, folder, "ptaccum", {"a.hdr", "-o", "b.hdr"}, {"SOURCE_DATE_EPOCH=" + epoch});
        Verdict v;
        v.story = "SOURCE_DATE_EPOCH=" + epoch + "\n" + r.describe();
        v.find = complaint(r);
        v.outcome = "clock of files: status " + std::to_string(r.stages[0].status);
        const bool whole = !epoch.empty() && epoch.find_first_not_of("0123456789") == std::string::npos;
        if (!v.find.empty() || r.stages[0].status != 0) return v;
        if (!whole && epoch.find_first_not_of("0123456789+-") != std::string::npos && r.stages[0].talk.empty())
            v.find = "a date that is no number passes in silence";
        if (!whole) return v;
        const std::time_t seconds = std::time_t(std::atoll(epoch.c_str()));
        char date[64] = "";
        std::tm parts = {};
        if (gmtime_r(&seconds, &parts)) std::strftime(date, sizeof date, "CAPDATE= %Y:%m:%d %H:%M:%S\n", &parts);
        if (read_file(folder + "/b.hdr").find(date) == std::string::npos) v.find = std::string("not of ") + date;
        return v;
    }
    // Each spelling of a time gives the sky that the plain decimal gives, or is refused, or a warning says why.
    const int hour = dice.within(0, 24), minute = dice.within(0, 59);
    const int month = dice.within(1, 12), day = dice.within(1, 28);
    std::string time;
    std::optional<double> value;
    switch (dice.below(7)) {
    case 0:
    case 1:
        time = std::to_string(hour) + (minute < 10 ? ":0" : ":") + std::to_string(minute);
        value = hour + minute / 60.;
        break;
    case 2: time = std::to_string(hour) + ":" + std::to_string(dice.within(60, 999)); break;
    case 3: time = std::to_string(hour) + dice.pick(choices(": :- :3O h30 ,5 .5.5 :30:00 -5 + ?12 :1e1 :0x1")); break;
    case 4: time = std::to_string(dice.within(25, 9999)); break;
    // +12 is gensky's solar time
    default: time = spelled_number(dice, hour + minute / 60.); value = time[0] == '+' ? std::nullopt : number_in(time);
    }
    std::string date = std::to_string(month) + " " + std::to_string(day);
    const bool wrong_date = dice.chance(.15);
    if (wrong_date) date = dice.pick(choices("0 1|13 1|2 30|4 31|1 32|1,5 3|3 2,1|-3 21|3.5 21|3 21.5|3 0", '|'));
    static const std::vector<std::string> programs =
        choices("gensky %|gensky % -ang 30 10|gendaylit % -P 6.3 .12|gensky % -a 50 -o 10 -m 15|gensky % -y 2024", '|');
    std::string program = dice.pick(programs);
    const bool uses_time = program.find("-ang") == std::string::npos;
    if (!uses_time) program = "gensky %";
    const auto sky = [&](const std::string& when) {
        std::string line = program;
        line.replace(line.find('%'), 1, date + " " + when);
        write_file(folder + "/sky.rad", "!" + line +
                                            "\nskyfunc glow g 0 0 4 1 1 1 0\ng source s 0 0 4 0 0 1 180\n"
                                            "void light l 0 0 3 1 1 1\nl sphere p 0 0 4 0 0 3 .1\n");
        return run_tool(s, folder, "ptrace",
                        choices("-device cpu -picture -frames 1 -x 6 -y 6 -vta -vh 180 -vv 180 -vd 0 0 1 -vu 0 1 0 "
                                "-vp 0 0 1 sky.rad"));
    };
    const auto pixels = [](const Result& r) { return r.out.substr(std::min(r.out.find("\n\n"), r.out.size())); };
    const Result r = sky(time);
    Verdict v;
    v.story = program + " at " + date + " " + time + "\n" + r.describe();
    v.find = complaint(r);
    v.outcome = "clock: status " + std::to_string(r.stages[0].status);
    if (!v.find.empty() || r.stages[0].status != 0) return v;
    const bool silent = r.stages[0].talk.empty();
    if (silent && time[0] != '+' && (!value || *value < 0 || *value > 24))
        v.find = "a time that is none passes in silence";
    if (silent && wrong_date) v.find = "a date that is none passes in silence";
    if (!v.find.empty() || !value || !silent) return v;
    const Result plain = sky(printed("%.17g", *value));
    if (pixels(plain) != pixels(r)) v.find = "another sky than at " + printed("%.17g", *value);
    return v;
}

}  // namespace breaking
