// SPDX-License-Identifier: BSD-3-Clause
// -pixel: tables of one pixel in place of frames.
#pragma once
#include "options.h"
#include "render/session.h"

void write_pixel(const Options& opt, render::Session& session);
