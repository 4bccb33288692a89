// SPDX-License-Identifier: BSD-3-Clause
// See sources.h.
#include "live/sources.h"

#include <algorithm>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/split.h"
#include "image/stream.h"
#include "live/child.h"

namespace live {

std::vector<std::string> sources_command(const std::vector<std::string>& command) {
    std::vector<std::string> out{"vcmetrics"};
    if (!command.empty() && command[0].substr(command[0].rfind('/') + 1) == "vcmetrics") {
        out[0] = command[0];
        for (size_t k = 1; k < command.size(); ++k) {
            std::string word = command[k];
            if (base::begins_with(word, "--")) word.erase(0, 1);
            const std::string name = word.substr(0, word.find('='));
            static const char* const with_value[] = {"-until",       "-ci",      "-control", "-max-frames",
                                                     "-max-seconds", "-format",  "-metrics", "-cr",
                                                     "-c",           "-against", "-over"};
            if (name == "-go-on") continue;
            if (std::find(std::begin(with_value), std::end(with_value), name) == std::end(with_value))
                out.push_back(command[k]);
            else if (name == word) ++k;  // its value is the next word
        }
    }
    out.insert(out.end(), {"-sources", "-outlines", "-format", "jsonl", "-W-"});
    return out;
}

Sources::Sources(const Live& live, std::vector<std::string> command, std::function<void()> found)
    : live_(live), command_(std::move(command)), found_call_(std::move(found)), thread_([this] { work(); }) {}

Sources::~Sources() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    asked_.notify_all();
    thread_.join();
}

std::optional<Sources::Found> Sources::of(size_t picture) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (found_.picture > 0 && found_.picture >= picture) return found_;
    wanted_ = true;
    asked_.notify_all();
    return std::nullopt;
}

void Sources::work() {
    for (;;) {
        {
            std::unique_lock<std::mutex> lock(mutex_);
            asked_.wait(lock, [this] { return wanted_ || ends_; });
            if (ends_) return;
            wanted_ = false;
        }
        Found found = measure();
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            found_ = std::move(found);
        }
        found_call_();
    }
}

Sources::Found Sources::measure() const {
    const auto news = live_.since({}, true);
    if (!news || !news->shown) return {};
    Found found;
    found.picture = news->picture;
    try {
        Child child(command_, -1);
        const std::string bytes = image::picture_bytes(*news->shown, image::Format::flt);
        base::write_all(child.input(), bytes.data(), bytes.size());
        child.close_input();
        char block[1 << 14];
        for (ssize_t n; (n = base::read_some(child.output(), block, sizeof block)) > 0;)
            found.lines.append(block, size_t(n));
        found.status = child.wait();
    } catch (const base::Error&) {
        found.status = int(base::Kind::system);
    }
    return found;
}

}  // namespace live
