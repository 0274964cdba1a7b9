// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/animation_run.h"
#include "app/completion.h"
#include "app/help.h"
#include "app/merge.h"
#include "app/preview.h"
#include "app/scene_run.h"
#include "picture/file.h"
#include "text/loader.h"

#include <vector>

namespace {

std::string explanation(const Options& options, Diagnostics& diagnostics) {
    if (options.task == Task::version) return version_text();
    if (options.task == Task::completion) return completion(options.topic).value_or("");
    if (options.task == Task::help) return help_text(options.topic, diagnostics);
    return description(options.topic, options.form, diagnostics);
}

int usage_errors(const Console& console, const Options& options, const Diagnostics& diagnostics) {
    say_errors(console, options, diagnostics);
    return exit_status::usage;
}

/// The options in force as an INI file.
std::string ini_text(const Options& options) {
    std::string text;
    for (const std::string& line : options.given) text += line + "\n";
    return text;
}

}  // namespace

int run(std::span<const std::string_view> arguments, const Console& console) {
    if (!arguments.empty() && arguments[0] == "merge") return merge(arguments.subspan(1), console);
    Diagnostics diagnostics;
    std::vector<std::string_view> all(arguments.begin(), arguments.end());
    if (!console.settings.empty()) all.insert(all.begin(), console.settings);
    const Options options = read_options(all, diagnostics, disk_reader());
    const std::optional<Animation> animation = plan(options.animation, diagnostics);
    if (diagnostics.failed()) return usage_errors(console, options, diagnostics);
    if (options.task == Task::help || options.task == Task::version ||
        options.task == Task::describe || options.task == Task::completion) {
        console.out(explanation(options, diagnostics));
        return diagnostics.failed() ? usage_errors(console, options, diagnostics)
                                    : exit_status::done;
    }
    if (!options.scene) {
        console.err(short_usage());
        return exit_status::usage;
    }
    if (options.ini_file && !write_file(*options.ini_file, ini_text(options), diagnostics)) {
        usage_errors(console, options, diagnostics);
        return exit_status::file;
    }
    if (options.preview_port) return run_preview(options, console, diagnostics);
    if (animation) return run_animation(options, *animation, console, diagnostics);
    return run_scene(options, console, diagnostics);
}
