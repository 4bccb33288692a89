// SPDX-License-Identifier: BSD-3-Clause
// See http.h.
#include "live/http.h"

#include <strings.h>

#include <utility>

namespace live {

std::vector<std::string> headers(MHD_Connection* connection, const char* name) {
    std::pair<std::string, std::vector<std::string>> found{name, {}};
    const auto take = [](void* to, MHD_ValueKind, const char* key, const char* value) {
        auto& [wanted, all] = *static_cast<decltype(found)*>(to);
        if (strcasecmp(key, wanted.c_str()) == 0) all.emplace_back(value ? value : "");
        return MHD_YES;
    };
    MHD_get_connection_values(connection, MHD_HEADER_KIND, take, &found);
    return found.second;
}

std::string header(MHD_Connection* connection, const char* name) {
    const auto all = headers(connection, name);
    return all.empty() ? "" : all[0];
}

Arguments arguments(MHD_Connection* connection) {
    return [connection](const char* name) {
        const char* value = MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, name);
        return std::string(value ? value : "");
    };
}

MHD_Result send(MHD_Connection* connection, const Answer& answer) {
    MHD_Response* response = MHD_create_response_from_buffer(answer.body.size(), const_cast<char*>(answer.body.data()),
                                                             MHD_RESPMEM_MUST_COPY);
    if (!response) return MHD_NO;
    const std::pair<const char*, const char*> always[] = {
        {"Content-Type", answer.type.c_str()},
        {"Cache-Control", "no-store"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src blob:; "
         "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    };
    for (const auto& [name, value] : always) MHD_add_response_header(response, name, value);
    if (!answer.tag.empty()) MHD_add_response_header(response, "ETag", ('"' + answer.tag + '"').c_str());
    const MHD_Result result = MHD_queue_response(connection, answer.status, response);
    MHD_destroy_response(response);
    return result;
}

}  // namespace live
