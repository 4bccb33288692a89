// SPDX-License-Identifier: BSD-3-Clause
// See option_target.h.
#include "base/option_target.h"

#include <fmt/core.h>

#include <cmath>

#include "base/error.h"
#include "base/options.h"
#include "base/text_file.h"
#include "base/value.h"

namespace base {
namespace {

void require_within(const Range& range, double value, const std::string& name) {
    const std::string text = number_text(value);
    if (range.open && value <= range.low) fail(name, text + " is not above " + number_text(range.low));
    if (value >= range.low && value <= range.high) return;
    if (std::isinf(range.high)) fail(name, text + " is below " + number_text(range.low));
    fail(name, fmt::format("{} is outside {} to {}", text, number_text(range.low), number_text(range.high)));
}

std::string shown(const Vec3& v) { return number_text(v.x) + " " + number_text(v.y) + " " + number_text(v.z); }

}  // namespace

Arguments::Arguments(const Option& option, std::vector<std::string> words, std::string scene_file)
    : option_(option), words_(std::move(words)), scene_file_(std::move(scene_file)) {}

const std::string& Arguments::name() const { return option_.name; }

std::string Arguments::file() {
    if (!scene_file_.empty()) require_ordinary_file(words_[at_], scene_file_);
    return text();
}

long Arguments::integer() { return integer(option_.range); }
long Arguments::integer(const Range& range) {
    const long value = to_int(text(), name());
    require_within(range, double(value), name());
    return value;
}

double Arguments::real() { return real(option_.range); }
double Arguments::real(const Range& range) {
    const double value = option_.percent ? to_share(text(), name()) : to_real(text(), name());
    require_within(range, value, name());
    return value;
}

Vec3 Arguments::vec() {
    const double x = real(), y = real();
    return {x, y, real()};
}

size_t Arguments::one_of(const std::vector<std::string>& names) {
    const std::string word = text();
    std::string all;
    for (size_t i = 0; i < names.size(); ++i) {
        if (names[i] == word) return i;
        all += (i ? ", " : "") + names[i];
    }
    fail(name(), "\"" + word + "\" is not one of " + all);
}

Target into(int& value) {
    constexpr Range fits = {std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), false};
    const auto read = [&value, fits](Arguments& a) {
        const long n = a.integer();
        require_within(fits, double(n), a.name());
        value = int(n);
    };
    return {read, [&value] { return std::to_string(value); }, nullptr};
}

Target into(uint64_t& value) {
    return {[&value](Arguments& a) { value = uint64_t(a.integer()); }, [&value] { return std::to_string(value); },
            nullptr};
}

Target into(double& value) {
    return {[&value](Arguments& a) { value = a.real(); }, [&value] { return number_text(value); }, nullptr};
}

Target into(std::optional<double>& value) {
    return {[&value](Arguments& a) { value = a.real(); },
            [&value] { return value ? number_text(*value) : std::string(); }, nullptr};
}

Target into(Vec3& value) {
    return {[&value](Arguments& a) { value = a.vec(); }, [&value] { return shown(value); }, nullptr};
}

Target into(double (&value)[3]) {
    const auto read = [&value](Arguments& a) {
        const Vec3 v = a.vec();
        for (int i = 0; i < 3; ++i) value[i] = v[i];
    };
    return {read, [&value] { return shown({value[0], value[1], value[2]}); }, nullptr};
}

Target into(std::string& value) {
    return {[&value](Arguments& a) { value = a.text(); }, [&value] { return value; }, nullptr};
}

Target into(std::vector<std::string>& values) {
    return into([&values](Arguments& a) { values.push_back(a.text()); });
}

Target into(bool& value) {
    return {[&value](Arguments&) { value = true; }, {}, &value};
}

}  // namespace base
