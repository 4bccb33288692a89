// SPDX-License-Identifier: BSD-3-Clause
// See fingerprint.h.
#include "film/fingerprint.h"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "base/error.h"

namespace film {
namespace {

std::map<std::string, std::string> parts_of(const std::string& fingerprint) {
    std::map<std::string, std::string> parts;
    std::istringstream in(fingerprint);
    for (std::string word; in >> word;) parts[word.substr(0, word.find(':'))] = word;
    return parts;
}

std::string what_weights(const image::Header& h) {
    return h.action ? fmt::format("action {} of {} bands in {}", h.action->name, h.action->bands, h.action->unit)
                    : "no action (ACTION=)";
}

}  // namespace

void require_same_action(const image::Header& header, const image::Header& other, const std::string& place,
                         const std::string& of) {
    if (header.action == other.action) return;
    base::fail(place, fmt::format("has {}, {} has {}: they cannot be combined into one picture", what_weights(header),
                                  of, what_weights(other)));
}

void require_same_fingerprint(const image::Header& header, const image::Header& other, const std::string& place,
                              const std::string& of) {
    if (header.fingerprint == other.fingerprint) return;
    if (header.fingerprint.empty() || other.fingerprint.empty()) {
        base::warn(place, "cannot tell whether scene and options are the same as in " + of + " (no FINGERPRINT= line)");
        return;
    }
    auto mine = parts_of(header.fingerprint), theirs = parts_of(other.fingerprint);
    const auto differs = [&](const char* part) { return mine[part] != theirs[part]; };
    std::string what;
    if (differs("estimator")) what = "another version of ptrace's estimator";
    else if (differs("options")) what = differs("scene") ? "other options, perhaps another scene," : "other options";
    else if (differs("scene")) what = "another scene";
    else if (differs("view")) what = "another view or size";
    else if (differs("device")) what = "the bits of another device";
    else what = "another fingerprint";
    base::fail(place, "has " + what + " than " + of + ": they cannot be combined into one picture");
}

}  // namespace film
