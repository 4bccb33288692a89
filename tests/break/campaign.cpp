// SPDX-License-Identifier: BSD-3-Clause
// Options, the loop, the table and the finds of a campaign: see campaign.h.
#include "campaign.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace breaking {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void give_up(const std::string& text) {
    std::fprintf(stderr, "%s\n", text.c_str());
    std::exit(2);
}

std::string own_folder() {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    if (error) give_up("/proc/self/exe: " + error.message());
    return self.parent_path().string();
}

// In memory where that can be had: thousands of small folders.
std::string fresh_folder() {
    const fs::path base = access("/dev/shm", W_OK) == 0 ? fs::path("/dev/shm") : fs::temp_directory_path();
    std::string name = (base / "luxpipe-break.XXXXXX").string();
    if (!mkdtemp(name.data())) give_up(name + ": no folder can be made there");
    fs::permissions(name, fs::perms(0755));
    return name;
}

void empty(const std::string& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
}

}  // namespace

bool Settings::has(const std::string& name) const { return access(tool(name).c_str(), X_OK) == 0; }

Settings parse_settings(int argc, char** argv, uint64_t tries) {
    Settings s;
    s.tries = tries;
    s.bin = own_folder();
    s.keep = fs::path(s.bin).parent_path() / "break-finds";
    for (int i = 1; i < argc; i += 2) {
        const std::string option = argv[i];
        if (i + 1 == argc) give_up(option + ": a value is missing");
        const char* value = argv[i + 1];
        if (option == "-tries") s.tries = std::strtoull(value, nullptr, 10);
        else if (option == "-seed") s.seed = std::strtoull(value, nullptr, 10);
        else if (option == "-only") s.only = std::atol(value);
        else if (option == "-limit") s.limit_s = std::atof(value);
        else if (option == "-keep") s.keep = value;
        else give_up(option + ": is not one of -tries -seed -only -limit -keep");
    }
    s.keep = fs::absolute(s.keep).string();
    signal(SIGPIPE, SIG_IGN);
    return s;
}

int campaign(const char* name, const Settings& settings, const Trial& trial) {
    const std::string folder = fresh_folder();
    std::map<std::string, uint64_t> outcomes;
    uint64_t finds = 0, done = 0;
    const uint64_t first = settings.tells() ? uint64_t(settings.only) : 0;
    const uint64_t end = settings.tells() ? first + 1 : settings.tries;
    for (uint64_t k = first; k < end; ++k, ++done) {
        Dice dice(settings.seed, k);
        const Verdict verdict = trial(dice, folder);
        ++outcomes[verdict.outcome];
        if (settings.tells()) std::printf("%s\n%s\n", verdict.outcome.c_str(), verdict.story.c_str());
        if (!verdict.find.empty()) {
            ++finds;
            const std::string kept =
                settings.keep + "/" + name + "-" + std::to_string(settings.seed) + "-" + std::to_string(k);
            fs::create_directories(kept);
            fs::copy(folder, kept, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
            write_file(kept + "/story", verdict.find + "\n" + verdict.story);
            std::printf("FIND: trial %llu: %s (%s)\n", static_cast<unsigned long long>(k), verdict.find.c_str(),
                        kept.c_str());
            std::fflush(stdout);
        }
        empty(folder);
    }
    fs::remove_all(folder);
    std::printf("%s: seed %llu, %llu trials, %llu finds\n", name, static_cast<unsigned long long>(settings.seed),
                static_cast<unsigned long long>(done), static_cast<unsigned long long>(finds));
    for (const auto& [outcome, count] : outcomes)
        std::printf("%8llu  %s\n", static_cast<unsigned long long>(count), outcome.c_str());
    return finds ? 1 : 0;
}

Result run_patiently(Job job, const Settings& settings) {
    job.limit_s = settings.limit_s;
    Result result = run(job);
    if (!result.hung()) return result;
    job.limit_s *= 4;
    return run(job);
}

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) give_up(path + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write_file(const std::string& path, const std::string& bytes) {
    std::ofstream out(path, std::ios::binary);
    out << bytes;
    if (!out.flush()) give_up(path + ": cannot be written");
}

std::vector<std::string> files_of(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace breaking
