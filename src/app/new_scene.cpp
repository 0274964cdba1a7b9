// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/new_scene.h"

#include "options/subcommands.h"
#include "picture/file.h"
#include "text/excerpt.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view usage = "candelabra new [--template NAME] scene.pov";

fs::path template_folder(const std::string& library) { return fs::path(library) / "templates"; }

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += message(text.empty() ? "" : ", ", name);
    return text;
}

/// What the arguments ask for.
struct NewScene {
    std::string name{usual_template};
    std::string path;
};

std::optional<NewScene> wanted_by(std::span<const std::string_view> arguments,
                                  Diagnostics& diagnostics) {
    NewScene wanted;
    const auto fail = [&](const std::string& text) {
        diagnostics.add(error(Fault::option, {}, text).with_help(std::string(usage)));
        return std::nullopt;
    };
    const auto take = [&](std::string_view, std::string name) { wanted.name = std::move(name); };
    Diagnostics given;
    const std::vector<std::string> words = take_options("new", arguments, take, given);
    if (given.failed()) return fail(given.all().front().message);
    for (const std::string& word : words)
        if (word.starts_with('-'))
            return fail(message("new has no option `", printable(word), "`"));
        else if (!wanted.path.empty())
            return fail("only one scene is made at a time");
        else
            wanted.path = word;
    if (wanted.path.empty()) return fail("new needs the name of the scene's file");
    if (fs::path(wanted.path).extension().empty()) wanted.path += ".pov";
    return wanted;
}

/// Writes the scene. Returns the exit status.
int write_scene(const NewScene& wanted, const Console& console, Diagnostics& diagnostics) {
    const std::vector<std::string> names = scene_templates(console.library);
    if (std::ranges::find(names, wanted.name) == names.end()) {
        diagnostics.add(
            error(Fault::option, {}, message("there is no template `", printable(wanted.name), "`"))
                .with_help(names.empty() ? std::string("the standard library has no templates")
                                         : message("there are ", joined(names))));
        return exit_status::usage;
    }
    std::error_code failed;
    if (fs::symlink_status(wanted.path, failed).type() != fs::file_type::not_found) {
        diagnostics.add(
            error(Fault::io, {}, message("`", printable(wanted.path), "` exists already"))
                .with_help("another name, as nothing is overwritten"));
        return exit_status::file;
    }
    const fs::path from = template_folder(console.library) / (wanted.name + ".pov");
    const std::optional<std::string> text = disk_reader()(from.string());
    if (!text) {
        diagnostics.add(
            error(Fault::io, {}, message("`", printable(from.string()), "` cannot be read")));
        return exit_status::file;
    }
    if (!write_file(wanted.path, *text, diagnostics)) return exit_status::file;
    const std::string path = printable(wanted.path);
    console.out(message(path, ": a scene to begin with\n", "candelabra ", path, " --preview\n"));
    return exit_status::done;
}

}  // namespace

std::vector<std::string> scene_templates(const std::string& library) {
    std::vector<std::string> names;
    std::error_code failed;
    if (library.empty()) return names;
    for (const auto& entry : fs::directory_iterator(template_folder(library), failed))
        if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

int new_scene(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    const std::optional<NewScene> wanted = wanted_by(arguments, diagnostics);
    const int status = wanted ? write_scene(*wanted, console, diagnostics) : exit_status::usage;
    for (const Diagnostic& each : diagnostics.all())
        console.err(format(each, SourceStore(), console.coloured));
    return status;
}

}  // namespace candelabra
