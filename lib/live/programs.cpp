// SPDX-License-Identifier: BSD-3-Clause
// See programs.h.
#include "live/programs.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "base/child.h"
#include "base/descriptor.h"
#include "base/error.h"
#include "base/run.h"
#include "live/child.h"
#include "live/framer.h"

namespace live {

namespace {

constexpr size_t block_size = 1 << 18;

struct Program {
    std::string name;
    pid_t pid = -1;
    int status = 0;
    Program(const Words& words, const base::ChildFiles& files) {
        for (const std::string& word : words)
            if (word == "ptrace" || word == "ptaccum" || word == "vcmetrics") name = word;
        if (name.empty()) name = words[0];
        if (const int code = base::start_child(words, files, pid)) {
            pid = -1;
            status = int(base::Kind::system);
            base::say("vcview: " + words[0] + ": cannot be started: " + std::strerror(code));
        }
    }
    bool has_ended() const {
        siginfo_t info = {};
        return pid < 0 || (waitid(P_PID, id_t(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0);
    }
    void wait() {
        if (pid >= 0) status = base::wait_for_child(std::exchange(pid, -1));
    }
    // Else it has said itself why.
    std::string why() const {
        return status > 128 ? name + " was ended by signal " + std::to_string(status - 128) : "";
    }
};

}  // namespace

void read_lines(int descriptor, const std::function<bool(const std::string&)>& take) {
    char block[1 << 14];
    std::string line;
    for (ssize_t n; (n = base::read_some(descriptor, block, sizeof block)) > 0;)
        for (const char* c = block; c != block + n; ++c) {
            if (*c != '\n') line += *c;
            else if (!take(std::exchange(line, ""))) return;
        }
    if (!line.empty()) take(line);
}

Programs::Programs(Which which, Command command, Live& live, std::function<void()> ended)
    : which_(which), command_(std::move(command)), live_(live), ended_(std::move(ended)), worker_([this] {
          try {
              run();
          } catch (const base::Error& e) {
              live_.put(Ended{which_, e.text, int(e.kind)});
              ended_();
          }
      }) {}

Programs::~Programs() {
    ends_ = true;
    end_render();
}

void Programs::start() {
    commands_.to(-1);
    worker_.ask();
}

// It finishes its frame; the others end with their input.
void Programs::end_render() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (render_ < 0) return;
    kill(render_, SIGTERM);
    kill(render_, SIGCONT);
}

// Until the sums end, or nobody measures them any more.
void Programs::pass_sums(int sums, int measure) {
    std::vector<char> block(block_size);
    Framer framer([this](image::Picture p) { live_.put_picture(which_, std::move(p)); });
    for (ssize_t n; (n = base::read_some(sums, block.data(), block.size())) > 0;) {
        framer.pass(block.data(), size_t(n));
        if (!base::write_all(measure, block.data(), size_t(n))) return;
    }
}

// The rows of the picture are ours as well.
bool Programs::take_row(const std::string& line) {
    const std::string known = live_.put_line(which_, line) + "\n";
    if (which_ == Which::picture) base::write_all(1, known.data(), known.size());
    return true;
}

void Programs::run() {
    Channel control, frames, sums, to_measure, rows, said;
    Program render(command_.render, {control.out.fd, frames.in.fd, said.in.fd, true});
    Program sum(command_.sum, {frames.out.fd, sums.in.fd, said.in.fd, true});
    std::optional<Program> measure;
    if (!command_.measure.empty())
        measure.emplace(command_.measure, base::ChildFiles{to_measure.out.fd, rows.in.fd, said.in.fd, true});
    for (End* theirs : {&control.out, &frames.out, &frames.in, &sums.in, &to_measure.out, &rows.in, &said.in})
        theirs->leave();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        render_ = render.pid;
    }
    if (ends_) end_render();
    commands_.to(std::exchange(control.in.fd, -1));
    std::thread sayings([&] {
        read_lines(said.out.fd, [this](const std::string& line) { return live_.put_said(which_, line), true; });
    });
    std::thread numbers([&] { read_lines(rows.out.fd, [this](const std::string& line) { return take_row(line); }); });
    if (measure) pass_sums(sums.out.fd, to_measure.in.fd);
    else sum.wait();
    sums.out.leave();
    to_measure.in.leave();
    // who has ended by itself is to blame
    for (int k = 0; k < 50 && !render.has_ended(); ++k) usleep(10'000);
    const bool by_itself = render.has_ended();
    end_render();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        render_ = -1;
    }
    render.wait();
    if (!by_itself) render.status = 0;
    sum.wait();
    if (measure) measure->wait();
    numbers.join();
    sayings.join();
    commands_.to(-1);
    if (ends_) return;
    int status = render.status;  // of the last that failed
    std::string why = render.why();
    for (const Program* p : {&sum, measure ? &*measure : &sum}) {
        if (p->status) status = p->status;
        if (why.empty()) why = p->why();
    }
    live_.put(Ended{which_, why, status});
    ended_();
}

}  // namespace live
