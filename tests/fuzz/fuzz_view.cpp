// SPDX-License-Identifier: BSD-3-Clause
// View files and the view lines of headers.
#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "view/view.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    write_alone("t.vf", {reinterpret_cast<const char*>(data), size});
    try_to([&] {
        const view::View v = view::read_view_file("t.vf");
        view::validate(v);
        int nx = 64, ny = 64;
        view::fit_size(v, 1, nx, ny);
        const view::Projector p(v);
        double X, Y;
        if (auto d = p.direction(.3, .7)) p.locate_direction(*d, X, Y);
        view::pixel_solid_angle(p, 1, 2, 8, 8);
        view::View again;
        view::parse_line(again, view::to_options(v));
        if (again != v) abort();
    });
    return 0;
}
