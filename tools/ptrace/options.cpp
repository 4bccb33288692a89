// SPDX-License-Identifier: BSD-3-Clause
// See options.h.  One table holds every option once: its arguments, its line of help and where its value goes.
#include "options.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <limits>
#include <variant>

#include "base/error.h"
#include "base/find_file.h"
#include "base/radopts.h"
#include "base/run.h"
#include "base/text_file.h"
#include "base/warnings.h"
#include "image/stream.h"
#include "scene/rad_input.h"
#include "scene_options.h"
#include "trace/progressive.h"

namespace {

using base::Words;

struct Triple {
    double* v;
};
using Reader = std::function<void(Words&)>;
using Target = std::variant<std::monostate, int*, double*, bool*, Triple, uint64_t*, std::string*, Reader>;

struct Row {
    const char* name;
    const char* args;  // as -help names them
    const char* help;
    Target target;  // none: another reader's (the view's)
    double low = 0, high = std::numeric_limits<double>::infinity();
};

// Options of rpict that steer what a path tracer does not have: its cache, its thresholds, its pixel interpolation,
// its animations and its files.  Number of arguments; -1: -ap's file and up to two numbers.
struct Unneeded {
    const char* name;
    int args;
};
const Unneeded unneeded[] = {
    {"-aa", 1}, {"-ar", 1},   {"-ad", 1},  {"-as", 1}, {"-aw", 1}, {"-af", 1}, {"-ai", 1}, {"-aI", 1}, {"-ae", 1},
    {"-aE", 1}, {"-am", 1},   {"-ap", -1}, {"-dt", 1}, {"-dc", 1}, {"-ps", 1}, {"-pt", 1}, {"-pm", 1}, {"-cs", 1},
    {"-cw", 2}, {"-pRGB", 0}, {"-S", 1},   {"-P", 1},  {"-PP", 1}, {"-r", 1},  {"-ro", 1}, {"-z", 1},  {"-n", 1},
};

// Opened before stderr is given up, so that a failure is still told there.
void send_messages_to(const std::string& path) {
    errno = 0;
    const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (fd < 0 || dup2(fd, 2) < 0) base::fail_system(path, "cannot be written");
    close(fd);
}

void read_frames(const std::string& text, Options& opt) {
    const size_t colon = text.find(':');
    if (colon == std::string::npos) {
        const long n = base::to_int(text, "-frames");
        if (n < 1) base::fail("-frames", "at least 1 frame, not " + text);
        opt.first = 0, opt.last = n - 1;
    } else {
        opt.first = base::to_int(text.substr(0, colon), "-frames");
        opt.last = base::to_int(text.substr(colon + 1), "-frames");
        if (opt.first < 0) base::fail("-frames", "frames count from 0, not from " + std::to_string(opt.first));
        if (opt.last < opt.first) base::fail("-frames", text + " holds no frame");
    }
    if (opt.last >= Options::endless)
        base::fail("-frames", fmt::format("frames end before number {}", Options::endless));
}

std::vector<Row> table(Options& opt) {
    trace::RenderOptions& r = opt.render;
    return {
        {"-vf", "file", "view from a view file or a picture",
         Reader([&](Words& w) { opt.view = view::read_view_file(w.next_string("-vf")); })},
        {"-vt", "T", "view type, joined: v l a h s c", {}},
        {"-vp", "x y z", "view point", {}},
        {"-vd", "x y z", "view direction", {}},
        {"-vu", "x y z", "view up", {}},
        {"-vh", "a", "horizontal size (degrees; -vtl: length)", {}},
        {"-vv", "a", "vertical size", {}},
        {"-vo", "d", "fore clipping distance", {}},
        {"-va", "d", "aft clipping distance", {}},
        {"-vs", "f", "shift", {}},
        {"-vl", "f", "lift", {}},
        {"-x", "n", "horizontal resolution", &opt.nx, 1, 32768},
        {"-y", "n", "vertical resolution", &opt.ny, 1, 32768},
        {"-pa", "f", "pixel aspect, 0 keeps -x and -y", &opt.pixel_aspect},
        {"-pj", "f", "pixel jitter", &r.pj, 0, 1},
        {"-pd", "d", "depth of field: lens diameter", &r.pd},
        {"-i", "+-", "irradiance instead of radiance", &r.i},
        {"-ab", "n", "diffuse bounces", &r.ab, 0, 10000},
        {"-av", "r g b", "ambient value after the last bounce", Triple{r.av}},
        {"-st", "f", "specular threshold", &r.st, 0, 1},
        {"-ss", "f", "specular sampling, above 1.5 weighted", &r.ss},
        {"-dj", "f", "direct jitter", &r.dj, 0, 1},
        {"-ds", "f", "pieces of light sources as RADIANCE cuts them; 0: the true shape", &r.ds},
        {"-dr", "n", "relays of virtual sources", &r.dr, 0, 100},
        {"-dp", "n", "presampling of virtual sources, without effect", &r.dp},
        {"-dv", "+-", "light sources visible", &r.dv},
        {"-bv", "+-", "back faces visible", &r.bv},
        {"-u", "+-", "uncorrelated sampling, without effect", &r.u},
        {"-lr", "n", "ray level limit, negative: roulette", &r.lr, -10000, 10000},
        {"-lw", "f", "ray weight limit", &r.lw},
        {"-me", "r g b", "mist extinction", Triple{r.me}},
        {"-ma", "r g b", "mist albedo", Triple{r.ma}},
        {"-mg", "f", "mist eccentricity", &r.mg, 0, 1},
        {"-ms", "d", "mist sampling distance", &r.ms},
        {"-f", "file", "function file for the whole scene",
         Reader([&](Words& w) { opt.files.cal_files.push_back(w.next_string("-f")); })},
        {"-frames", "N|A:B", "frames 0 to N-1, or A to B; else endless",
         Reader([&](Words& w) { read_frames(w.next_string("-frames"), opt); })},
        {"-seed", "n", "seed of the random numbers", &r.seed},
        {"-device", "name", "auto, cpu, cpu:embree, opencl or opencl:N", &opt.device},
        {"-o", "pattern", "frames to files such as f%04d.hdr", Reader([&](Words& w) {
             opt.output = w.next_string("-o");
             if (opt.output.empty()) base::fail("-o", "the name is empty");
         })},
        {"-exec", "", "let the scene run its !commands", Reader([&](Words&) { opt.files.exec = true; })},
        {"-rif", "file", "scene, options and views of a rad input file", {}},
        {"-t", "s", "report on stderr every s seconds", &opt.report_s},
        {"-w", "+-", "warnings", &opt.warnings},
        {"-e", "file", "messages to this file", Reader([](Words& w) { send_messages_to(w.next_string("-e")); })},
        {"-defaults", "", "print the values in force", {}},
        {"-devices", "", "print the devices there are", {}},
        {"-version", "", "print the version", {}},
        {"-help", "", "print this list", {}},
    };
}

void check_range(const Row& row, double value) {
    if (value < row.low || value > row.high)
        base::fail(row.name, fmt::format("{} is outside {} to {}", value, row.low, row.high));
}

// Reads the option at the cursor into its target, if it is one of ours.
bool read_row(const Row& row, Words& words) {
    if (auto flag = std::get_if<bool*>(&row.target)) return words.is_switch(row.name, **flag);
    if (std::holds_alternative<std::monostate>(row.target) || !words.is(row.name)) return false;
    if (auto n = std::get_if<int*>(&row.target)) {
        const long value = words.next_int(row.name);
        check_range(row, double(value));
        **n = int(value);
    } else if (auto f = std::get_if<double*>(&row.target)) {
        check_range(row, ** f = words.next_real(row.name));
    } else if (auto t = std::get_if<Triple>(&row.target)) {
        for (int i = 0; i < 3; ++i) check_range(row, t->v[i] = words.next_real(row.name));
    } else if (auto seed = std::get_if<uint64_t*>(&row.target)) {
        const long value = words.next_int(row.name);
        check_range(row, double(value));
        **seed = uint64_t(value);
    } else if (auto text = std::get_if<std::string*>(&row.target)) {
        **text = words.next_string(row.name);
    } else {
        std::get<Reader>(row.target)(words);
    }
    return true;
}

bool read_unneeded(Words& words, std::string& seen) {
    for (const Unneeded& u : unneeded) {
        if (!words.is(u.name)) continue;
        for (int i = 0; i < (u.args < 0 ? 1 : u.args); ++i) words.next_string(u.name);
        for (int i = 0; u.args < 0 && i < 2 && words.at() < words.all().size(); ++i) {
            if (words.peek().find_first_not_of("0123456789") != std::string::npos) break;
            words.take();
        }
        if (u.args && (seen + " ").find(std::string(" ") + u.name + " ") == std::string::npos)
            seen += std::string(" ") + u.name;
        return true;
    }
    return false;
}

void print_help(Options& opt) {
    std::string text = "usage: ptrace [options] scene.rad ... (\"-\": stdin)\n";
    for (const Row& row : table(opt)) {
        const bool joined = row.args[0] == '+' || std::string(row.name) == "-vt";
        text += fmt::format(
            "  {:<18} {}\n",
            row.name + std::string(joined || !*row.args ? "" : " ") + (row.args[0] == '+' ? "[+-]" : row.args),
            row.help);
    }
    text += "Accepted and not needed:";
    for (const Unneeded& u : unneeded) text += std::string(" ") + u.name;
    text += "\nDescribed in ptrace(1).\n";
    base::write_stdout(text.data(), text.size());
}

// Options and values as RADIANCE's programs print them, so that the output can serve as an @file once the
// comments are cut off.
void print_defaults(Options& opt) {
    std::string view_options = view::to_options(opt.view), text;
    for (size_t at; (at = view_options.find(" -v")) != std::string::npos;) {
        const size_t next = view_options.find(" -v", at + 1);
        text += view_options.substr(at + 1, next == std::string::npos ? next : next - at - 1) + "\n";
        view_options.erase(0, next);
    }
    const auto line = [&](const Row& row, const std::string& value) {
        text += fmt::format("{:<31} # {}\n", row.name + value, row.help);
    };
    for (const Row& row : table(opt)) {
        if (auto flag = std::get_if<bool*>(&row.target)) line(row, **flag ? "+" : "-");
        else if (auto n = std::get_if<int*>(&row.target)) line(row, fmt::format(" {}", **n));
        else if (auto f = std::get_if<double*>(&row.target)) line(row, fmt::format(" {:g}", **f));
        else if (auto t = std::get_if<Triple>(&row.target))
            line(row, fmt::format(" {:g} {:g} {:g}", t->v[0], t->v[1], t->v[2]));
        else if (auto seed = std::get_if<uint64_t*>(&row.target)) line(row, fmt::format(" {}", **seed));
    }
    text += fmt::format("{:<31} # device\n", "-device " + opt.device);
    if (opt.last != Options::endless) text += fmt::format("-frames {}:{}\n", opt.first, opt.last);
    base::write_stdout(text.data(), text.size());
}

// The question an option may be; its answer goes to stdout.
bool answer(Words& words, Options& opt) {
    if (words.is("-help") || words.is("--help")) print_help(opt);
    else if (words.is("-defaults")) print_defaults(opt);
    else if (words.is("-version") || words.is("--version")) {
        const std::string text = "ptrace (luxpipe) " LUXPIPE_VERSION "\n";
        base::write_stdout(text.data(), text.size());
    } else if (words.is("-devices")) {
        for (const std::string& device : trace::list_devices())
            base::write_stdout((device + "\n").data(), device.size() + 1);
    } else return false;
    return true;
}

// What parsing knows besides the options' values.
struct Reading {
    Options& opt;
    std::string not_needed;                    // options that deserve the one warning
    std::optional<scene::RadInput> rad_input;  // -rif
    std::vector<std::string> view_after_rif;   // view options that override the view chosen by name
};

bool read_option(Words& words, Reading& reading);

// What the user says in an order of its own.
void read_all(const std::vector<std::string>& options, Reading& reading) {
    for (Words words(options); words.more();)
        if (!read_option(words, reading)) base::fail(words.peek(), "no such option; ptrace -help lists them");
}

// What a scene's file says, which is less (scene_options.h).
void read_from_scene(const std::vector<std::string>& options, Options& opt, const std::string& file) {
    Reading quiet{opt, "", {}, {}};  // rad's own choices deserve no warning
    for (Words words(options, file); words.more();) {
        if (skip_callers_option(words)) continue;
        require_scene_option(words.peek(), file);
        if (words.peek() == "-vf" && words.at() + 1 < words.all().size())
            base::require_ordinary_file(words.all()[words.at() + 1], file);
        if (!read_option(words, quiet)) base::fail(file, "\"" + words.peek() + "\" is no option of ptrace");
    }
}

void read_rif(const std::string& path, Reading& reading) {
    reading.rad_input = scene::read_rad_input(path);
    read_from_scene(reading.rad_input->options, reading.opt, path);
    for (const std::string& file : reading.rad_input->scene_files) base::require_ordinary_file(file, path);
    reading.opt.exposure = reading.rad_input->exposure;
}

// The view of that name, then the view options given after -rif.
void choose_view(const std::string& name, Reading& reading) {
    Reading after{reading.opt, "", {}, {}};
    reading.opt.view = view::View();
    read_from_scene(scene::view_words(*reading.rad_input, name), reading.opt, reading.rad_input->path);
    read_all(reading.view_after_rif, after);
}

// One option at the cursor; false: no option of ours.
bool read_option(Words& words, Reading& reading) {
    const size_t from = words.at();
    const auto was_view = [&] {
        if (reading.rad_input)
            reading.view_after_rif.insert(reading.view_after_rif.end(), words.all().begin() + long(from),
                                          words.all().begin() + long(words.at()));
        return true;
    };
    if (words.is("-rif")) {
        read_rif(words.next_string("-rif"), reading);
        return true;
    }
    for (const Row& row : table(reading.opt))
        if (read_row(row, words)) return std::string(row.name) == "-vf" ? was_view() : true;
    if (const int n = view::parse_option(reading.opt.view, words.all(), words.at())) {
        words.skip(size_t(n));
        return was_view();
    }
    if (words.peek() == "-pXYZ" || words.peek() == "-pc") base::fail(words.peek(), "frames are in RADIANCE's RGB");
    return read_unneeded(words, reading.not_needed);
}

void check(const Options& opt) {
    if (opt.scene_files.empty()) base::fail("", "no scene file; ptrace -help lists the options");
    view::validate(opt.view);
    if (!opt.output.empty()) {
        if (opt.last == Options::endless) base::fail("-frames", "say how many frames; files have no end");
        if (opt.last > opt.first && output_name(opt.output, 0) == output_name(opt.output, 1))
            base::fail("-o", "\"" + opt.output + "\" needs a %d for the number of the frame");
        image::require_writable_ending(output_name(opt.output, opt.first));
        return;
    }
    struct stat info = {};
    if (fstat(1, &info) != 0) base::fail_system("stdout", "cannot be written");
    if (base::stdout_is_terminal()) base::fail("stdout", "pictures are binary; pipe them or name files with -o");
    const bool reader = S_ISFIFO(info.st_mode) || S_ISSOCK(info.st_mode);
    if (!reader && opt.last == Options::endless)
        base::fail("-frames", "say how many frames; without a reader on stdout there is no end");
}

}  // namespace

std::string output_name(const std::string& pattern, int64_t k) {
    const size_t at = pattern.find('%');
    if (at == std::string::npos) return pattern;
    size_t end = at + 1;
    while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9') ++end;
    const std::string width = pattern.substr(at + 1, end - at - 1);
    if (end == pattern.size() || pattern[end] != 'd' || width.size() > 2 || pattern.find('%', end) != std::string::npos)
        base::fail("-o", "\"" + pattern + "\" must hold one %d, such as %04d");
    const std::string number = std::to_string(k);
    const size_t wide = width.empty() ? 0 : std::stoul(width);
    const std::string pad(wide > number.size() ? wide - number.size() : 0, width[0] == '0' ? '0' : ' ');
    return pattern.substr(0, at) + pad + number + pattern.substr(end + 1);
}

std::optional<int> parse_options(int argc, char** argv, Options& opt) {
    opt.files.raypath = base::raypath_from_environment();
    opt.files.work = base::work_from_environment();
    Words words({argv + 1, argv + argc});
    Reading reading{opt, "", {}, {}};
    std::vector<std::string> operands;
    while (words.more()) {
        if (!words.is_option()) operands.push_back(words.take());
        else if (!operands.empty()) base::fail(words.peek(), "options come before the scene files");
        else if (answer(words, opt)) return 0;
        else if (!read_option(words, reading)) base::fail(words.peek(), "no such option; ptrace -help lists them");
    }
    if (reading.rad_input) {
        if (operands.size() > 1) base::fail("-rif", "one view name at most, not \"" + operands[1] + "\" too");
        opt.scene_files = reading.rad_input->scene_files;
        choose_view(operands.empty() ? "" : operands[0], reading);
    } else {
        opt.scene_files = operands;
    }
    base::search_beside(opt.scene_files, opt.files);
    if (!opt.warnings) base::set_warning_sink({});
    if (!reading.not_needed.empty()) base::warn("", "a path tracer does not need" + reading.not_needed);
    check(opt);
    view::fit_size(opt.view, opt.pixel_aspect, opt.nx, opt.ny);
    return std::nullopt;
}
