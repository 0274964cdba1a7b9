// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

#include "app/animation_run.h"
#include "app/preview_address.h"
#include "console/heard.h"
#include "output/stats.h"
#include "preview/answers.h"
#include "preview/renderer.h"
#include "tasks/library.h"
#include "tasks/scene_run.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"
#include "web/server.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

class Preview {
public:
    Preview(const Options& options, const std::optional<Animation>& animation,
            const Console& console, Diagnostics& diagnostics)
        : options_(options),
          animation_(animation),
          console_(console),
          diagnostics_(diagnostics),
          state_([this] { wake(); }) {
        options_.to_file = false;
        options_.task = Task::render;
        options_.progress = "none";
        options_.layers.clear();  // the page shows layers in its own way
        if (options_.denoise || options_.draft) state_.denoise(true);
    }

    int run() {
        const std::string token = new_token();
        const PreviewFacts facts{page_with(token, *options_.scene), *options_.scene,
                                 manual_folder(directory_of(own_path()))};
        const std::string host = host_of(options_);
        WebServer server(host, *options_.preview_port, token, [&](const WebRequest& request) {
            return answer_of(request, facts, state_);
        });
        if (server.port() == 0)
            diagnostics_.add(problem_with_address(host, *options_.preview_port));
        Console console = console_;
        console.heard = [this](Stream stream, std::string_view text) {
            of_options_.take(stream, text);
        };
        say_errors(console, options_, diagnostics_);
        if (diagnostics_.failed()) return exit_status::file;
        serve(&server);
        console_.err(words_on_address(host, server.port(), token));
        if (console_.interrupts.listening) console_.interrupts.listening(true);
        while (!ending_) {
            render();
            while (!left()) state_.rest(rest_milliseconds);
        }
        serve(nullptr);
        return exit_status::done;
    }

private:
    /// Renders the scene until it changes.
    void render() {
        Console console = console_;
        Heard heard = of_options_;
        console.heard = [&](Stream stream, std::string_view text) { heard.take(stream, text); };
        Printed output;
        console.sorted = [&](Stream stream, std::string_view text, std::string_view plain) {
            output.push_back({stream, std::string(text), std::string(plain)});
        };
        console.err = [&](std::string_view text) {
            output.push_back({std::nullopt, std::string(text), std::string(text)});
        };
        console.out = [](std::string_view) {};
        console.terminal = false;
        console.interrupts.listening = nullptr;
        console.interrupts.take = [this] { return left() ? Interrupt::stop : Interrupt::none; };
        console.preview = [&](const ReadyScene& scene) {
            state_.hear(heard);
            print(output);
            render_preview(scene, state_, {[this] { return left(); }, [this] { return ends(); }});
        };
        console.files_read = [this](const std::vector<ReadFile>& files) { remember(files); };
        remember({{*options_.scene, {}}});
        state_.set_status([](RenderStatus& status) {
            status.progress = 0;
            status.seconds_left = -1;
            status.line = "reading the scene";
            status.busy = true;
        });
        Diagnostics diagnostics = diagnostics_.fresh();
        const int status = run_scene(options_as_turned(), console, diagnostics);
        print(output);
        if (status == exit_status::done) return;
        state_.questions().close();
        state_.hear(heard);
        state_.set_status([&](RenderStatus& status) {
            status.line = heard.errors.substr(0, heard.errors.find('\n'));  // the first error
            status.busy = false;
        });
    }

    /// A text for the terminal, of a stream or of none.
    struct Words {
        std::optional<Stream> stream;
        std::string text, plain;
        friend bool operator==(const Words&, const Words&) = default;
    };
    using Printed = std::vector<Words>;

    /// Prints what a run has said, unless the run before has said the same, as with each move of a
    /// slider.
    void print(const Printed& output) {
        if (output == printed_) return;
        printed_ = output;
        for (const Words& words : output)
            if (words.stream && console_.sorted)
                console_.sorted(*words.stream, words.text, words.plain);
            else
                console_.err(words.text);
    }

    Options options_as_turned() {
        Options options = options_;
        const std::string text = disk_reader()(*options_.scene).value_or("");
        std::vector<Knob> all = knobs(text);
        if (animation_) all.push_back(frames());
        for (const auto& [name, value] : state_.take_knobs(all))
            if (name != frame_knob) options.declares.push_back({name, value});
        if (animation_) choose_frame(options);
        return options;
    }

    /// Returns a knob that selects the frame of an animation.
    Knob frames() const {
        const auto number = [](const AnimationFrame& frame) {
            return static_cast<double>(frame.number);
        };
        const double first = number(animation_->frames.front());
        const double last = number(animation_->frames.back());
        return {frame_knob, first, Knob::Kind::slider, first, last, 1, {}, "of the animation"};
    }

    void choose_frame(Options& options) const {
        const std::vector<AnimationFrame>& all = animation_->frames;
        const double wanted = state_.knob(frame_knob, frames().low);
        const auto chosen = std::ranges::find_if(
            all, [&](const AnimationFrame& frame) { return frame.number >= wanted; });
        set_frame(options.facts, options.animation, *animation_,
                  chosen == all.end() ? all.back() : *chosen);
    }

    /// Whether the scene is outdated or the preview ends. Cheap; may be called by any thread.
    bool left() {
        if (state_.turned()) return true;
        look();
        return ending_ || file_changed_;
    }

    bool ends() {
        look();
        return ending_;
    }

    /// Checks files and signals at intervals.
    void look() {
        const double now = seconds_now();
        if (now < look_at_) return;
        const std::lock_guard lock(look_);
        if (now < look_at_) return;
        look_at_ = now + between_looks;
        if (console_.interrupts.take && console_.interrupts.take() == Interrupt::stop)
            ending_ = true;
        for (const auto& [path, time] : times_)
            if (time_of(path) != time) file_changed_ = true;
    }

    void remember(const std::vector<ReadFile>& files) {
        if (files.empty()) return;
        const std::lock_guard lock(look_);
        times_.clear();
        file_changed_ = false;
        for (const ReadFile& file : files) times_[file.path] = time_of(file.path);
    }

    static fs::file_time_type time_of(const std::string& path) {
        std::error_code none;
        return fs::last_write_time(path, none);
    }

    void serve(const WebServer* server) {
        const std::lock_guard lock(bell_);
        server_ = server;
    }

    void wake() {
        const std::lock_guard lock(bell_);
        if (server_) server_->wake();
    }

    /// Seconds between checks of files and signals.
    static constexpr double between_looks = 0.1;
    static constexpr int rest_milliseconds = 50;
    static constexpr auto frame_knob = "frame_number";

    Options options_;
    const std::optional<Animation>& animation_;
    const Console& console_;
    Diagnostics& diagnostics_;
    std::mutex bell_;
    const WebServer* server_ = nullptr;
    std::map<std::string, fs::file_time_type> times_;
    std::mutex look_;
    std::atomic<double> look_at_ = 0;
    std::atomic<bool> ending_ = false, file_changed_ = false;
    Heard of_options_;  ///< the messages of the command line
    Printed printed_;
    PreviewState state_;  ///< the last member: its thread uses the others
};

}  // namespace

int run_preview(const Options& options, const std::optional<Animation>& animation,
                const Console& console, Diagnostics& diagnostics) {
    return Preview(options, animation, console, diagnostics).run();
}

}  // namespace candelabra
