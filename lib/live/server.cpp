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

#include "live/against.h"
#include "live/answers.h"
#include "live/commands.h"
#include "live/day.h"
#include "live/design_file.h"
#include "base/descriptor.h"
#include "base/error.h"
#include "live/guard.h"
#include "live/http.h"
#include "live/json.h"
#include "live/page.h"
#include "live/visitors.h"

namespace live {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto longest_wait = std::chrono::seconds(20);         // of a request for news
constexpr auto between_looks = std::chrono::milliseconds(250);  // at the clock and at the files
constexpr size_t longest_body = longest_file;
constexpr unsigned most_connections = 500;

struct Request {
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
    const ServerOptions& options;
    Files files = options.files;
    std::string token = new_token();
    MHD_Daemon* daemon = nullptr;
    std::mutex mutex;  // of what follows
    std::vector<MHD_Connection*> waiting;
    bool ends = false;
    std::condition_variable tick;
    std::thread ticker;
    std::optional<Asked> sources, report, map;
    Visitors visitors;

    std::optional<DesignFile> design;
    std::mutex looking;  // at what other pipes do
    std::optional<Day> day;
    std::optional<Plan> plan;
    std::optional<Against> against;

    State(Live& l, const ServerOptions& o) : live(l), options(o) {
        live.change([&](Design& d) { d.texts.resize(files.size()); });
        design.emplace(options.design, files, live);
        against.emplace(options.against, live);  // over the base of the design
        offer_views(options.views, live);
        day.emplace(options.day, options.hours, files, live);
        plan.emplace(options.plan, files, live);
    }

    void wake() {
        const std::lock_guard<std::mutex> lock(mutex);
        for (MHD_Connection* connection : waiting) MHD_resume_connection(connection);
        waiting.clear();
    }

    // Looks whether files have changed, and lets requests that have waited long look at their clock.
    void keep_time() {
        auto woken = Clock::now();
        std::unique_lock<std::mutex> lock(mutex);
        while (!tick.wait_for(lock, between_looks, [&] { return ends; })) {
            visitors.look();
            lock.unlock();
            const bool changed = look_at_files();
            const Commanded to{live, files, options.control};
            give_opened(to);
            end_preview(to);
            design->look();
            look_at_pipes(false);
            against->say();
            lock.lock();
            if (!changed && Clock::now() - woken < longest_wait / 4) continue;
            woken = Clock::now();
            lock.unlock();
            if (changed) live.put_file_change();
            else wake();
            lock.lock();
        }
    }

    void look_at_pipes(bool asked) {
        const std::lock_guard<std::mutex> lock(looking);
        day->look();
        plan->look(asked);
    }

    // An answer, or the request waits until there is one.
    template <class ASK>
    MHD_Result wait_for(MHD_Connection* connection, const Request& request, ASK&& ask) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (const std::optional<Answer> answer = ask()) return send(connection, *answer);
        if (ends || Clock::now() - request.since > longest_wait) return send(connection, {MHD_HTTP_NO_CONTENT, "", ""});
        waiting.push_back(connection);
        MHD_suspend_connection(connection);
        return MHD_YES;
    }

    // Files that other programs have written since: their own texts count.
    bool look_at_files() {
        bool changed = false;
        for (size_t n = 0; n < files.size(); ++n) {
            if (!files[n].changed()) continue;
            changed = true;
            const std::string text = files[n].read().text;
            live.change([&](Design& d) { d.replaced(n, text); });
        }
        return changed;
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

    Answer facts() const {
        std::string text = std::string("{\"control\":") + (options.control.empty() ? "false" : "true") + ",\"files\":[";
        for (const TextFile& f : files)
            text += std::string(&f == files.data() ? "" : ",") + "{\"name\":" + json::text(f.path) +
                    ",\"regions\":" + (f.kind == TextFile::Kind::regions ? "true" : "false") +
                    ",\"writable\":" + (f.writable ? "true}" : "false}");
        return {MHD_HTTP_OK, "application/json", text + "]}"};
    }

    MHD_Result answer(MHD_Connection* connection, const std::string& path, const std::string& method,
                      const Request& request) {
        if (request.refused) return send(connection, plain(request.refused, "no"));
        if (request.too_long) return send(connection, plain(MHD_HTTP_CONTENT_TOO_LARGE, "too long"));
        const auto asked = arguments(connection);
        if (method == "POST") {
            if (path == "/plan") return send(connection, plan->limit(asked("limit")));
            const Answer done = answer_command({live, files, options.control}, path, asked, request.body);
            look_at_pipes(true);  // hours of another model are no more
            return send(connection, done);
        }
        if (path == "/file" && method == "PUT") {
            std::string tag = header(connection, "If-Match");
            if (tag.size() >= 2 && tag.front() == '"') tag = tag.substr(1, tag.size() - 2);
            return send(connection, answer_put(live, files, asked, request.body, tag));
        }
        if (path == "/control") return send(connection, plain(MHD_HTTP_METHOD_NOT_ALLOWED, "POST only"));
        if (method != "GET") return send(connection, plain(MHD_HTTP_METHOD_NOT_ALLOWED, "GET only"));
        if (const PageFile* file = page_file(path))
            return send(connection, {MHD_HTTP_OK, std::string(file->type), std::string(file->text)});
        if (path == "/next") return wait_for(connection, request, [&] { return answer_next(live, asked); });
        if (path == "/sources") return wait_for(connection, request, [&] { return answer_sources(*sources, asked); });
        if (path == "/plan") return wait_for(connection, request, [&] { return answer_plan(*map, asked); });
        if (path == "/what")
            return wait_for(connection, request, [&] { return answer_what({live, files, options.control}, asked); });
        if (path == "/report") return wait_for(connection, request, [&] { return answer_report(*report, asked); });
        if (path == "/facts") return send(connection, facts());
        return send(connection, answer_query(live, files, path, asked));
    }

    static MHD_Result on_request(void* self, MHD_Connection* connection, const char* url, const char* method,
                                 const char* /*version*/, const char* data, size_t* size, void** request_of) {
        State& state = *static_cast<State*>(self);
        try {
            if (!*request_of) {
                auto request = std::make_unique<Request>();
                const unsigned why = state.refused(connection);
                if (why == 0) state.visitors.know(visitor(connection));
                request->refused = why == MHD_HTTP_UNAUTHORIZED && page_file(url) ? 0 : why;
                *request_of = request.release();
                return MHD_YES;
            }
            Request& request = *static_cast<Request*>(*request_of);
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
        delete static_cast<Request*>(*request_of);
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

Server::Server(Live& live, const ServerOptions& options) : state_(std::make_unique<State>(live, options)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(uint16_t(options.port));
    if (inet_pton(AF_INET, options.listen.c_str(), &address.sin_addr) != 1)
        base::fail("-listen", "\"" + options.listen + "\" is not an address such as 127.0.0.1");
    const auto wake = [state = state_.get()] { state->wake(); };
    state_->sources.emplace([&live, &options] { return find_sources(live, options.sources); }, wake);
    state_->report.emplace(
        [&live, &options, state = state_.get()] {
            return find_report(live, state->files, options.report, *state->plan);
        },
        wake);
    state_->map.emplace([state = state_.get()] { return state->plan->draw(); }, wake);
    errno = 0;
    state_->daemon = MHD_start_daemon(
        MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME, uint16_t(options.port), nullptr, nullptr,
        &State::on_request, state_.get(), MHD_OPTION_SOCK_ADDR, &address, MHD_OPTION_NOTIFY_COMPLETED, &State::on_end,
        state_.get(), MHD_OPTION_NOTIFY_CONNECTION, &State::on_connection, state_.get(), MHD_OPTION_UNESCAPE_CALLBACK,
        &State::unescape, nullptr, MHD_OPTION_CONNECTION_LIMIT, most_connections, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
        size_t(64 * 1024), MHD_OPTION_CONNECTION_TIMEOUT, 30u, MHD_OPTION_END);
    if (!state_->daemon) base::fail_system("-port", "the page cannot be served there");
    live.on_change([state = state_.get()] { state->wake(); });
    state_->look_at_files();  // as they are now: later looks compare with it
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
    state_->design->look(true);
    state_->sources.reset();
    state_->report.reset();
    state_->map.reset();
    state_->wake();
    MHD_stop_daemon(state_->daemon);
}

std::string Server::link() const {
    const MHD_DaemonInfo* info = MHD_get_daemon_info(state_->daemon, MHD_DAEMON_INFO_BIND_PORT);
    const std::string host = state_->options.listen == "0.0.0.0" ? "localhost" : state_->options.listen;
    return "http://" + host + ":" + std::to_string(info ? info->port : 0) + "/#" + state_->token;
}

}  // namespace live
