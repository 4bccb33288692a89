// SPDX-License-Identifier: BSD-3-Clause
// See session.h.
#include "render/session.h"

#include <algorithm>
#include <utility>

#include "base/files_read.h"
#include "base/memory.h"
#include "base/warnings.h"

namespace render {
namespace {

scene::ReadOptions budget_anew(scene::ReadOptions how) {
    how.work = base::work_budget_from_environment();
    return how;
}

}  // namespace

Setup preview_of(Setup setup) {
    constexpr int most = 128;
    int &nx = setup.view.nx, &ny = setup.view.ny;
    const int longest = std::max({nx, ny, most});
    nx = std::max(1, nx * most / longest);
    ny = std::max(1, ny * most / longest);
    setup.view.focus.clear();
    setup.options.direct_samples = 2;
    setup.options.more_if_small = false;
    setup.options.noisy_share = 0;
    return setup;
}

Session::Session(std::unique_ptr<Renderer> renderer, std::vector<std::string> files)
    : renderer_(std::move(renderer)), files_(std::move(files)) {}

// Returns true if a change of options changes the scene's tables.
static bool needs_load(const RenderOptions& a, const RenderOptions& b) {
    return a.dr != b.dr || a.bv != b.bv || a.any_reflectance != b.any_reflectance ||
           (a.sampling == Sampling::plain) != (b.sampling == Sampling::plain);
}

// Options of a load.
static RenderOptions with_eye(const Setup& setup) {
    RenderOptions options = setup.options;
    options.eye = setup.view.view.vp;
    return options;
}

void Session::load(scene::Scene scene, const std::string& sky, const Setup& setup, bool keep) {
    renderer_->load(scene, with_eye(setup), setup.reading);
    history_ = scene.history;
    sky_ = sky;
    scene_ = keep ? std::move(scene) : scene::Scene();
    scene = scene::Scene();  // the renderer has its own tables
    base::give_back_memory();
    select(setup);
}

void Session::select(const Setup& setup) {
    if (!renderer_->is_near(setup.view)) renderer_->load(scene_, with_eye(setup), budget_anew(setup.reading));
    renderer_->select_view(setup.view, setup.options);
    setup_ = setup;
}

// Changes are relative to the files' present state.
scene::Scene Session::read_again(scene::ReadOptions how) const {
    const std::vector<std::string> before = base::forget_files_read();
    base::take_warnings();
    try {
        scene::Scene scene = scene::read_scene(files_, how);
        how.asked_by.clear();  // a sky is named on the command line
        if (!sky_.empty()) scene::read_more(scene, {sky_}, how);
        return scene;
    } catch (...) {
        for (const std::string& path : before) base::note_file_read(path);
        throw;
    }
}

bool Session::edit(const Setup& next, bool read) {
    const std::string before = renderer_->fingerprint();
    const scene::ReadOptions how = budget_anew(next.reading);
    if (read) {
        scene::Scene scene = read_again(how);
        renderer_->load(scene, with_eye(next), how);
        history_ = scene.history;
        scene_ = std::move(scene);
    } else if (needs_load(setup_.options, next.options) || setup_.reading.cal_files != next.reading.cal_files) {
        renderer_->load(scene_, with_eye(next), how);
    }
    select(next);
    return renderer_->fingerprint() != before;
}

}  // namespace render
