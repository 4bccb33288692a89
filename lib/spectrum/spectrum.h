// SPDX-License-Identifier: BSD-3-Clause
// A spectrum: a value at each nm from 380 to 780.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>
#include "base/open_file.h"

namespace spectrum {

constexpr int first_nm = 380, last_nm = 780;
using Spectrum = std::array<double, last_nm - first_nm + 1>;

Spectrum sampled(const std::function<double(double nm)>& f);
// A table of every `step` nm from 380 to 780, straight between.
Spectrum of_table(const double* values, int step);

// Values at wavelengths that ascend, straight between, 0 outside.  Throws Error (place) for fewer than two values,
// another order, a negative value, and where none lies between 380 and 780 nm.
Spectrum of_samples(const std::vector<double>& nm, const std::vector<double>& values, const std::string& place);
// The same of a file with a wavelength and a value in each line, between blanks, commas, semicolons or tabs; headings,
// and what stands behind #, are passed over.  Or of an XML file of IES TM-27 (.spdx).
Spectrum read_spectrum(const std::string& path, const base::Opener& by);

// Sum of a times b.
double dot(const Spectrum& a, const Spectrum& b);

}  // namespace spectrum
