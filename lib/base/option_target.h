// SPDX-License-Identifier: BSD-3-Clause
// Where the value of an option goes, how it is read and how it is shown again (options.h).
#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace base {

struct Option;

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool open = false;  // low itself is too low
};
inline Range within(double low, double high) { return {low, high, false}; }
inline Range above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }

// The arguments of one option, taken one after another.  Throws Error (place: the option) for what does not fit.
class Arguments {
public:
    Arguments(const Option& option, std::vector<std::string> words, std::string scene_file);

    std::string text() { return words_[at_++]; }
    std::string file();  // a name; one that a scene says must be an ordinary file's
    long integer();      // the option's own range and kind of number, unless another range is given
    long integer(const Range& range);
    double real();
    double real(const Range& range);
    Vec3 vec();
    size_t one_of(const std::vector<std::string>& names);  // their index
    const std::string& name() const;                       // the option's, for messages

private:
    const Option& option_;
    std::vector<std::string> words_;
    std::string scene_file_;
    size_t at_ = 0;
};

struct Target {
    std::function<void(Arguments&)> read;
    std::function<std::string()> show;  // the value as arguments; none: nothing to show
    bool* toggle = nullptr;             // of a switch, -i[+-]
};

Target into(int& value);
Target into(uint64_t& value);
Target into(double& value);
Target into(std::optional<double>& value);
Target into(Vec3& value);
Target into(double (&value)[3]);
Target into(std::string& value);
Target into(std::vector<std::string>& values);  // each time one more
Target into(bool& value);                       // -exec turns it on; as -i[+-] it is a switch
inline Target into(Target target) { return target; }

template <class Function, class = std::enable_if_t<std::is_invocable_v<Function, Arguments&>>>
Target into(Function read) {
    return {std::move(read), {}, nullptr};
}

// -x: sets the variable to this.
template <class T>
Target set(T& variable, T value) {
    return into([&variable, value](Arguments&) { variable = value; });
}

// -format name: one of these words.
template <class T>
Target one_of(T& variable, std::vector<std::pair<std::string, T>> choices) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    const auto show = [&variable, choices] {
        for (const auto& [name, value] : choices)
            if (value == variable) return name;
        return std::string();
    };
    return {[&variable, choices, names](Arguments& a) { variable = choices[a.one_of(names)].second; }, show, nullptr};
}

}  // namespace base
