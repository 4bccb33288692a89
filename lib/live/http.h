// SPDX-License-Identifier: BSD-3-Clause
// A request and its answer as libmicrohttpd has them.
#pragma once
#include <microhttpd.h>

#include <string>
#include <vector>

#include "live/answers.h"

namespace live {

// The values of a header, one for each time it comes.
std::vector<std::string> headers(MHD_Connection* connection, const char* name);
std::string header(MHD_Connection* connection, const char* name);  // the first one, or ""
Arguments arguments(MHD_Connection* connection);
// With the headers that keep the page to itself (docs/security.md).
MHD_Result send(MHD_Connection* connection, const Answer& answer);

}  // namespace live
