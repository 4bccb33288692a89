// SPDX-License-Identifier: BSD-3-Clause
// Starting and judging programs: see child.h.  stdout of the last stage goes to a file in memory, stderr to pipes that
// hold a megabyte: nobody waits for us while we wait for them.
#include "child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

namespace breaking {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int unavailable_status = 120;  // of a child whose fault could not be had

[[noreturn]] void die(const char* what) {
    std::perror(what);
    std::exit(2);
}

std::string read_all(int fd) {
    std::string all;
    char buffer[65536];
    for (ssize_t n; (n = read(fd, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR);)
        if (n > 0) all.append(buffer, size_t(n));
    return all;
}

struct Pipe {
    int ends[2];
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) die("pipe");
    }
    void shut(int end) {
        if (ends[end] >= 0) close(ends[end]);
        ends[end] = -1;
    }
    ~Pipe() { shut(0), shut(1); }
};

// Only calls that are safe after fork(), but for the fault itself: this program has one thread.
[[noreturn]] void become(const Job& job, const Stage& stage, int in, int out, int err, pid_t group) {
    setpgid(0, group);
    if (dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(unavailable_status);
    if (!job.folder.empty() && chdir(job.folder.c_str()) != 0) _exit(unavailable_status);
    std::vector<char*> words, environment;
    for (const std::string& w : stage.words) words.push_back(const_cast<char*>(w.c_str()));
    for (const std::string& e : job.environment) environment.push_back(const_cast<char*>(e.c_str()));
    for (char** e = environ; *e; ++e)
        if (std::strstr(*e, "SAN_OPTIONS=")) environment.push_back(*e);  // of a build with sanitizers
    words.push_back(nullptr);
    environment.push_back(nullptr);
    if (stage.before && !stage.before()) _exit(unavailable_status);
    execve(words[0], words.data(), environment.data());
    _exit(unavailable_status);
}

// The input by a pipe, written whole before anybody reads: so it must fit in the pipe's buffer.
class Feeder {
public:
    explicit Feeder(const std::string& input) {
        fcntl(pipe_.ends[1], F_SETPIPE_SZ, 1 << 20);
        fcntl(pipe_.ends[1], F_SETFL, O_NONBLOCK);
        const ssize_t n = input.empty() ? 0 : write(pipe_.ends[1], input.data(), input.size());
        if (n != ssize_t(input.size())) die("the input does not fit in a pipe");
        pipe_.shut(1);
    }
    int end() const { return pipe_.ends[0]; }
    void started() { pipe_.shut(0); }

private:
    Pipe pipe_;
};

// Waits until the process has ended or the time is over; true if it ended.
bool wait_until(pid_t pid, Clock::time_point when, int& how) {
    const int fd = int(syscall(SYS_pidfd_open, pid, 0));
    for (;;) {
        if (waitpid(pid, &how, WNOHANG) == pid) return close(fd), true;
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(when - Clock::now()).count();
        if (left <= 0) return close(fd), false;
        struct pollfd p = {fd, POLLIN, 0};
        poll(&p, fd >= 0 ? 1 : 0, fd >= 0 ? int(left) : 5);
    }
}

// Has the group no member left?  One that was just orphaned may need a moment to go.
bool is_gone(pid_t group) {
    for (int i = 0; i < 100; ++i) {
        if (kill(-group, 0) != 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

bool is_documented(const std::string& tool, int status) { return status <= 3 || (tool == "vcmetrics" && status <= 5); }

// Plain text: no control characters that would reach a terminal.
bool is_plain(const std::string& line) {
    for (unsigned char c : line)
        if ((c < 32 && c != '\t') || c == 127) return false;
    return true;
}

}  // namespace

Result run(const Job& job) {
    Result result;
    const size_t count = job.stages.size();
    Feeder feeder(job.input);
    const int out = memfd_create("stdout", MFD_CLOEXEC);
    if (out < 0) die("memfd_create");
    std::vector<Pipe> talk(count), between(count - 1);
    std::vector<pid_t> pids;
    for (size_t i = 0; i < count; ++i) {
        fcntl(talk[i].ends[1], F_SETPIPE_SZ, 1 << 20);
        const int in = i == 0 ? feeder.end() : between[i - 1].ends[0];
        const int to = i + 1 == count ? out : between[i].ends[1];
        const pid_t group = pids.empty() ? 0 : pids[0];
        const pid_t pid = fork();
        if (pid < 0) die("fork");
        if (pid == 0) become(job, job.stages[i], in, to, talk[i].ends[1], group);
        setpgid(pid, group ? group : pid);
        pids.push_back(pid);
    }
    feeder.started();
    for (Pipe& p : between) p.shut(0), p.shut(1);
    for (Pipe& p : talk) p.shut(1);
    if (job.meanwhile) job.meanwhile(pids);

    const auto end = Clock::now() + std::chrono::microseconds(int64_t(job.limit_s * 1e6));
    for (size_t i = 0; i < count; ++i) {
        Ended e;
        const std::string& path = job.stages[i].words[0];
        e.tool = path.substr(path.rfind('/') + 1);
        int how = 0;
        if (!wait_until(pids[i], end, how)) {
            e.hung = true;
            kill(-pids[0], SIGKILL);
            waitpid(pids[i], &how, 0);
        }
        if (WIFEXITED(how)) e.status = WEXITSTATUS(how);
        else e.signal = WTERMSIG(how);
        e.unavailable = e.status == unavailable_status;
        for (const Ended& before : result.stages) e.behind_error |= before.status == 1 || before.status == 2;
        result.stages.push_back(e);
    }
    if (!is_gone(pids[0])) {
        result.left_children = true;
        kill(-pids[0], SIGKILL);
    }
    for (size_t i = 0; i < count; ++i) result.stages[i].talk = read_all(talk[i].ends[0]);
    lseek(out, 0, SEEK_SET);
    result.out = read_all(out);
    close(out);
    return result;
}

bool Result::hung() const {
    for (const Ended& e : stages)
        if (e.hung) return true;
    return false;
}

bool Result::unavailable() const {
    for (const Ended& e : stages)
        if (e.unavailable) return true;
    return false;
}

std::string Result::describe() const {
    std::ostringstream text;
    for (const Ended& e : stages) {
        text << e.tool << ": ";
        if (e.signal) text << "signal " << e.signal;
        else text << "status " << e.status;
        text << "\n" << e.talk;
    }
    return text.str();
}

bool limit_memory(size_t megabytes) {
    const struct rlimit limit = {megabytes << 20, megabytes << 20};
    return setrlimit(RLIMIT_AS, &limit) == 0;
}

std::string complaint(const Ended& e) {
    if (e.hung) return e.tool + " does not end";
    if (e.talk.find("Sanitizer") != std::string::npos || e.talk.find("runtime error:") != std::string::npos)
        return e.tool + ": a sanitizer reports";
    if (e.signal) return e.tool + " died of signal " + std::to_string(e.signal);
    if (!is_documented(e.tool, e.status))
        return e.tool + ": status " + std::to_string(e.status) + " is in no manual page";
    int errors = 0;
    std::istringstream lines(e.talk);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, e.tool.size() + 2, e.tool + ": ") != 0)
            return e.tool + " says a line without its name: " + line;
        if (!is_plain(line)) return e.tool + ": control characters in its talk";
        if (line.compare(e.tool.size() + 2, 9, "warning: ") != 0) ++errors;
    }
    if (e.status == 0 && errors) return e.tool + ": an error, but status 0";
    const bool is_told = e.behind_error && e.status == 1 && errors == 0;
    if ((e.status == 1 || e.status == 2) && errors != 1 && !is_told)
        return e.tool + ": " + std::to_string(errors) + " lines for an error, not one";
    return "";
}

std::string complaint(const Result& result) {
    for (const Ended& e : result.stages) {
        const std::string text = complaint(e);
        if (!text.empty()) return text;
    }
    return result.left_children ? "a process lives on" : "";
}

}  // namespace breaking
