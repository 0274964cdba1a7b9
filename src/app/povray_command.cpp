// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/povray_command.h"

#include "app/commands.h"
#include "options/options.h"
#include "picture/file.h"
#include "production/version.h"
#include "text/ascii.h"
#include "text/loader.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// What holds in POV-Ray where nobody says otherwise. The size is that of the INI file that is
/// installed with it.
Options povray_defaults() {
    Options options;
    options.render.width = 800;
    options.render.height = 600;
    options.render.antialias = false;
    options.render.luminaires_above = INFINITY;
    return options;
}

/// Returns the arguments without those for a window: of POV-Ray's program for Windows. `/RENDER` is
/// followed by the scene.
std::vector<std::string_view> without_window(std::span<const std::string_view> arguments) {
    static constexpr auto windowed =
        std::to_array<std::string_view>({"/exit", "/norestore", "/nr", "/render"});
    std::vector<std::string_view> rest;
    for (const std::string_view word : arguments)
        if (std::ranges::none_of(windowed,
                                 [&](std::string_view each) { return same_letters(word, each); }))
            rest.push_back(word);
    return rest;
}

/// Leaves out what files of the format cannot hold, as POV-Ray does, but says so.
void fit_format(Options& options, Diagnostics& diagnostics) {
    if (!options.to_file) return;
    const PictureTypeInfo& type =
        info(options.type.value_or(type_of_name(options.output).value_or(PictureType::png)));
    const auto left_out = [&](std::string_view what) {
        diagnostics.add(warning(
            Fault::option, {},
            message(what, " left out: files of format ", type.extension, " cannot have it")));
    };
    if (std::exchange(options.alpha, options.alpha && type.alpha) && !type.alpha)
        left_out("the alpha channel is");
    if (std::exchange(options.grey, options.grey && type.grey) && !type.grey)
        left_out("grey alone is");
    if (options.bits == 16 && !type.wide) {
        options.bits.reset();
        left_out("16 bits a channel are");
    }
}

/// Whether the version is asked for, in any of POV-Ray's spellings.
bool asks_version(std::span<const std::string_view> arguments) {
    return std::ranges::any_of(
        arguments, [](std::string_view word) { return word == "--version" || word == "-version"; });
}

}  // namespace

std::string_view command_named(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return name == "candelabra-povray" || name == "povray" ? "povray" : "";
}

int run_povray(std::span<const std::string_view> arguments, const Console& console) {
    if (asks_version(arguments)) {
        // POV-Ray writes it to this stream. Programs look for its name and a number behind it.
        console.err(message("POV-Ray 3.7 scenes are rendered by ", program_name(), "\n"));
        return exit_status::done;
    }
    Diagnostics diagnostics;
    Options options = read_options(without_window(arguments), diagnostics, disk_reader(),
                                   console.settings, povray_defaults());
    fit_format(options, diagnostics);
    const bool shown = talks(options) && options.streams[Stream::render].shown;
    if (options.progress == "auto" && !console.terminal && shown) options.progress = "povray";
    Console same = console;
    if (!console.povray_library.empty()) same.first_libraries.push_back(console.povray_library);
    return run_with(std::move(options), same, std::move(diagnostics));
}

}  // namespace candelabra
