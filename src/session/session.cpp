// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "session/lookalikes.h"

#include "text/message.h"
#include "text/printable.h"
#include "text/sha256.h"
#include "world/compile.h"
#include "world/review.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace candelabra {

Session::Session(SessionSettings settings, Diagnostics& diagnostics)
    : settings_(std::move(settings)), diagnostics_(diagnostics) {}

Reader Session::noted(Reader reader) {
    return settings_.notes_files ? noting(std::move(reader), files_) : reader;
}

bool Session::read() {
    const SceneSource& source = settings_.source;
    std::string path = source.path;
    if (source.text) {
        files_.push_back({path, sha256(*source.text)});
        main_ = sources_.add(source.name, *source.text);
        return true;
    }
    const Reader read = noted(disk_reader());
    std::optional<std::string> text = read(path);
    if (!text && !std::filesystem::path(path).has_extension()) text = read(path += ".pov");
    if (!text) {
        std::error_code none;
        const auto status = std::filesystem::status(source.path, none);
        const bool other = std::filesystem::is_other(status);
        if (other || std::filesystem::is_directory(status)) {
            diagnostics_.add(error(Fault::io, {},
                                   message('`', printable(source.path), "` is a ",
                                           other ? "device or pipe" : "folder", ", not a scene")));
            return false;
        }
        const std::string near = similar_file(source.path, {""}, disk_lister());
        diagnostics_.add(
            error(Fault::io, {},
                  message("there is no scene `", printable(source.path), "` that can be read"))
                .with_help(near.empty() ? "" : message("did you mean `", near, "`?")));
        return false;
    }
    folder_ = directory_of(path);
    main_ = sources_.add(path, std::move(*text));
    return true;
}

/// Returns access to the scene's own files and those that the run also permits.
FileAccess Session::file_access() const {
    const SceneSource& source = settings_.source;
    std::vector<std::string> readable = source.library;
    readable.insert(readable.end(), source.readable.begin(), source.readable.end());
    FileAccess access(readable, source.writable);
    access.reads(scene_folders(folder_, source.picture));
    if (source.made_files) access.remembers(source.made_files);
    return access;
}

Scene Session::evaluate() { return evaluate(0, diagnostics_); }

Scene Session::evaluate(double clock_ahead, Diagnostics& diagnostics) {
    const SceneSource& source = settings_.source;
    const FileAccess scene_access = file_access();
    Loader loader(noted(scene_reader(scene_access)), folder_, source.library, scene_access,
                  disk_lister());
    loader.set_standard_library(source.standard_library);
    // Files are written once, not again for each sample of an open shutter.
    if (!source.writes_files || clock_ahead > 0) loader.keep_off_disk();
    EvaluateOptions options = settings_.evaluation;
    options.facts.clock += clock_ahead;
    options.facts.image_width = settings_.render.width;
    options.facts.image_height = settings_.render.height;
    if (clock_ahead > 0) options.print = {};
    Scene scene = candelabra::evaluate(sources_, loader, main_, options, diagnostics);
    settle_settings(scene.settings, settings_.render);
    if (const std::string wrong = settle_film(scene.film, settings_.render); !wrong.empty())
        diagnostics.add(
            error(Fault::option, {}, message("the options do not fit the scene's film: ", wrong)));
    return scene;
}

/// Evaluates the scene at a later sample of the shutter. Reports only errors, since the first
/// sample has produced all warnings.
std::optional<Scene> Session::scene_at(double clock_ahead) {
    Diagnostics problems;
    Scene scene = evaluate(clock_ahead, problems);
    for (const Diagnostic& each : problems.all())
        if (each.severity == Severity::error) diagnostics_.add(each);
    if (problems.failed()) return std::nullopt;
    return scene;
}

void Session::review_text() {
    const SceneSource& source = settings_.source;
    const auto in_library = [&](std::string_view path) {
        return !source.standard_library.empty() && path.starts_with(source.standard_library + "/");
    };
    review_lookalikes(sources_, in_library, source.povray_library, diagnostics_);
}

void Session::review_shape(const Scene& scene) {
    if (settings_.shows_picture)
        candelabra::review_shape(scene, settings_.render.width, settings_.render.height,
                                 diagnostics_);
}

void Session::review(const Scene& scene) {
    review_text();
    candelabra::review(scene, *survey(scene, diagnostics_), diagnostics_);
    review_shape(scene);
}

SharedWorld Session::compile(Scene&& scene, Shutter shutter, bool reviewed) {
    if (reviewed) {
        review_text();
        review_shape(scene);
    }
    const RenderSettings& r = settings_.render;
    const CompileOptions options{r.threads,
                                 r.light_sampler,
                                 r.index,
                                 r.quality,
                                 settings_.remembers_objects,
                                 settings_.follows_lamps,
                                 settings_.instances,
                                 reviewed};
    const ShutterScenes later{sources_, [this](double ahead) { return scene_at(ahead); }};
    return candelabra::compile(std::move(scene), options, diagnostics_,
                               shutter == Shutter::all_samples ? &later : nullptr);
}

}  // namespace candelabra
