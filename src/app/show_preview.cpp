// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/show_preview.h"

#include "app/preview_address.h"
#include "app/share_show.h"
#include "preview/page_files.h"
#include "web/server.h"

#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

class ShowPreview {
public:
    ShowPreview(const std::string& lights, const ShowFiles& show, const Options& options,
                const Console& console)
        : lights_(lights), show_(show), options_(options), console_(console) {
        for (const std::string& path : show_.paths()) files_.push_back({path, {}});
        files_.push_back({lights_, {}});
    }

    int run(Diagnostics& diagnostics) {
        look();
        if (!make(diagnostics)) return exit_status::file;
        const std::string host = host_of(options_), token = new_token();
        const WebServer server(host, *options_.preview_port, token,
                               [&](const WebRequest& request) { return answer(request); });
        if (server.port() == 0) {
            diagnostics.add(problem_with_address(host, *options_.preview_port));
            return exit_status::file;
        }
        console_.err(words_on_address(host, server.port(), token));
        if (console_.interrupts.listening) console_.interrupts.listening(true);
        while (!console_.interrupts.take || console_.interrupts.take() != Interrupt::stop) {
            std::this_thread::sleep_for(between_looks);
            if (!look()) continue;
            Diagnostics of_change = diagnostics.fresh();
            if (make(of_change)) server.wake();
            say_errors(console_, options_, of_change);
        }
        return exit_status::done;
    }

private:
    struct File {
        std::string path;
        fs::file_time_type time;
    };

    /// Whether a file has changed since the last call.
    bool look() {
        bool changed = false;
        for (File& file : files_) {
            std::error_code none;
            const auto time = fs::last_write_time(file.path, none);
            changed |= std::exchange(file.time, time) != time;
        }
        return changed;
    }

    /// Makes the page. Returns false after an error has been reported.
    bool make(Diagnostics& diagnostics) {
        auto picture =
            shared_show(lights_, show_, fs::path(lights_).stem().string(), options_, diagnostics);
        if (!picture) return false;
        picture->watched = number_ + 1;
        std::string page = share_page(*picture);
        const std::lock_guard lock(mutex_);
        page_ = std::move(page);
        ++number_;
        return true;
    }

    WebAnswer answer(const WebRequest& request) {
        constexpr auto plain = "text/plain; charset=utf-8";
        if (request.post) return {plain, "the page of a show takes no changes\n", 405};
        const std::lock_guard lock(mutex_);
        if (request.path == "/") {
            WebAnswer page{"text/html; charset=utf-8", page_};
            page.is_whole = true;
            return page;
        }
        if (request.path == "/favicon.ico") return {"image/svg+xml", std::string(preview_icon)};
        if (request.path != "/changed") return {plain, "no such page\n", 404};
        WebAnswer answer{plain, std::to_string(number_)};
        answer.later = request.can_wait && request.parameter("since") == answer.body;
        return answer;
    }

    static constexpr std::chrono::milliseconds between_looks{100};

    const std::string& lights_;
    const ShowFiles& show_;
    const Options& options_;
    const Console& console_;
    std::vector<File> files_;
    std::mutex mutex_;
    std::string page_;
    int number_ = 0;  ///< of pages that were made
};

}  // namespace

int preview_show(const std::string& lights, const ShowFiles& show, const Options& options,
                 const Console& console, Diagnostics& diagnostics) {
    return ShowPreview(lights, show, options, console).run(diagnostics);
}

}  // namespace candelabra
