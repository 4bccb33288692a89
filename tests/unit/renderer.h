// SPDX-License-Identifier: BSD-3-Clause
// A device and one picture of a scene, for tests of frames.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "render/make_device.h"
#include "render/pixel_moments.h"
#include "render/pixel_report.h"
#include "render/progressive.h"

namespace render {

class Renderer {
public:
    Renderer(const scene::Scene& scene, const RenderView& view, const RenderOptions& options, const std::string& device,
             const scene::ReadOptions& files)
        : device_(make_device(device)), plan_(plan_of(scene, view, options, files)) {}
    Renderer(const scene::Scene& scene, const view::View& view, int nx, int ny, const RenderOptions& options,
             const std::string& device, const scene::ReadOptions& files)
        : Renderer(scene, RenderView{view, nx, ny}, options, device, files) {}

    // Another picture of the scene.
    void show(const RenderView& view, const RenderOptions& options) {
        plan_ = plan_view(*device_, plan_.scene, view, options);
    }
    std::string fingerprint() const { return plan_.fingerprint; }
    int64_t direct_frames() const { return plan_.m; }
    void frames(int64_t first, int64_t count, const GiveFrame& give, bool moments = false) const {
        render_frames(*device_, plan_, first, count, moments, give);
    }
    void frame(int64_t k, std::vector<float>& rgb) const {
        frames(k, 1, [&](int64_t, const std::vector<float>& v, const image::Moments&) {
            rgb = v;
            return true;
        });
    }
    void explain(const scene::Scene& scene, int x, int y, int64_t first, int64_t last, const GiveRow& give) const {
        explain_pixel(*device_, plan_, scene, x, y, first, last, give);
    }
    MomentReport explain_moments(const scene::Scene& scene, int x, int y) const {
        return render::explain_moments(*device_, plan_, scene, x, y);
    }
    image::Moments moments() const { return pixel_moments(*device_, plan_, draw_frame_zero(*device_, plan_)); }
    device::Device& device() const { return *device_; }
    const ViewPlan& plan() const { return plan_; }

private:
    ViewPlan plan_of(const scene::Scene& scene, const RenderView& view, RenderOptions options,
                     const scene::ReadOptions& files) const {
        options.compact_tree = device_->compact_tree();
        return plan_view(*device_, load_scene(scene, options, files), view, options);
    }

    std::unique_ptr<device::Device> device_;
    ViewPlan plan_;
};

}  // namespace render
