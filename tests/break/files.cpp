// SPDX-License-Identifier: BSD-3-Clause
// break_files: what files say about other files, shapes, windows, numbers and times.
// Each kind of trial has a second opinion: a region file written in another way has the same areas; a special file that
// another file names is refused; an OpenEXR picture measures as the same pixels without windows; a number of a header
// is read whole or refused; two spellings of one time give one sky.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

#include "campaign.h"
#include "file_trials.h"

namespace breaking {

Result run_tool(const Settings& s, const std::string& folder, const std::string& tool, std::vector<std::string> words,
                std::vector<std::string> environment) {
    words.insert(words.begin(), s.tool(tool));
    Job job;
    job.folder = folder;
    job.stages = {{words}};
    job.environment = std::move(environment);
    return run_patiently(job, s);
}

namespace {

const char* const scene_text =
    "void plastic mat 0 0 5 .5 .5 .5 0 0\nmat polygon floor 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n";

void make_socket(const std::string& path) {
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    struct sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    if (bind(fd, reinterpret_cast<struct sockaddr*>(&address), sizeof address) != 0) write_file(path, "");
    close(fd);
}

// A name of something that no file may name.
std::string special_file(Dice& dice, const std::string& folder) {
    static const std::vector<std::string> kernels = choices(
        "/dev/stdin /dev/fd/0 /dev/zero /dev/null /dev/full /dev/tty /dev/random /proc/kmsg /proc/self/environ "
        "/proc/self/fd/0 /proc/self/mem /proc/self/maps /proc/version /proc/1/environ /proc/self/cmdline "
        "/sys/kernel/vmcoreinfo /sys/kernel/uevent_seqnum /proc/self/cwd /dev/../proc/version "
        "//proc/version /proc/self/cwd/good.rad /proc/thread-self/environ");
    std::string name = dice.pick(kernels);
    switch (dice.below(6)) {
    case 0: mkfifo((folder + "/s").c_str(), 0600), name = "s"; break;
    case 1: make_socket(folder + "/s"), name = "s"; break;
    case 2: mkfifo((folder + "/target").c_str(), 0600), name = "target"; break;
    default: break;
    }
    struct stat info;
    const bool there = name[0] != '/' || stat(name.c_str(), &info) == 0;
    if (!there) return "";
    for (int links = dice.chance(.4) ? dice.within(1, 3) : 0; links > 0; --links) {
        const std::string link = "link" + std::to_string(links);
        if (symlink(name.c_str(), (folder + "/" + link).c_str()) == 0) name = link;
    }
    static const std::vector<std::string> endings = choices(".png .exr .hdr .rad .oct .cal .xml .dat .obj .rtm");
    if (dice.chance(.5) && symlink(name.c_str(), (folder + "/n" + endings[0]).c_str()) == 0) {
        const std::string ended = "n" + dice.pick(endings);
        rename((folder + "/n" + endings[0]).c_str(), (folder + "/" + ended).c_str());
        return ended;
    }
    return name;
}

struct Place {
    const char *name, *file, *text;  // text: % is the special file
};

// Ways to name a file in a scene or a rad input file.
const Place places[] = {
    {"region", "t.regions", "r mask %\n"},
    {"region, channel", "t.regions", "r mask % channel R\n"},
    {"region in a set", "t.regions", "r circle view 40 - mask %\n"},
    {"cat", "t.rad", "!cat % good.rad\n"},
    {"cat, the last", "t.rad", "!cat good.rad %\n"},
    {"xform", "t.rad", "!xform -rz 90 %\n"},
    {"xform -f", "t.rad", "!xform -f % good.rad\n"},
    {"pipe", "t.rad", "!cat % | xform -t 1 0 0\n"},
    {"genprism", "t.rad", "!genprism m p % -l 0 0 1\n"},
    {"genprism <", "t.rad", "!genprism m p - -l 0 0 1 < %\n"},
    {"instance", "t.rad", "void instance i 1 % 0 0\n"},
    {"mesh", "t.rad", "void mesh i 1 % 0 0\n"},
    {"colorpict", "t.rad", "void colorpict m 7 red green blue % . Px Py 0 0\nm polygon f 0 0 9 0 0 1 1 0 1 0 1 1\n"},
    {"brightdata", "t.rad", "void brightdata m 4 noop % . Px 0 0\nm polygon f 0 0 9 0 0 1 1 0 1 0 1 1\n"},
    {"specpict", "t.rad", "void specpict m 5 noop % . Px Py 0 0\nm polygon f 0 0 9 0 0 1 1 0 1 0 1 1\n"},
    {"brighttext", "t.rad",
     "void brighttext m 2 % . 0 11 0 0 0 1 0 0 0 -1 0 1 0\nm polygon f 0 0 9 0 0 1 1 0 1 0 1 1\n"},
    {"BSDF", "t.rad", "void BSDF m 6 0 % 0 0 1 . 0 0\nm polygon f 0 0 9 0 0 1 1 0 1 0 1 1\n"},
    {"rif scene", "t.rif", "view= a -vf down.vf\nscene= %\n"},
    {"rif options", "t.rif", "view= a -vf down.vf\nscene= good.rad\nrender= @%\n"},
    {"rif view", "t.rif", "scene= good.rad\nview= a -vf %\n"},
    {"rif octree", "t.rif", "view= a -vf down.vf\nOCTREE= %\n"},
    {"rif function file", "t.rif", "view= a -vf down.vf\nscene= good.rad\nrender= -f %\n"},
};

}  // namespace

Verdict try_special(const Settings& s, Dice& dice, const std::string& folder) {
    write_file(folder + "/good.rad", scene_text);
    write_file(folder + "/down.vf", "VIEW= -vtv -vp 0 0 2 -vd 0 .1 -1 -vu 0 1 0 -vh 40 -vv 40\n");
    const Place& place = places[dice.below(std::size(places))];
    const std::string name = special_file(dice, folder);
    Verdict v;
    v.outcome = "special: not on this machine";
    if (name.empty()) return v;
    std::string text = place.text;
    text.replace(text.find('%'), 1, name);
    write_file(folder + "/" + place.file, text);
    const bool regions = std::strcmp(place.file, "t.regions") == 0, rif = std::strcmp(place.file, "t.rif") == 0;
    const std::vector<std::string> view = choices("-vf down.vf -x 6 -y 6");
    std::vector<std::string> words = view;
    std::string tool = "ptrace";
    if (regions && dice.chance(.6)) {
        tool = "vcregion";
        words.insert(words.end(), {"-list", place.file});
    } else if (regions) {
        words.insert(words.end(), {"-focus", place.file, "-device", "cpu", "-frames", "1", "good.rad"});
    } else if (rif) {
        words = {"-device", "cpu", "-frames", "1", "-x", "6", "-y", "6", "-rif", place.file};
    } else {
        words.insert(words.end(), {"-device", "cpu", "-frames", "1", place.file});
    }
    const std::string secret = "a-word-of-the-environment";
    const Result r = run_tool(s, folder, tool, words, {"SECRET=" + secret});
    v.story = std::string(place.name) + ": " + text + r.describe();
    v.find = complaint(r);
    v.outcome = "special: status " + std::to_string(r.stages[0].status);
    if (!v.find.empty()) return v;
    if (r.stages[0].status == 0) v.find = "a special file that a file names is read";
    if ((r.stages[0].talk + r.out).find(secret) != std::string::npos) v.find = "the environment is shown";
    return v;
}

}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 300);
    std::vector<decltype(&try_special)> kinds = {try_regions, try_windows, try_header};
    if (settings.has("ptrace")) kinds.insert(kinds.end(), {try_special, try_clock});
    return campaign("break_files", settings,
                    [&](Dice& dice, const std::string& folder) { return dice.pick(kinds)(settings, dice, folder); });
}
