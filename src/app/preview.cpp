// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

#include "app/animation_run.h"
#include "app/inspect.h"
#include "app/light_report.h"
#include "app/option_store.h"
#include "app/preview_page.h"
#include "app/render_queries.h"
#include "app/scene_run.h"
#include "app/stats.h"
#include "editor/knobs.h"
#include "film/film.h"
#include "picture/write.h"
#include "text/loader.h"
#include "text/message.h"
#include "web/server.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// The page for those who shall be able to change something.
std::string with_token(const std::string& token) {
    std::string page = preview_page;
    return page.replace(page.find(token_place), token_place.size(), token);
}

/// What the page is shown; made by the renderer, read by the server.
struct Posted {
    std::mutex mutex;
    std::string png, lights;
    std::string errors, line = "reading the scene";
    double progress = 0;
    int pictures = 0;
    std::vector<Knob> knobs;
    std::map<std::string, double> turned;  ///< what the page has set, by name
};

class Preview {
public:
    Preview(const Options& options, const std::optional<Animation>& animation,
            const Console& console, Diagnostics& diagnostics)
        : options_(options), animation_(animation), console_(console), diagnostics_(diagnostics) {
        options_.to_file = false;
        options_.task = Task::render;
        options_.progress = "none";
        options_.light_report = true;
        options_.layers.clear();  // the page has its own way to show them
    }

    int run() {
        const std::string token = new_token();
        page_ = with_token(token);
        const WebServer server(*options_.preview_port, token,
                               [this](const WebRequest& request) { return answer(request); });
        if (server.port() == 0)
            diagnostics_.add(
                error(Fault::io, {}, message("port ", *options_.preview_port, " cannot be had"))
                    .with_help("--preview 0 takes any that is free"));
        say_errors(console_, options_, diagnostics_);
        if (diagnostics_.failed()) return exit_status::file;
        console_.err(message("preview: http://localhost:", server.port(), "/\n"));
        if (console_.interrupts.listening) console_.interrupts.listening(true);
        while (!ending_) {
            render();
            wait_for_change();
        }
        return exit_status::done;
    }

private:
    /// One picture, up to its end or a change of the scene.
    void render() {
        Console console = console_;
        std::string said;
        console.sorted = {};  // all is shown
        console.err = [&](std::string_view text) { said += text; };
        console.out = [](std::string_view) {};
        console.terminal = console.coloured = false;
        console.interrupts.listening = nullptr;
        console.interrupts.take = [this] { return look_up(); };
        console.watch = [this](const Exhibit& exhibit) { show(exhibit); };
        console.linger = [&](const Exhibit& exhibit) { linger(exhibit, said); };
        console.files_read = [this](const std::vector<ReadFile>& files) { remember(files); };
        remember({{*options_.scene, {}}});
        show_at_ = seconds_now() + first_look;
        Diagnostics diagnostics = diagnostics_.fresh();
        const int status = run_scene(options_as_turned(), console, diagnostics);
        questions_.close();
        if (status == exit_status::done) return;
        const std::lock_guard lock(shown_.mutex);
        shown_.errors = diagnostics.failed() ? said : std::string();
        shown_.line = said.substr(0, said.find('\n'));  // the first error
    }

    /// A finished picture can be asked about until something changes.
    void linger(const Exhibit& exhibit, std::string_view said) {
        while (said.ends_with('\n')) said.remove_suffix(1);
        {
            const std::lock_guard lock(shown_.mutex);
            shown_.progress = 1;
            shown_.line = said.substr(said.rfind('\n') + 1);  // the summary comes last
        }
        while (!ending_ && !changed()) {
            questions_.answer(exhibit);
            rest();
        }
    }

    Options options_as_turned() {
        turned_ = false;
        Options options = options_;
        const std::string text = disk_reader()(*options_.scene).value_or("");
        const std::lock_guard lock(shown_.mutex);
        shown_.knobs = knobs(text);
        for (const Knob& knob : shown_.knobs)
            if (const auto set = shown_.turned.find(knob.name); set != shown_.turned.end())
                options.declares.push_back({knob.name, set->second});
        if (animation_) choose_frame(options);
        return options;
    }

    /// An animation is looked at frame by frame; the lock is held.
    void choose_frame(Options& options) {
        const std::vector<AnimationFrame>& frames = animation_->frames;
        const Knob knob{frame_knob,
                        static_cast<double>(frames.front().number),
                        static_cast<double>(frames.front().number),
                        static_cast<double>(frames.back().number),
                        1,
                        "of the animation"};
        shown_.knobs.push_back(knob);
        const auto set = shown_.turned.find(knob.name);
        const double wanted = set == shown_.turned.end() ? knob.value : set->second;
        const auto chosen = std::ranges::find_if(
            frames, [&](const AnimationFrame& frame) { return frame.number >= wanted; });
        set_frame(options.facts, options.animation, *animation_,
                  chosen == frames.end() ? frames.back() : *chosen);
    }

    /// May be asked by any thread of the renderer.
    Interrupt look_up() {
        const std::lock_guard lock(look_);
        if (console_.interrupts.take && console_.interrupts.take() == Interrupt::stop)
            ending_ = true;
        if (ending_) return Interrupt::stop;
        const double now = seconds_now();
        const bool asked = questions_.waiting() && now >= show_at_ - between_looks + first_look;
        if (now < show_at_ && !asked) return Interrupt::none;
        show_at_ = now + between_looks;
        return changed() ? Interrupt::stop : Interrupt::save;
    }

    void wait_for_change() {
        while (!ending_ && !changed()) rest();
        const std::lock_guard lock(shown_.mutex);
        shown_.progress = 0;
        shown_.line = "reading the scene";
    }

    void rest() {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        if (console_.interrupts.take && console_.interrupts.take() == Interrupt::stop)
            ending_ = true;
    }

    void remember(const std::vector<ReadFile>& files) {
        if (files.empty()) return;
        times_.clear();
        for (const ReadFile& file : files) times_[file.path] = time_of(file.path);
    }

    static fs::file_time_type time_of(const std::string& path) {
        std::error_code none;
        return fs::last_write_time(path, none);
    }

    bool changed() const {
        if (turned_) return true;
        for (const auto& [path, time] : times_)
            if (time_of(path) != time) return true;
        return false;
    }

    void show(const Exhibit& exhibit) {
        Diagnostics problems;
        auto png = encode(picture_of(exhibit), PictureFormat(), problems);
        std::string lights = light_report(exhibit.world, exhibit.rays, exhibit.sources);
        questions_.answer(exhibit);
        const std::lock_guard lock(shown_.mutex);
        shown_.errors.clear();
        shown_.line = message(exhibit.film.width(), " x ", exhibit.film.height());
        shown_.progress = exhibit.done;
        shown_.png = std::move(png).value_or("");
        shown_.lights = std::move(lights);
        ++shown_.pictures;
    }

    static WebAnswer no_such_page() { return {"text/plain", "no such page\n", 404}; }

    WebAnswer answer(const WebRequest& request) {
        // Whoever leads somebody to an address must not change anything by it.
        if (request.post != (request.path == "/turn"))
            return {"text/plain", "/turn is for POST, all else for GET\n", 405};
        if (request.path == "/view.png") {
            std::string png = seen(request.parameter("name"));
            return png.empty() ? no_such_page() : WebAnswer{"image/png", std::move(png)};
        }
        if (request.path == "/pick") return {"text/plain; charset=utf-8", picked(request)};
        const std::lock_guard lock(shown_.mutex);
        if (request.path == "/") return {"text/html; charset=utf-8", page_};
        if (request.path == "/page.js") return {"text/javascript; charset=utf-8", preview_script};
        if (request.path == "/picture.png") return {"image/png", shown_.png};
        if (request.path == "/turn") return turn(request);
        if (request.path != "/status") return no_such_page();
        const nlohmann::json status = {{"picture", shown_.pictures}, {"progress", shown_.progress},
                                       {"errors", shown_.errors},    {"line", shown_.line},
                                       {"lights", shown_.lights},    {"views", views()},
                                       {"knobs", listed_knobs()}};
        return {"application/json",
                status.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
    }

    nlohmann::json listed_knobs() const {
        nlohmann::json list = nlohmann::json::array();
        for (const Knob& knob : shown_.knobs) {
            const auto set = shown_.turned.find(knob.name);
            list.push_back({{"name", knob.name},
                            {"value", set == shown_.turned.end() ? knob.value : set->second},
                            {"low", knob.low},
                            {"high", knob.high},
                            {"step", knob.step},
                            {"help", knob.help}});
        }
        return list;
    }

    /// Sets a knob, within its range; the lock is held.
    WebAnswer turn(const WebRequest& request) {
        const std::string name = request.parameter("name");
        const auto value = number(request.parameter("value"));
        const auto knob = std::ranges::find(shown_.knobs, name, &Knob::name);
        if (knob == shown_.knobs.end() || !value)
            return {"text/plain", "there is no such knob or number\n", 404};
        shown_.turned[name] = std::clamp(*value, knob->low, knob->high);
        turned_ = true;
        return {"text/plain", ""};
    }

    /// A layer as a PNG file.
    std::string seen(const std::string& name) {
        return questions_.ask([name](const Exhibit& exhibit) {
            Diagnostics problems;
            const auto image = view(exhibit, name);
            return image ? encode(*image, PictureFormat(), problems).value_or("") : std::string();
        });
    }

    std::string picked(const WebRequest& request) {
        const auto whole = [&](std::string_view name) {
            const std::string text = request.parameter(name);
            int value = -1;
            const auto [end, problem] =
                std::from_chars(text.data(), text.data() + text.size(), value);
            return problem == std::errc() && end == text.data() + text.size() ? value : -1;
        };
        const int x = whole("x"), y = whole("y");
        return questions_.ask([=](const Exhibit& exhibit) { return what_is_under(exhibit, x, y); });
    }

    static constexpr double first_look = 0.2;  ///< seconds until the first picture is shown
    static constexpr double between_looks = 1;
    static constexpr auto frame_knob = "frame_number";

    Options options_;
    const std::optional<Animation>& animation_;
    const Console& console_;
    Diagnostics& diagnostics_;
    std::string page_;
    Posted shown_;
    Questions questions_;
    std::map<std::string, fs::file_time_type> times_;
    std::mutex look_;
    double show_at_ = 0;
    std::atomic<bool> ending_ = false;
    std::atomic<bool> turned_ = false;  ///< since the picture that is being made was begun
};

}  // namespace

int run_preview(const Options& options, const std::optional<Animation>& animation,
                const Console& console, Diagnostics& diagnostics) {
    return Preview(options, animation, console, diagnostics).run();
}

}  // namespace candelabra
