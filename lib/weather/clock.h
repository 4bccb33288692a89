// SPDX-License-Identifier: BSD-3-Clause
// Does a weather file's sun stand where its irradiances say?  Files are known whose hours are half an hour off.
#pragma once
#include <optional>

#include "weather/weather.h"

namespace weather {

// How far DNI sin(altitude) + DHI are from the file's own global irradiance, the median as a share.
struct ClockError {
    double shift_h = 0;  // in all, at which they fit best; to a twentieth of an hour
    double as_placed = 0, shifted = 0;
};
// Nothing where the file does not say, or not beyond doubt, that its sun is a quarter of an hour off or more.
std::optional<ClockError> clock_error(const Weather& weather);

}  // namespace weather
