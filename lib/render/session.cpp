// SPDX-License-Identifier: BSD-3-Clause
// See session.h.
#include "render/session.h"

#include <algorithm>
#include <utility>

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

Session::Session(std::unique_ptr<Renderer> renderer, scene::Scene scene, std::vector<std::string> files)
    : renderer_(std::move(renderer)), files_(std::move(files)) {
    with_sky_.room = scene::extent_of(scene);
    with_sky_.scene = std::move(scene);
}

// Returns true if a change of options changes the scene's tables.
static bool needs_load(const RenderOptions& a, const RenderOptions& b) {
    return a.dr != b.dr || a.bv != b.bv || a.any_reflectance != b.any_reflectance ||
           (a.sampling == Sampling::plain) != (b.sampling == Sampling::plain);
}

static std::string hash_of_surfaces(const scene::Scene& scene) {
    return scene::hash_of_objects(scene, flatten::surfaces_end(scene)).text();
}

void Session::load_into_renderer(const WithSky& of, const Setup& setup, const scene::ReadOptions& how) const {
    RenderOptions options = setup.options;
    options.eye = viewpoint_of(setup.view);
    options.room_text = of.room_text;
    if (!of.room_text.empty() && flatten::surfaces_end(of.scene) > of.room.objects)  // a sky with surfaces
        options.room_text = hash_of_surfaces(of.scene);
    options.sky_from = of.room.objects;
    options.keep_room = next_ == Next::skies_or_edits;
    renderer_->load(of.scene, options, how);
}

void Session::load(const std::string& sky, Setup setup, Next next) {
    setup.reading.work = std::make_shared<base::WorkBudget>(*setup.reading.work);  // what the rest of the scene left
    setup.reading.asked_by.clear();                                                // a sky is the command line's
    scene::Scene& scene = with_sky_.scene;
    const bool is_first = with_sky_.room_text.empty();
    scene::cut(scene, with_sky_.room);
    next_ = next;
    if (next == Next::skies_or_edits && with_sky_.room_text.empty()) with_sky_.room_text = hash_of_surfaces(scene);
    if (!sky.empty()) scene::read_more(scene, {sky}, setup.reading);
    sky_ = sky;
    history_ = scene.history;
    may_have_light_ = scene.may_have_light();
    load_into_renderer(with_sky_, setup, setup.reading);
    if (next == Next::nothing) scene = scene::Scene();                // the renderer has its own tables
    if (is_first || next == Next::nothing) base::give_back_memory();  // else for the next sky
    select(setup);
}

void Session::select(const Setup& setup) {
    if (!renderer_->is_near(setup.view)) load_into_renderer(with_sky_, setup, budget_anew(setup.reading));
    renderer_->select_view(setup.view, setup.options);
    setup_ = setup;
}

// Changes are relative to the files' present state.
Session::WithSky Session::read_again(Setup& setup, const ReadView& read_view) const {
    scene::ReadOptions how = setup.reading;
    base::take_warnings();
    if (read_view) read_view(setup.view);
    WithSky now;
    now.scene = scene::read_scene(files_, how);
    now.room = scene::extent_of(now.scene);
    now.room_text = hash_of_surfaces(now.scene);
    how.asked_by.clear();  // a sky is named on the command line
    if (!sky_.empty()) scene::read_more(now.scene, {sky_}, how);
    return now;
}

bool Session::edit(Setup next, bool read, const ReadView& read_view) {
    const std::string before = renderer_->fingerprint();
    const scene::ReadOptions how = next.reading = budget_anew(next.reading);
    if (read) {
        WithSky now = read_again(next, read_view);
        load_into_renderer(now, next, how);
        history_ = now.scene.history;
        with_sky_ = std::move(now);
    } else if (needs_load(setup_.options, next.options) || setup_.reading.cal_files != next.reading.cal_files) {
        load_into_renderer(with_sky_, next, how);
    }
    select(next);
    return renderer_->fingerprint() != before;
}

}  // namespace render
