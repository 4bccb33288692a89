// SPDX-License-Identifier: BSD-3-Clause
// -pixel: tables of one pixel in place of frames.
#pragma once
#include "options.h"
#include "render/view_plan.h"
#include "scene/object.h"

void write_pixel(const Options& opt, device::Device& device, const render::ViewPlan& plan, const scene::Scene& scene);
