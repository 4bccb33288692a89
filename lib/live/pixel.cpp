// SPDX-License-Identifier: BSD-3-Clause
// See pixel.h.
#include "live/pixel.h"

#include "base/angle.h"
#include "view/position_index.h"
#include "live/json.h"
#include "view/view.h"

namespace live {

std::string pixel_facts(const image::Picture& picture, int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return "";
    const float* rgb = picture.at(x, y);
    json::Members all{{"rgb", json::numbers({rgb[0], rgb[1], rgb[2]})},
                      {"luminance", json::number(image::luminance(rgb))}};
    if (picture.header.view) {
        const view::Projector eye(*picture.header.view);
        const int row = picture.height - 1 - y;
        const auto d = eye.direction((x + .5) / picture.width, (row + .5) / picture.height);
        if (d)
            all.insert(all.end(), {{"direction", json::numbers({d->x, d->y, d->z})},
                                   {"angle", json::number(view::eye_angles(eye, *d).sigma_deg)},
                                   {"position", json::number(view::position_index(eye, *d))}});
        all.emplace_back("omega", json::number(view::pixel_solid_angle(eye, x, row, picture.width, picture.height)));
    }
    return json::object(all);
}

}  // namespace live
