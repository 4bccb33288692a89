// SPDX-License-Identifier: BSD-3-Clause
// -pixel: tables of one pixel in place of frames.
#pragma once
#include "session.h"

// Of the ordinary picture or, with -action, of that of the action.
void write_pixel(Session& session);
