// SPDX-License-Identifier: BSD-3-Clause
// break_kills: SIGKILL, SIGTERM and SIGINT at a random moment, to one program of a pipe or, as Ctrl-C does, to all.
// Afterwards every file is the old one or a whole new one, only kill -9 may leave a (hidden) temporary file, and nobody
// who got less than all ends with status 0.  Who was asked to end (TERM, INT) and had summed frames has written them.
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "campaign.h"
#include "stream_model.h"

namespace breaking {
namespace {

constexpr int frames = 40;
const char* const scene =
    "void plastic grey 0 0 5 .5 .5 .5 0 0\nvoid glow sky 0 0 4 1 1 2 0\nsky source s 0 0 4 0 0 1 180\n"
    "grey polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\ngrey sphere ball 0 0 4 0 1 .5 .5\n!genblinds grey b .1 2 2 "
    "20 30\n";

// What is done, and killed while it is being done.
struct Deed {
    std::vector<Stage> stages;
    std::string file;    // what the last program but the meter writes
    double seconds = 0;  // of an undisturbed run
};

std::vector<std::string> words_of_ptrace(const Settings& s) {
    return {s.tool("ptrace"),
            "-device",
            "cpu",
            "-vta",
            "-vp",
            "0",
            "-2",
            "1",
            "-vh",
            "180",
            "-vv",
            "180",
            "-x",
            "40",
            "-y",
            "40",
            "-ab",
            "2",
            "-frames",
            std::to_string(frames)};
}

std::vector<Deed> deeds(const Settings& s) {
    auto pipe = words_of_ptrace(s), files = pipe;
    pipe.push_back("scene.rad");
    files.insert(files.end(), {"-o", "f%02d.hdr", "scene.rad"});
    const Stage sum{{s.tool("ptaccum"), "-o", "x.exr", "-o", "-"}}, last{{s.tool("ptaccum"), "-last", "-o", "x.exr"}};
    const Stage often{{s.tool("ptaccum"), "-every", "4", "-o", "x.exr"}}, meter{{s.tool("vcmetrics")}};
    return {{{{pipe}, sum, meter}, "x.exr"}, {{{pipe}, often}, "x.exr"}, {{{pipe}, last}, "x.exr"}, {{{files}}, ""}};
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Does the process catch the signal yet?  Before main() it does not, and may die of it.
bool catches(pid_t pid, int signal) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(in, line);)
        if (line.compare(0, 7, "SigCgt:") == 0) return std::strtoull(line.c_str() + 7, nullptr, 16) >> (signal - 1) & 1;
    return false;
}

// How many frames above 0 a picture holds; -1: it cannot be read.
int frames_in(const Settings& s, const std::string& folder, const std::string& name) {
    Job show;
    show.folder = folder;
    show.stages = {{{s.tool("mkstream"), "show", name}}};
    const Result r = run(show);
    const size_t at = r.out.find("FRAMES=");
    return r.stages[0].status == 0 && at != std::string::npos ? std::atoi(r.out.c_str() + at + 7) : -1;
}

// The file of the pipes: the old one, or whole.
std::string check_sum(const Settings& s, const std::string& folder, const std::string& old, const Result& r, int victim,
                      int signal) {
    const auto names = files_of(folder);
    const bool there = std::count(names.begin(), names.end(), "x.exr") > 0;
    const bool fresh = there && read_file(folder + "/x.exr") != old;
    if (!there && !old.empty()) return "the file that was there has gone";
    const int summed = fresh ? frames_in(s, folder, "x.exr") : -1;
    if (fresh && summed < 0) return "the file cannot be read";
    const Ended& adder = r.stages[1];
    const bool all = victim < 0 || victim == 1, metered = r.stages.size() > 2;
    const long rows = std::count(r.out.begin(), r.out.end(), '\n') - 1;
    if (adder.status == 0 && !fresh) return "ptaccum ends with status 0 without its file";
    if (adder.status == 0 && summed < frames - 1 && !(metered && r.stages[2].status != 0))
        return "ptaccum ends with status 0 after " + std::to_string(summed + 1) + " frames";
    if (metered && r.stages[2].status == 0 && rows < frames)
        return "vcmetrics ends with status 0 after " + std::to_string(rows) + " sums";
    if (all && signal != SIGKILL && metered && rows > 0 && !fresh) return "asked to end, ptaccum threw its sum away";
    return "";
}

std::string check_frames(const std::string& folder, const Result& r) {
    int whole = 0;
    for (const std::string& name : files_of(folder)) {
        if (name[0] != 'f') continue;
        const ModelStream stream = read_stream(read_file(folder + "/" + name));
        if (stream.end == ModelStream::End::cut || stream.pictures.size() > 1) return name + " is not whole";
        ++whole;
    }
    return r.stages[0].status == 0 && whole < frames
               ? "ptrace ends with status 0 after " + std::to_string(whole) + " frames"
               : "";
}

Verdict judge(const Settings& s, Dice& dice, const std::string& folder, const Deed& deed) {
    const int victim = dice.chance(.3) ? -1 : int(dice.below(deed.stages.size()));
    const int signal = dice.pick(std::vector<int>{SIGKILL, SIGKILL, SIGTERM, SIGINT});
    const double moment = dice.unit() * 1.1 * deed.seconds;
    const std::string old = dice.chance(.5) ? "an older file" : "";
    write_file(folder + "/scene.rad", scene);
    if (!old.empty()) write_file(folder + "/x.exr", old);

    Job job;
    job.stages = deed.stages;
    job.folder = folder;
    job.environment = {"HOME=" + folder};
    job.limit_s = s.limit_s;
    std::vector<bool> mortal(deed.stages.size(), false);  // may die of the signal
    job.meanwhile = [&](const std::vector<pid_t>& pids) {
        std::this_thread::sleep_for(std::chrono::duration<double>(moment));
        for (size_t i = 0; i < pids.size(); ++i)
            mortal[i] = (victim < 0 || victim == int(i)) && (signal == SIGKILL || !catches(pids[i], signal));
        kill(victim < 0 ? -pids[0] : pids[size_t(victim)], signal);
    };
    const Result r = run(job);

    Verdict v;
    v.outcome = std::string("signal ") + std::to_string(signal) + ", " +
                (victim < 0 ? "to all:" : "to " + r.stages[size_t(victim)].tool + ":");
    for (const Ended& e : r.stages) v.outcome += e.signal ? " killed" : " " + std::to_string(e.status);
    v.story = v.outcome + " after " + std::to_string(moment) + " s\n" + r.describe();
    for (size_t i = 0; i < r.stages.size() && v.find.empty(); ++i) {
        const bool killed = mortal[i] && r.stages[i].signal == signal && !r.stages[i].hung;
        if (!killed) v.find = complaint(r.stages[i]);
    }
    if (v.find.empty() && r.left_children) v.find = "a process lives on";
    if (v.find.empty())
        v.find = deed.file.empty() ? check_frames(folder, r) : check_sum(s, folder, old, r, victim, signal);
    for (const std::string& name : files_of(folder))
        if (name[0] == '.' && signal != SIGKILL && v.find.empty()) v.find = "a temporary file is left: " + name;
    return v;
}

// The time that it takes undisturbed.
void rehearse(Deed& deed, const std::string& folder) {
    write_file(folder + "/scene.rad", scene);
    Job job;
    job.stages = deed.stages;
    job.folder = folder;
    job.environment = {"HOME=" + folder};
    const double begun = now();
    const Result r = run(job);
    deed.seconds = now() - begun;
    for (const Ended& e : r.stages)
        if (e.status != 0) {
            std::fprintf(stderr, "it fails undisturbed:\n%s", r.describe().c_str());
            std::exit(2);
        }
    for (const std::string& name : files_of(folder)) std::remove((folder + "/" + name).c_str());
}

}  // namespace
}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 30);
    if (!settings.has("ptrace")) return std::puts("no ptrace here"), 77;
    auto all = deeds(settings);
    return campaign("break_kills", settings, [&](Dice& dice, const std::string& folder) {
        Deed& deed = all[dice.below(all.size())];
        if (deed.seconds == 0) rehearse(deed, folder);
        return judge(settings, dice, folder, deed);
    });
}
