// SPDX-License-Identifier: BSD-3-Clause
// See server.h.
#include "live/server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <microhttpd.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <thread>

#include "live/answers.h"
#include "live/design_file.h"
#include "base/descriptor.h"
#include "base/error.h"
#include "live/guard.h"
#include "live/http.h"
#include "live/json.h"
#include "live/outbox.h"
#include "live/page.h"
#include "live/point_files.h"
#include "live/visitors.h"

namespace live {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto longest_wait = std::chrono::seconds(20);         // of a request for news
constexpr auto between_looks = std::chrono::milliseconds(250);  // at the clock and at the files
constexpr size_t longest_body = longest_file;
constexpr unsigned most_connections = 500;

struct Visit {
    unsigned refused = 0;  // a status, if it is
    std::string body;
    bool too_long = false;
    Clock::time_point since = Clock::now();
};

Visitors::Place& visitor(MHD_Connection* connection) {
    const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
    return *static_cast<Visitors::Place*>(info->socket_context);
}

const PageFile* page_file(const std::string& path) {
    for (size_t k = 0; k < page_file_count; ++k)
        if (page_files[k].path == path) return &page_files[k];
    return nullptr;
}

}  // namespace

struct Server::State {
    Live& live;
    Outbox& commands;
    const ServerOptions& options;
    std::string token = new_token();
    MHD_Daemon* daemon = nullptr;
    std::mutex mutex;  // of what follows
    std::vector<MHD_Connection*> waiting;
    Clock::time_point looked{};  // a window asked for news
    bool ends = false;
    std::condition_variable tick;
    std::thread ticker;
    Asked sources, report, map;  // ask in threads of their own, and wake
    Visitors visitors;
    DesignFile design;
    PointFiles points;

    State(Live& l, Outbox& c, const ServerOptions& o)
        : live(l),
          commands(c),
          options(o),
          sources([this] { return find_sources(live, options.sources); }, [this] { wake(); }),
          report([this] { return find_report(live, options.report, options.plan); }, [this] { wake(); }),
          map([this] { return find_plan(live, options.plan); }, [this] { wake(); }),
          design(o.design, l),
          points(o.plan) {
        live.begin([&](live::State& s) {
            s = with_views(std::move(s), options.views);
            if (options.against == "previous" || options.against == "first") s.against = options.against;
            else if (!options.against.empty()) s.now.base = options.against;  // over that of the design
        });
    }

    void wake() {
        const std::lock_guard<std::mutex> lock(mutex);
        for (MHD_Connection* connection : waiting) MHD_resume_connection(connection);
        waiting.clear();
    }

    // Looks at files and at the clock, and lets requests that have waited long look at it, too.
    void keep_time() {
        auto woken = Clock::now();
        std::unique_lock<std::mutex> lock(mutex);
        while (!tick.wait_for(lock, between_looks, [&] { return ends; })) {
            visitors.look();
            const bool watched = Clock::now() - looked < longest_wait;
            lock.unlock();
            live.look_at_files();
            if (!options.control.empty()) live.put(Listens{Which::picture, commands.listens(options.control)});
            points.look(live);
            live.put(Tick{watched});
            design.look();
            lock.lock();
            if (Clock::now() - woken < longest_wait / 4) continue;
            woken = Clock::now();
            lock.unlock();
            wake();
            lock.lock();
        }
    }

    // Why no program can be told anything.
    std::optional<Answer> deaf() {
        if (options.own) return {};
        if (options.control.empty()) return plain(404, "vcview was started without -control");
        const bool listens = commands.listens(options.control);
        live.put(Listens{Which::picture, listens});
        if (!listens) return plain(409, "nobody reads the FIFO");
        return commands.is_full() ? std::optional<Answer>(plain(503, "ptrace has not read the commands before"))
                                  : std::nullopt;
    }

    // An answer, or the request waits until there is one.
    template <class ASK>
    MHD_Result wait_for(MHD_Connection* connection, const Visit& request, ASK&& ask) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (const std::optional<Answer> answer = ask()) return send(connection, *answer);
        if (ends || Clock::now() - request.since > longest_wait) return send(connection, {MHD_HTTP_NO_CONTENT, "", ""});
        waiting.push_back(connection);
        MHD_suspend_connection(connection);
        return MHD_YES;
    }

    // 0: the request has the token; else the status that refuses it.
    unsigned refused(MHD_Connection* connection) const {
        for (const char* name : {"Host", "Origin", "X-Luxpipe-Token", "If-Match"})
            if (headers(connection, name).size() > 1) return MHD_HTTP_BAD_REQUEST;
        const std::string host = header(connection, "Host");
        const bool loopback = options.listen == "127.0.0.1" || options.listen == "::1";
        if (loopback && !is_loopback_host(host)) return MHD_HTTP_FORBIDDEN;
        if (!is_own_origin(header(connection, "Origin"), host)) return MHD_HTTP_FORBIDDEN;
        return same_secret(header(connection, "X-Luxpipe-Token"), token) ? 0 : MHD_HTTP_UNAUTHORIZED;
    }

    std::optional<Answer> news(const Arguments& known) {
        looked = Clock::now();
        return answer_next(live, known);
    }

    Answer facts() const {
        const std::string files = json::list_of(live.files(), [](const TextFile& f) {
            return json::object({{"name", json::text(f.path)},
                                 {"regions", json::truth(f.kind == TextFile::Kind::regions)},
                                 {"writable", json::truth(f.writable)}});
        });
        const bool control = options.own || !options.control.empty();
        return {
            MHD_HTTP_OK, "application/json",
            json::object({{"control", json::truth(control)}, {"scene", json::text(options.name)}, {"files", files}})};
    }

    MHD_Result answer(MHD_Connection* connection, const std::string& path, const std::string& method,
                      const Visit& request) {
        if (request.refused) return send(connection, plain(request.refused, "no"));
        if (request.too_long) return send(connection, plain(MHD_HTTP_CONTENT_TOO_LARGE, "too long"));
        const auto asked = arguments(connection);
        const bool put = path == "/file" && method == "PUT";
        if (method == "POST" || put) {
            std::string tag = header(connection, "If-Match");
            if (tag.size() >= 2 && tag.front() == '"') tag = tag.substr(1, tag.size() - 2);
            return send(connection, live.ask({path, asked, request.body, tag, put, deaf()}));
        }
        if (path == "/control") return send(connection, plain(MHD_HTTP_METHOD_NOT_ALLOWED, "POST only"));
        if (method != "GET") return send(connection, plain(MHD_HTTP_METHOD_NOT_ALLOWED, "GET only"));
        if (const PageFile* file = page_file(path))
            return send(connection, {MHD_HTTP_OK, std::string(file->type), std::string(file->text)});
        if (path == "/next") return wait_for(connection, request, [&] { return news(asked); });
        if (path == "/sources")
            return wait_for(connection, request, [&] { return answer_asked(sources, "-sources", asked); });
        if (path == "/plan") return wait_for(connection, request, [&] { return answer_asked(map, "-over", asked); });
        if (path == "/what") {
            if (is_to_be_asked(live.state(), asked)) {
                const Answer told = live.ask({path, asked, "", "", false, deaf()});
                if (told.status != MHD_HTTP_NO_CONTENT) return send(connection, told);
            }
            return wait_for(connection, request, [&] { return answer_what(live.state(), asked); });
        }
        if (path == "/report")
            return wait_for(connection, request, [&] { return answer_asked(report, "-report", asked); });
        if (path == "/facts") return send(connection, facts());
        if (path == "/file" || path == "/overlay") live.look_at_files();
        return send(connection, answer_query(live.state(), path, asked));
    }

    static MHD_Result on_request(void* self, MHD_Connection* connection, const char* url, const char* method,
                                 const char* /*version*/, const char* data, size_t* size, void** request_of) {
        State& state = *static_cast<State*>(self);
        try {
            if (!*request_of) {
                auto request = std::make_unique<Visit>();
                const unsigned why = state.refused(connection);
                if (why == 0) state.visitors.know(visitor(connection));
                request->refused = why == MHD_HTTP_UNAUTHORIZED && page_file(url) ? 0 : why;
                *request_of = request.release();
                return MHD_YES;
            }
            Visit& request = *static_cast<Visit*>(*request_of);
            if (*size == 0) return state.answer(connection, url, method, request);
            request.too_long = request.too_long || request.body.size() + *size > longest_body;
            if (!request.too_long && !request.refused) request.body.append(data, *size);
            *size = 0;
            return MHD_YES;
        } catch (const base::Error& e) {
            return send(connection, plain(MHD_HTTP_INTERNAL_SERVER_ERROR, e.text));
        } catch (const std::exception&) {
            return MHD_NO;
        }
    }

    static void on_end(void* self, MHD_Connection* connection, void** request_of, MHD_RequestTerminationCode) {
        static_cast<State*>(self)->visitors.answer(visitor(connection));
        delete static_cast<Visit*>(*request_of);
        *request_of = nullptr;
    }

    static void on_connection(void* self, MHD_Connection* connection, void** context,
                              MHD_ConnectionNotificationCode what) {
        Visitors& all = static_cast<State*>(self)->visitors;
        if (what == MHD_CONNECTION_NOTIFY_STARTED) {
            const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
            *context = new Visitors::Place(all.come(info->connect_fd));
        } else {
            all.leave(*static_cast<Visitors::Place*>(*context));
            delete static_cast<Visitors::Place*>(*context);
        }
    }

    // A zero byte would end the text for us, not for others: it stays escaped, and the text names nothing.
    static size_t unescape(void*, MHD_Connection*, char* text) {
        return std::strstr(text, "%00") ? std::strlen(text) : MHD_http_unescape(text);
    }
};

Server::Server(Live& live, Outbox& commands, const ServerOptions& options)
    : state_(std::make_unique<State>(live, commands, options)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(uint16_t(options.port));
    if (inet_pton(AF_INET, options.listen.c_str(), &address.sin_addr) != 1)
        base::fail("-listen", "\"" + options.listen + "\" is not an address such as 127.0.0.1");
    errno = 0;
    state_->daemon = MHD_start_daemon(
        MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME, uint16_t(options.port), nullptr, nullptr,
        &State::on_request, state_.get(), MHD_OPTION_SOCK_ADDR, &address, MHD_OPTION_NOTIFY_COMPLETED, &State::on_end,
        state_.get(), MHD_OPTION_NOTIFY_CONNECTION, &State::on_connection, state_.get(), MHD_OPTION_UNESCAPE_CALLBACK,
        &State::unescape, nullptr, MHD_OPTION_CONNECTION_LIMIT, most_connections, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
        size_t(64 * 1024), MHD_OPTION_CONNECTION_TIMEOUT, 30u, MHD_OPTION_END);
    if (!state_->daemon) base::fail_system("-port", "the page cannot be served there");
    live.on_change([state = state_.get()] { state->wake(); });
    state_->ticker = std::thread([state = state_.get()] { state->keep_time(); });
}

Server::~Server() {
    state_->live.on_change({});
    {
        const std::lock_guard<std::mutex> lock(state_->mutex);
        state_->ends = true;
    }
    state_->tick.notify_all();
    state_->ticker.join();
    state_->design.look(true);
    state_->wake();
    MHD_stop_daemon(state_->daemon);
}

std::string Server::link() const {
    const MHD_DaemonInfo* info = MHD_get_daemon_info(state_->daemon, MHD_DAEMON_INFO_BIND_PORT);
    const std::string host = state_->options.listen == "0.0.0.0" ? "localhost" : state_->options.listen;
    return "http://" + host + ":" + std::to_string(info ? info->port : 0) + "/#" + state_->token;
}

}  // namespace live
