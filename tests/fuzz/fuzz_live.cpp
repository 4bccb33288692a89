// SPDX-License-Identifier: BSD-3-Clause
// The live page's server behind its web library: names of hosts, questions with their arguments, a text that is to be
// written, and a stream of pictures that passes in pieces.  The input: a line "PATH NAME=VALUE&NAME=VALUE", lines of
// Host, Origin and If-Match, and bytes.
#include <map>
#include <sstream>

#include "fuzz_folder.h"
#include "fuzz_try.h"
#include "live/answers.h"
#include "live/framer.h"
#include "live/guard.h"
#include "live/live.h"

namespace {

image::Picture picture() {
    image::Picture p;
    p.width = 5, p.height = 4;
    p.rgb.assign(60, .5f);
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    p.header.view = v;
    return p;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    std::string question, path, word, host, origin, tag;
    std::getline(in, question), std::getline(in, host), std::getline(in, origin), std::getline(in, tag);
    const std::string body(std::istreambuf_iterator<char>(in), {});
    live::is_loopback_host(host);
    live::is_own_origin(origin, host);
    live::same_secret(host, origin);

    std::istringstream words(question);
    std::getline(words, path, ' ');
    std::map<std::string, std::string> given;
    while (std::getline(words, word, '&')) given[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    const live::Arguments arguments = [&](const char* name) { return given.count(name) ? given[name] : ""; };

    write_alone("t.regions", "desk circle view 20\n");
    static live::Live page(
        {{"t.regions", live::TextFile::Kind::regions, true}, {"none.rad", live::TextFile::Kind::scene, false}});
    page.put_picture(live::Which::picture, picture());
    page.put_line(live::Which::picture, host);
    try_to([&] { live::answer_next(page, arguments); });
    try_to([&] { live::answer_query(page.state(), path, arguments); });
    try_to([&] { page.ask({path, arguments, body, tag.empty() ? page.state().files[0].tag : tag, tag.empty()}); });
    live::Framer framer([](image::Picture) {});
    for (size_t at = 0; at < body.size(); at += 7) framer.pass(body.data() + at, std::min<size_t>(7, body.size() - at));
    return 0;
}
