// SPDX-License-Identifier: BSD-3-Clause
// break_edits: after any edits the frames are those of a ptrace of its own, bit by bit, fingerprint too.
// A trial is a row of random edits of one ptrace -watch -control: files saved in the ways of editors, broken and
// mended, touched, come into being earlier on RAYPATH; overlays; views, options, sizes, previews.  A model of what they
// mean makes the folder and the words of the second ptrace.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "campaign.h"

namespace breaking {
namespace {

using Clock = std::chrono::steady_clock;
using Files = std::map<std::string, std::string>;

struct Frame {
    std::string header, pixels;
    std::string line(const std::string& name) const {
        const size_t at = header.find("\n" + name);
        return at == std::string::npos ? "" : header.substr(at + 1, header.find('\n', at + 1) - at - 1);
    }
};

// Takes the frames off the beginning of a stream.
std::vector<Frame> take_frames(std::string& stream) {
    std::vector<Frame> frames;
    for (size_t at = 0;;) {
        const size_t blank = stream.find("\n\n", at);
        const size_t end = blank == std::string::npos ? blank : stream.find('\n', blank + 2);
        if (end == std::string::npos) return stream.erase(0, at), frames;
        int nx = 0, ny = 0;
        if (std::sscanf(&stream[blank + 2], "-Y %d +X %d", &ny, &nx) != 2) return frames;
        const size_t bytes = size_t(12) * size_t(nx) * size_t(ny);
        if (stream.size() < end + 1 + bytes) return stream.erase(0, at), frames;
        frames.push_back({stream.substr(at, blank - at + 1), stream.substr(end + 1, bytes)});
        at = end + 1 + bytes;
    }
}

// A ptrace whose stream is read by a thread: the first frames of its present picture.
class Live {
public:
    static constexpr size_t enough = 4;
    Live(const std::vector<std::string>& words, const std::string& folder, const std::string& raypath) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) std::exit(2);
        pid_ = fork();
        if (pid_ == 0) {
            std::vector<char*> argv;
            for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
            argv.push_back(nullptr);
            dup2(ends[1], 1);
            dup2(open((folder + "/said").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
            setenv("RAYPATH", raypath.c_str(), 1);
            setenv("LUXPIPE_THREADS", "2", 1);
            if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
            _exit(127);
        }
        close(ends[1]);
        thread_ = std::thread([this, from = ends[0]] { read_stream(from); });
    }
    ~Live() {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        thread_.join();
    }
    std::vector<Frame> picture() {
        const std::lock_guard<std::mutex> hold(lock_);
        return picture_;
    }
    // Waits for a picture of which the test is true.
    template <class Test>
    bool wait_for(double limit_s, Test&& test) {
        for (const auto begin = Clock::now(); Clock::now() - begin < std::chrono::duration<double>(limit_s);) {
            if (test(picture())) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }

private:
    void read_stream(int from) {
        std::string stream;
        char block[1 << 16];
        for (ssize_t n; (n = read(from, block, sizeof block)) > 0;) {
            stream.append(block, size_t(n));
            const std::lock_guard<std::mutex> hold(lock_);
            for (Frame& f : take_frames(stream)) {
                if (f.line("FRAME=") == "FRAME=0") picture_.clear();
                if (picture_.size() < enough) picture_.push_back(std::move(f));
            }
        }
        close(from);
    }
    pid_t pid_;
    std::thread thread_;
    std::mutex lock_;
    std::vector<Frame> picture_;
};

// A model and what was asked of its picture.
struct Model {
    Files files;                                 // on disk
    Files overlays;                              // in memory
    std::map<std::string, std::string> options;  // set, view and size
    std::set<std::string> broken;
};

const char* const room =
    "wall ring floor 0 0 8 0 0 0 0 0 1 0 4\nwall polygon back 0 0 12 -4 4 0 4 4 0 4 4 3 -4 4 3\n"
    "tinted sphere ball 0 0 4 0 1 .5 .5\npane polygon window 0 0 12 -4 -4 0 -4 4 0 -4 4 3 -4 -4 3\n";

std::string text_of(const std::string& name, Dice& dice) {
    const std::string n = std::to_string(dice.within(1, 9));
    if (name == "f.cal" || name == "first/f.cal") return "v = ." + n + ";\n";
    if (name == "d.dat") return "1\n-4 4 3\n." + n + " .5 .8\n";
    if (name == "inner.rad") {
        const std::string more = "wall sphere more 0 0 4 -1 1 .5 ." + n + "\n";
        return room + (dice.chance(.5) ? more : "");
    }
    if (name == "s.rad")
        return "!xform -t 0 0 0 inner.rad\nvoid light l 0 0 3 3e5 3e5 " + n + "e5\nl source sun 0 0 4 .5 -.5 .7 .5\n" +
               "void glow g 0 0 4 " + n + " 1 1 0\ng source sky 0 0 4 0 0 1 180\n";
    return "void brightfunc p\n2 v f.cal\n0\n0\np plastic wall 0 0 5 .5 .5 ." + n + " 0 0\n" +
           "void brightdata q\n4 noop d.dat . Px\n0\n0\nq plastic tinted 0 0 5 .6 .5 .4 .0" + n + " .1\n" +
           "void glass pane 0 0 3 .9 .9 ." + n + "\n";
}

void save(const std::string& path, const std::string& text, Dice& dice) {
    switch (dice.below(4)) {
    case 0: return write_file(path, text);
    case 1:  // as sed -i
        write_file(path + ".new", text);
        rename((path + ".new").c_str(), path.c_str());
        return;
    case 2:  // as vim
        rename(path.c_str(), (path + "~").c_str());
        if (dice.chance(.5)) std::this_thread::sleep_for(std::chrono::milliseconds(40));
        return write_file(path, text);
    default:  // cut, and written a while later
        write_file(path, "");
        std::this_thread::sleep_for(std::chrono::milliseconds(dice.within(0, 60)));
        return write_file(path, text);
    }
}

class Trialer {
public:
    Trialer(const Settings& settings, Dice& dice, const std::string& folder)
        : settings_(settings), dice_(dice), folder_(folder) {}

    Verdict run() {
        mkdir((folder_ + "/first").c_str(), 0700);
        mkfifo((folder_ + "/ctl").c_str(), 0600);
        control_ = open((folder_ + "/ctl").c_str(), O_RDWR | O_CLOEXEC);
        for (const char* name : {"m.rad", "s.rad", "inner.rad", "f.cal", "d.dat"}) write(name, text_of(name, dice_));
        model_.options = {{"-vp", "0 -3.5 1.5"}, {"-x", "16"}, {"-y", "16"}};
        Live live(words({"-watch", "-control", "ctl"}), folder_, "first:.");
        live_ = &live;
        Verdict v;
        bool fine = live.wait_for(settings_.limit_s, [](const auto& p) { return p.size() > 1; });
        for (int edits = dice_.within(3, 8); fine && edits > 0; edits--) fine = edit();
        for (const std::string& name : std::set<std::string>(model_.broken)) mend(name);
        v.outcome = "equal frames";
        if (!fine || !sync()) v.find = "an edit was not carried out";
        else v.find = difference();
        v.story = story_ + "\nptrace said: " + read_file(folder_ + "/said");
        close(control_);
        unlink((folder_ + "/ctl").c_str());  // a find is copied
        return v;
    }

private:
    void tell(const std::string& text) {
        story_ += text.substr(0, 200) + (text.empty() || text.back() != '\n' ? "\n" : "");
        if (::write(control_, text.data(), text.size()) < 0) std::exit(2);
    }
    void write(const std::string& name, const std::string& text) {
        story_ += "write " + name + ": " + text + "\n";
        model_.files[name] = text;
        model_.overlays.erase(name);
        save(folder_ + "/" + name, text, dice_);
    }
    void mend(const std::string& name) {
        model_.broken.erase(name);
        write(name, text_of(name, dice_));
    }
    std::vector<std::string> words(std::vector<std::string> more) const {
        std::vector<std::string> all = {settings_.tool("ptrace"), "-w-", "-moments-", "-device", "cpu"};
        for (const char* w : {"-vd", "0", "1", "-.2", "-vh", "60", "-vv", "60"}) all.push_back(w);
        for (const auto& [option, value] : model_.options) {
            all.push_back(option);
            for (const std::string& w : choices(value))
                if (!w.empty()) all.push_back(w);
        }
        all.insert(all.end(), more.begin(), more.end());
        all.insert(all.end(), {"m.rad", "s.rad"});
        return all;
    }
    // A view that was not asked for yet, and waits until it is there: all lines before it have been carried out.
    bool sync() {
        const std::string eye = "0." + std::to_string(++syncs_) + dice_.pick(choices("1 2 3")) + " -3.5 1.5";
        model_.options["-vp"] = eye;
        tell("view -vp " + eye + "\n");
        return live_->wait_for(settings_.limit_s, [&](const auto& p) {
            return !p.empty() && p[0].header.find(" -vp " + eye) != std::string::npos;
        });
    }
    bool overlay(const std::string& name, const std::string& text) {
        if (!sync()) return false;
        tell("overlay " + name + " " + std::to_string(text.size()) + "\n" + text);
        if (!model_.files.count(name)) return true;
        model_.overlays[name] = text;
        return sync();  // it is of the file as it is now
    }
    bool edit() {
        static const std::vector<std::string> names = choices("m.rad s.rad inner.rad f.cal d.dat first/f.cal");
        const std::string name = dice_.pick(names);
        switch (dice_.below(9)) {
        case 0:
        case 1: mend(name); break;
        case 2:
            if (!model_.files.count(name)) break;
            model_.broken.insert(name);
            write(name, dice_.pick(choices("wall sphere|v = (|wal ring r 0 0 8 0 0 0 0 0 1 0 3", '|')));
            break;
        case 3:
            if (!model_.files.count(name)) break;
            model_.overlays.erase(name);
            utimensat(AT_FDCWD, (folder_ + "/" + name).c_str(), nullptr, 0);
            break;
        case 4: return overlay(name, text_of(name, dice_));
        case 5:
            tell("overlay " + name + " -\n");
            model_.overlays.erase(name);
            return sync();
        case 6: {
            static const std::vector<std::string> sets =
                choices("-ab 1|-ab 3|-dr 0|-dr 1|-dj 0|-lw .1|-st .1|-bv-|-bv+|-pj 0", '|');
            const std::string words = dice_.pick(sets);
            const std::string option = words.substr(0, words.find(' '));
            // Options that change tables read the files once more, and are refused where one is broken.
            const bool reads = option == "-dr" || option == words;
            if (reads && !model_.broken.empty()) break;
            tell("set " + words + "\n");
            if (option == words) model_.options.erase(option == "-bv-" ? "-bv+" : "-bv-");
            if (option == words) model_.options[option] = "";
            else model_.options[option] = words.substr(option.size() + 1);
            if (reads) return sync();
            break;
        }
        case 7: {
            const std::string x = std::to_string(dice_.within(8, 20)), y = std::to_string(dice_.within(8, 20));
            model_.options["-x"] = x, model_.options["-y"] = y;
            tell("size " + x + " " + y + "\n");
            break;
        }
        default: tell(dice_.pick(choices("preview -vp 1 -3 1|go|pause|view -vh 400|jump|set -o x|scene", '|')) + "\n");
        }
        if (dice_.chance(.5)) std::this_thread::sleep_for(std::chrono::milliseconds(dice_.within(0, 120)));
        return true;
    }
    // What differs from a ptrace of its own, if it does so for long.
    std::string difference() {
        const std::string own = folder_ + "/own";
        mkdir(own.c_str(), 0700);
        mkdir((own + "/first").c_str(), 0700);
        for (const auto& [name, text] : model_.files) write_file(own + "/" + name, text);
        for (const auto& [name, text] : model_.overlays) write_file(own + "/" + name, text);
        Live alone(words({"-frames", std::to_string(Live::enough)}), own, "first:.");
        const auto all = [](const std::vector<Frame>& p) { return p.size() == Live::enough; };
        if (!alone.wait_for(settings_.limit_s, all)) return "no frames of its own";
        const std::vector<Frame> expected = alone.picture();
        const std::string fingerprint = expected[0].line("FINGERPRINT=");
        const auto same = [&](const auto& p) { return all(p) && p[0].line("FINGERPRINT=") == fingerprint; };
        if (!live_->wait_for(settings_.limit_s, same)) return "another fingerprint than " + fingerprint;
        const std::vector<Frame> found = live_->picture();
        for (size_t k = 0; k < found.size(); k++)
            if (found[k].pixels != expected[k].pixels) return "other bits of frame " + std::to_string(k);
        return "";
    }

    const Settings& settings_;
    Dice& dice_;
    const std::string folder_;
    Model model_;
    Live* live_ = nullptr;
    std::string story_;
    int control_ = -1, syncs_ = 0;
};

}  // namespace
}  // namespace breaking

int main(int argc, char** argv) {
    using namespace breaking;
    const Settings settings = parse_settings(argc, argv, 10);
    return campaign("break_edits", settings,
                    [&](Dice& dice, const std::string& folder) { return Trialer(settings, dice, folder).run(); });
}
