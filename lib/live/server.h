// SPDX-License-Identifier: BSD-3-Clause
// The web server behind the page (libmicrohttpd): one thread, loopback by default, every answer but the page's own
// files for those who know the token.
//   GET /next?picture=&line=&files=&design=   waits for news since these: a length (4 bytes, little endian), so many
//   bytes
//                                of JSON, then the picture's pixels as floats, if there is a newer one
//   GET /table?top=&decades=&style=&divisions=&mask=   falsecolor's thresholds and colours (display/tone.h)
//   GET /srgb                    thresholds of the codes 1 to 255
//   GET /pixel?x=&y=             what is known of a pixel (pixel.h)
//   GET /sources?picture=        the glare sources of picture P or a newer one (sources.h); waits for them
//   GET /what?x=&y=              what ptrace sees at fractions of the newest picture; waits for it (what, ptrace(1))
//   GET /report?picture=         the same as one HTML file for people (vcmetrics -report)
//   GET /plan?picture=           numbers and map of the points, of this state of their sum or a newer one (plan.h)
//   POST /plan?limit=            lx: of the line in that map, and of the share of points
//   GET /save?as=hdr             the newest picture as a file, hdr or exr
//   GET /facts                   what vcview was started with
//   GET /file?n=                 text N of those that the page may show, with its tag (ETag)
//   PUT /file?n=                 its new text, if it still is what the tag of If-Match says (412 if not)
//   GET /outlines?n=             of the regions in file N (regions.h)
//   POST /control                lines for the FIFO of ptrace -control
//   GET /overlay?n=              the text that stands for file N, if one does, with its version (ETag)
//   POST /overlay?n=&version=&said=&going=   a text that ptrace takes for file N, made from this version of it (412 if
//                                there is a newer one); said: words for the edit; going: more of the same change
//                                follows
//   GET /variant?name=           the picture of that variant, as /next has it; without a name: of the edit before
//   POST /variant?name=&do=      keep (no name: the next letter), show, base, drop, or call (to=NAME)
//   POST /place?name=&do=        keep the view under a name, or drop it
//   POST /back                   asks for the view before this one
//   POST /undo?state=, /redo?state=   takes the last change back, or makes it again, in this state of the list of
//                                changes (412 if there is a newer one)
//   POST /dismiss?number=        a message stands no more
//   POST /start                  starts programs again that have ended
#pragma once
#include <memory>
#include <string>
#include "live/live.h"
#include "live/sources.h"

namespace live {

class Outbox;

struct ServerOptions {
    int port = 0;                      // 0: any that is free
    std::string listen = "127.0.0.1";  // address
    std::string control;               // FIFO of ptrace -control; empty: none
    bool own = false;                  // the programs are ours, and read what they are told
    std::string name;                  // of the scene, for people
    std::vector<std::string> views;    // view files that are offered
    std::string against;               // what edits are compared with: previous, first or a variant
    std::string design;                // file that the design is read from and written to; empty: none
    PlanOptions plan;                  // sum empty: there is none
    std::vector<std::string> sources;  // the program that lists glare sources (sources.h)
    std::vector<std::string> report;   // the one that writes reports
};

class Server {
public:
    // commands: to the programs.  Throws base::Error (system).
    Server(Live& live, Outbox& commands, const ServerOptions& options);
    ~Server();
    std::string link() const;  // with the token

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace live
