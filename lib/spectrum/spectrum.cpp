// SPDX-License-Identifier: BSD-3-Clause
// See spectrum.h.
#include "spectrum/spectrum.h"

#include <fmt/core.h>
#include <pugixml.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/text_file.h"

namespace spectrum {

Spectrum sampled(const std::function<double(double nm)>& f) {
    Spectrum s;
    for (size_t i = 0; i < s.size(); i++) s[i] = f(first_nm + double(i));
    return s;
}

Spectrum of_table(const double* values, int step) {
    Spectrum s;
    for (size_t i = 0; i < s.size(); i++) {
        const size_t k = std::min(i, s.size() - 2) / size_t(step);
        const double t = double(i) / step - double(k);
        s[i] = t == 0 ? values[k] : values[k] + t * (values[k + 1] - values[k]);
    }
    return s;
}

Spectrum of_samples(const std::vector<double>& nm, const std::vector<double>& values, const std::string& place) {
    if (nm.size() < 2) base::fail(place, "a spectrum needs two values at least");
    for (size_t i = 0; i < nm.size(); i++) {
        if (values[i] < 0)
            base::fail(place, fmt::format("a spectrum is not negative: {:g} at {:g} nm", values[i], nm[i]));
        if (i > 0 && nm[i] <= nm[i - 1])
            base::fail(place, fmt::format("wavelengths ascend, but {:g} nm follows {:g} nm", nm[i], nm[i - 1]));
    }
    if (nm.back() < first_nm || nm.front() > last_nm)
        base::fail(place, fmt::format("{:g} to {:g} nm is outside of 380 to 780 nm", nm.front(), nm.back()));
    return sampled([&](double at) {
        const size_t above = size_t(std::upper_bound(nm.begin(), nm.end(), at) - nm.begin());
        if (above == 0 || (above == nm.size() && at > nm.back())) return 0.;
        const size_t i = std::min(above, nm.size() - 1) - 1;
        return values[i] + (values[i + 1] - values[i]) * (at - nm[i]) / (nm[i + 1] - nm[i]);
    });
}

// IES TM-27-14: <IESTM2714><SpectralDistribution><SpectralData wavelength="400">.1</SpectralData> ...
static Spectrum read_spdx(const std::string& text, const std::string& path) {
    pugi::xml_document document;
    const pugi::xml_parse_result read =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_trim_pcdata);
    if (!read) base::fail(path, fmt::format("no XML: {} at byte {}", read.description(), read.offset));
    std::vector<double> nm, values;
    for (pugi::xml_node data : document.document_element().child("SpectralDistribution").children("SpectralData")) {
        const std::string words[2] = {data.attribute("wavelength").value(), data.child_value()};
        double numbers[2];
        for (int i = 0; i < 2; i++)
            if (!base::parse_real(words[i], numbers[i]))
                base::fail(path,
                           fmt::format("SpectralData {}: \"{}\" is no number", nm.size() + 1, base::excerpt(words[i])));
        nm.push_back(numbers[0]);
        values.push_back(numbers[1]);
    }
    return of_samples(nm, values, path);
}

Spectrum read_spectrum(const std::string& path, const base::Opener& by) {
    const std::string whole = base::read_text_file(path, size_t(16) << 20, by);
    const size_t begin = whole.find_first_not_of(" \t\r\n\xef\xbb\xbf");  // behind a byte order mark
    if (begin != std::string::npos && whole[begin] == '<') return read_spdx(whole, path);
    std::istringstream text(whole);
    std::vector<double> nm, values;
    std::string line;
    for (int number = 1; std::getline(text, line); number++) {
        line.resize(std::min(line.find('#'), line.size()));
        std::replace_if(
            line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
        const std::vector<std::string> words = base::split_words(line);
        double wavelength, value;
        if (words.empty() || (nm.empty() && !base::parse_real(words[0], wavelength))) continue;
        const std::string place = fmt::format("{}:{}", path, number);
        if (words.size() < 2 || !base::parse_real(words[0], wavelength) || !base::parse_real(words[1], value))
            base::fail(place, "needs a wavelength in nm and a value");
        nm.push_back(wavelength);
        values.push_back(value);
    }
    return of_samples(nm, values, path);
}

double dot(const Spectrum& a, const Spectrum& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.); }

}  // namespace spectrum
