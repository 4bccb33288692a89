// SPDX-License-Identifier: BSD-3-Clause
// break_faults: the tools with too little memory, disk, descriptors, processes, stack, without streams, without /sys,
// in folders they may not write to.  A tool may fail, in one line; what it wrote is whole or not there, no temporary
// file is left, and with status 0 everything is as it is on a healthy machine, byte for byte.
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "campaign.h"
#include "fault_list.h"

namespace breaking {
namespace {

struct Deed {
    std::string name;
    std::vector<Stage> stages;
    std::string input;
    bool timed = false;                             // a column of seconds: stdout differs between runs
    std::map<std::string, std::string> files = {};  // of an undisturbed run
    std::string out = {};
};

const char* const scene =
    "void plastic grey 0 0 5 .5 .5 .5 0 0\nvoid glow sky 0 0 4 1 1 2 0\nsky source s 0 0 4 0 0 1 180\n"
    "grey polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\nvoid brightfunc deep 2 deep deep.cal 0 0\n"
    "deep plastic d 0 0 5 .5 .5 .5 0 0\nd sphere ball 0 0 4 0 1 .5 .5\n";
const char* const function = "f(n) = if(n, 1 + f(n-1), 0);\ndeep = .5 + .0001 * f(30) + .1 * noise3(Px, Py, Pz);\n";

std::vector<Deed> deeds(const Settings& s) {
    const std::string ptrace = s.tool("ptrace"), ptaccum = s.tool("ptaccum"), vcmetrics = s.tool("vcmetrics");
    Job make;
    make.stages = {{{s.tool("mkstream"), "frames", "0", "5", "40", "40", "1", "VIEW= -vta -vh 180 -vv 180"}}};
    const std::string stream = run(make).out;
    std::vector<Deed> all{
        {"sums", {{{ptaccum}}}, stream},
        {"sum to files", {{{ptaccum, "-o", "disk/x.exr", "-o", "disk/x.hdr", "-o", "disk/x.png"}}}, stream},
        {"metrics", {{{vcmetrics}}}, stream.substr(0, stream.find("#?RADIANCE", 1)), true},
        {"metrics of sums", {{{ptaccum}}, {{vcmetrics, "-metrics", "DGP,Ev,UGR,Lmed"}}}, stream, true},
        {"masks",
         {{{s.tool("vcregion"), "-vta", "-vh", "180", "-vv", "180", "-x", "64", "-y", "64", "-o", "disk/r.exr",
            "regions"}}},
         ""}};
    if (!s.has("ptrace")) return all;
    const std::vector<std::string> render{ptrace, "-vta", "-vp", "0",  "-2", "1",   "-vh", "180",     "-vv",
                                          "180",  "-x",   "32",  "-y", "32", "-ab", "2",   "-frames", "4"};
    const auto with = [&](std::initializer_list<const char*> more) {
        auto words = render;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    all.push_back({"frames", {{with({"-device", "cpu", "scene.rad"})}}, ""});
    all.push_back({"frames, any device", {{with({"scene.rad"})}}, ""});
    all.push_back({"frames to files", {{with({"-device", "cpu", "-o", "disk/f%d.exr", "scene.rad"})}}, ""});
    all.push_back({"the whole pipe",
                   {{with({"-device", "cpu", "scene.rad"})}, {{ptaccum, "-o", "disk/x.exr", "-o", "-"}}, {{vcmetrics}}},
                   "",
                   true});
    return all;
}

void furnish(const std::string& folder, bool writable = true) {
    write_file(folder + "/scene.rad", scene);
    write_file(folder + "/deep.cal", function);
    write_file(folder + "/regions", "desk circle 0 1 0 30\nleft circle -.5 1 0 20\n");
    mkdir((folder + "/disk").c_str(), 0755);
    chmod((folder + "/disk").c_str(), writable ? 0777 : 0555);
}

Job job_of(const Settings& s, const Deed& deed, const std::string& folder) {
    Job job;
    job.stages = deed.stages;
    job.input = deed.input;
    job.folder = folder;
    job.limit_s = s.limit_s;
    job.environment = {"HOME=" + folder, "PATH=/usr/bin:/bin", "SOURCE_DATE_EPOCH=0"};  // files' CAPDATE= is the same
    return job;
}

std::map<std::string, std::string> written(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const std::string& name : files_of(folder + "/disk")) files[name] = read_file(folder + "/disk/" + name);
    return files;
}

// Tables without their column of seconds.
std::string untimed(const Deed& deed, const std::string& out) {
    if (!deed.timed) return out;
    std::string kept;
    for (size_t at = 0; at < out.size();) {
        size_t end = out.find('\n', at);
        if (end == std::string::npos) end = out.size();
        const std::string line = out.substr(at, end - at);
        const size_t first = line.find('\t'), second = line.find('\t', first + 1);
        kept += line.substr(0, first) + line.substr(std::min(second, line.size())) + "\n";
        at = end + 1;
    }
    return kept;
}

// A picture that can be read; a sum of fewer frames, perhaps, written before the disk was full.
bool is_whole(const Settings& s, const std::string& folder, const std::string& name, const std::string& bytes) {
    const std::string end = "IEND\xae\x42\x60\x82";
    if (name.find(".png") != std::string::npos)
        return bytes.size() > end.size() && bytes.compare(bytes.size() - end.size(), end.size(), end) == 0;
    write_file(folder + "/" + name, bytes);
    Job show;
    show.folder = folder;
    show.stages = {{{s.tool("mkstream"), "show", name}}};
    return run(show).stages[0].status == 0;
}

// The loader may lack memory or descriptors before the tool begins; that is not the tool's to tell.
bool began(const Ended& e) {
    return e.status != 127 || e.talk.find("error while loading shared libraries") == std::string::npos;
}

Verdict judge(const Settings& s, Dice& dice, const std::string& folder, const Deed& deed) {
    const Fault fault = some_fault(dice);
    const size_t disk_kb = size_t(dice.within(4, 80));
    furnish(folder, !fault.no_writing);
    Verdict v{fault.name, "", deed.name + ", " + fault.name + "\n"};
    const std::string disk = folder + "/disk";
    if (fault.small_disk && !mount_small_disk(disk, disk_kb)) return {"not to be had here: " + fault.name, "", v.story};

    Job job = job_of(s, deed, folder);
    for (Stage& stage : job.stages) stage.before = fault.before;
    const Result r = run_patiently(job, s);
    const auto files = written(folder);
    if (fault.small_disk) unmount_disk(disk);
    v.story += r.describe();
    if (r.unavailable())
        return {"not to be had here: " + fault.name.substr(0, fault.name.find_first_of("0123456789")), "", v.story};

    v.outcome = fault.name.substr(0, fault.name.find_first_of("0123456789")) + ":";
    bool all_well = true, silent = fault.name == "stderr closed" || fault.name == "all three closed";
    for (const Ended& e : r.stages) {
        v.outcome += began(e) ? " " + std::to_string(e.status) : " not begun";
        all_well = all_well && e.status == 0;
        const bool quiet = silent && e.talk.empty() && !e.hung && !e.signal && e.status <= 3;
        if (began(e) && !quiet && v.find.empty()) v.find = complaint(e);
    }
    if (v.find.empty() && r.left_children) v.find = "a process lives on";
    for (const auto& [name, bytes] : files) {
        const auto whole = deed.files.find(name);
        if (!v.find.empty()) break;
        if (whole == deed.files.end()) v.find = "a file is left: " + name;
        else if (whole->second != bytes && (all_well || !is_whole(s, folder, name, bytes)))
            v.find = name + " is not as it should be";
    }
    if (!v.find.empty() || !all_well) return v;
    if (files != deed.files) v.find = "status 0, but a file is missing";
    if (!fault.stdout_is_lost && untimed(deed, r.out) != deed.out)
        v.find = "status 0, but not what a healthy machine gives";
    if (fault.stdout_is_lost && !deed.out.empty()) v.find = "status 0, but nobody got what it wrote";
    return v;
}

void rehearse(const Settings& s, Deed& deed, const std::string& folder) {
    furnish(folder);
    const Result r = run(job_of(s, deed, folder));
    for (const Ended& e : r.stages)
        if (e.status != 0) {
            std::fprintf(stderr, "%s fails undisturbed:\n%s", deed.name.c_str(), r.describe().c_str());
            std::exit(2);
        }
    deed.out = untimed(deed, r.out);
    deed.files = written(folder);
    for (const auto& file : deed.files) std::remove((folder + "/disk/" + file.first).c_str());
}

}  // namespace
}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 50);
    enter_namespace();  // where that is forbidden, the faults that need it say so
    auto all = deeds(settings);
    return campaign("break_faults", settings, [&](Dice& dice, const std::string& folder) {
        Deed& deed = all[dice.below(all.size())];
        if (deed.out.empty() && deed.files.empty()) rehearse(settings, deed, folder);
        return judge(settings, dice, folder, deed);
    });
}
