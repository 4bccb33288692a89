// SPDX-License-Identifier: BSD-3-Clause
// break_scenes: spoiled scenes and the files they name into ptrace.
// Whatever the scene says: ptrace ends in time with a documented status, an error is one line, no file appears that was
// not there before (nothing a scene says may write), and with status 0 both frames are there, whole and of finite
// pixels. A scene that was only spaced differently must give the same bits.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "campaign.h"
#include "scene_mutations.h"
#include "stream_model.h"

namespace breaking {
namespace {
namespace fs = std::filesystem;

struct File {
    std::string name, bytes;
    bool is(const char* ending) const { return fs::path(name).extension() == ending; }
};

// The files of the tests and their fuzz seeds; those that can be rendered are scenes.
struct Seeds {
    std::vector<File> files;
    std::vector<size_t> scenes;
    std::vector<std::string> texts;  // to take words from
    std::map<std::string, size_t> by_name;
    std::string raypath = ".";
};

Seeds gather() {
    const fs::path tests = LUXPIPE_TESTS;
    std::vector<fs::path> folders{tests / "golden/every", tests / "golden/vectors", tests / "golden/scene",
                                  tests / "golden/cal", tests / "golden/rad_input"};
    for (const auto& entry : fs::directory_iterator(tests / "fuzz/seeds"))
        if (entry.is_directory()) folders.push_back(entry.path());
    std::sort(folders.begin() + 5, folders.end());  // the same trials wherever the tree lies
    Seeds s;
    for (const fs::path& folder : folders) {
        s.raypath += ":" + folder.string();
        for (const std::string& name : files_of(folder.string())) {
            File f{name, read_file((folder / name).string())};
            if (f.bytes.size() > 40000 || f.is(".tsv")) continue;
            if (f.is(".rad") || f.is(".oct") || f.is(".rif")) s.scenes.push_back(s.files.size());
            s.by_name.emplace(name, s.files.size());
            s.texts.push_back(f.bytes);
            s.files.push_back(std::move(f));
        }
    }
    return s;
}

// Files that the scene names, by its words.
std::vector<size_t> named_in(const Seeds& seeds, const std::string& scene) {
    std::vector<size_t> found;
    for (const auto& [name, index] : seeds.by_name)
        if (name.find('.') != std::string::npos && scene.find(name) != std::string::npos) found.push_back(index);
    return found;
}

Job render(const Settings& s, const Seeds& seeds, const File& scene, const std::string& folder, Dice& dice) {
    Stage stage{{s.tool("ptrace"), "-device", "cpu"}};
    const auto add = [&](std::initializer_list<const char*> words) {
        for (const char* w : words) stage.words.push_back(w);
    };
    if (dice.chance(.5)) add({"-vtv", "-vp", "0", "-14", "10", "-vd", "0", "1", "-.7"});
    else add({"-vta", "-vp", ".1", "-2", ".3", "-vd", "0", "1", "0", "-vh", "180", "-vv", "180"});
    add({"-x", "8", "-y", "8", "-ab", "2", "-frames", "2", "-moments-"});  // frames alone
    if (dice.chance(.2)) add({"-ds", ".2"});
    if (dice.chance(.2)) add({"-i+"});
    if (scene.is(".rif")) add({"-rif"});
    stage.words.push_back(scene.name);
    if (bears_little_memory) stage.before = [] { return limit_memory(4096); };
    Job job;
    job.stages = {stage};
    job.folder = folder;
    job.environment = {"RAYPATH=" + seeds.raypath, "HOME=" + folder};
    return job;
}

// Both frames of each view that a rif file names, whole, finite; the pixels' bytes for comparing.
std::string check_frames(const std::string& out, std::vector<double>& pixels) {
    const ModelStream stream = read_stream(out);
    if (stream.end != ModelStream::End::clean || stream.pictures.empty() || stream.pictures.size() % 2 != 0)
        return "status 0, but there are not two whole frames of each view";
    for (const ModelPicture& p : stream.pictures)
        for (const double v : p.rgb) {
            if (!std::isfinite(v)) return "status 0, but a pixel is not finite";
            pixels.push_back(v);
        }
    return "";
}

// The same scene, its words spaced in another way: the same bits, or the same refusal.
Verdict judge_respaced(const Settings& s, Dice& dice, const std::string& folder, const Seeds& seeds, File scene) {
    write_file(folder + "/" + scene.name, scene.bytes);
    const Job job = render(s, seeds, scene, folder, dice);
    const Result before = run_patiently(job, s);
    write_file(folder + "/" + scene.name, respace(scene.bytes, dice));
    const Result after = run_patiently(job, s);
    Verdict v{"spaced differently: status " + std::to_string(after.stages[0].status), complaint(after),
              after.describe()};
    std::vector<double> a, b;
    if (v.find.empty() && before.stages[0].status != after.stages[0].status)
        v.find = "spaced differently, another status";
    if (v.find.empty() && after.stages[0].status == 0) {
        check_frames(before.out, a);
        v.find = check_frames(after.out, b);
        if (v.find.empty() && a != b) v.find = "spaced differently, other pixels";
    }
    return v;
}

Verdict judge(const Settings& s, Dice& dice, const std::string& folder, const Seeds& seeds) {
    File scene = seeds.files[dice.pick(seeds.scenes)];
    if (scene.is(".rad") && dice.chance(.05)) return judge_respaced(s, dice, folder, seeds, scene);
    std::vector<File> files{scene};
    for (const size_t i : named_in(seeds, scene.bytes))
        if (seeds.files[i].name != scene.name) files.push_back(seeds.files[i]);
    std::string how;
    for (int i = dice.chance(.6) ? 1 : dice.within(2, 4); i > 0; --i) {
        File& f = files[dice.chance(.5) ? 0 : dice.below(files.size())];
        how += f.name + ": " + mutate_file(f.bytes, seeds.texts, dice) + "; ";
    }
    std::vector<std::string> names;
    for (const File& f : files) {
        write_file(folder + "/" + f.name, f.bytes);
        names.push_back(f.name);
    }
    std::sort(names.begin(), names.end());
    const Job job = render(s, seeds, scene, folder, dice);
    const Result r = run_patiently(job, s);

    Verdict v;
    v.outcome = "status " + std::to_string(r.stages[0].status);
    v.find = complaint(r);
    v.story = how + "\nRAYPATH=" + seeds.raypath + "\n";
    for (const std::string& w : job.stages[0].words) v.story += w + " ";
    v.story += "\n" + r.describe();
    std::vector<double> pixels;
    if (v.find.empty() && files_of(folder) != names) v.find = "a scene made a file";
    if (v.find.empty() && r.stages[0].status == 0) v.find = check_frames(r.out, pixels);
    return v;
}

}  // namespace
}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 200);
    if (!settings.has("ptrace")) return std::puts("no ptrace here"), 77;
    const Seeds seeds = gather();
    return campaign("break_scenes", settings,
                    [&](Dice& dice, const std::string& folder) { return judge(settings, dice, folder, seeds); });
}
