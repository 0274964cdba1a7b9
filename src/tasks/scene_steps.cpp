// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/scene_steps.h"

#include "base/deep_stack.h"
#include "console/diagnostics_json.h"
#include "console/progress.h"
#include "options/memory_limit.h"
#include "options/region.h"
#include "output/depfile.h"
#include "picture/file.h"
#include "production/render_job.h"
#include "tasks/kept_lights.h"
#include "tasks/library_folders.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/scene_text.h"

#include <iostream>
#include <iterator>
#include <utility>

namespace candelabra {

SceneSteps::SceneSteps(const Options& options, const Console& console, Diagnostics& diagnostics)
    : options_(options), console_(console), diagnostics_(diagnostics) {}

int SceneSteps::open() {
    output_ = output_of(options_, diagnostics_);
    read_part();
    if (say_diagnostics()) return exit_status::usage;
    if (!destinations_work()) return exit_status::file;
    bound_memory();
    open_session();
    session_->read();
    return say_diagnostics() ? exit_status::file : exit_status::done;
}

Scene SceneSteps::evaluated() {
    statistics_.parse = time_now();
    Scene scene = session_->evaluate();
    // Ends a line of the scene's output that is still open.
    if (line_is_open_) say(console_, Stream::debug, "\n");
    statistics_.parse = time_now() - statistics_.parse;
    if (console_.files_read) console_.files_read(session_->files());
    return scene;
}

std::optional<Scene> SceneSteps::valid_scene() {
    std::optional<Scene> scene = evaluated();
    if (say_diagnostics() || stopped_by_caller()) scene.reset();
    return scene;
}

bool SceneSteps::reviewed(const Scene& scene) {
    session_->review(scene);
    return !say_diagnostics();
}

SharedWorld SceneSteps::compiled(Scene&& scene, Session::Shutter shutter) {
    return compiled(std::move(scene), shutter, false);
}

SharedWorld SceneSteps::reviewed_world(Scene&& scene, Session::Shutter shutter) {
    return compiled(std::move(scene), shutter, true);
}

SharedWorld SceneSteps::compiled(Scene&& scene, Session::Shutter shutter, bool reviewed) {
    statistics_.compile = time_now();
    output_.format.gamma = scene.settings.assumed_gamma;
    output_.format.encoded = scene.gamma_handling;
    SharedWorld world = session_->compile(std::move(scene), shutter, reviewed);
    return say_diagnostics() ? nullptr : world;
}

Shot SceneSteps::shot(const SharedWorld& world) {
    Shot shot(world, ShotSettings::of(options_.render));
    statistics_.compile = time_now() - statistics_.compile;
    return shot;
}

bool SceneSteps::say_diagnostics() {
    const auto& all = diagnostics_.all();
    for (; said_ < all.size(); ++said_)
        if (options_.verbose || all[said_].severity != Severity::note)
            say(console_, options_, all[said_], sources());
    if (diagnostics_.full() && !options_.diagnostics_as_json)
        say(console_, Stream::fatal,
            message("stopped after ", diagnostics_.error_count(), " errors\n"));
    return diagnostics_.failed();
}

int SceneSteps::print(const std::string& text) {
    console_.out(text);
    return say_diagnostics() ? exit_status::scene : exit_status::done;
}

int SceneSteps::finish(const Shot& shot, const std::string& made) {
    statistics_.total = time_now() - start_;
    statistics_.prepared_ahead = options_.prepared_ahead;
    complete(statistics_, shot, options_.render, sources());
    if (!options_.depfile.empty() && !made.empty()) write_depfile(made);
    if (options_.stats_file == "-")
        console_.out(to_json(statistics_));
    else if (!options_.stats_file.empty())
        write_file(options_.stats_file, to_json(statistics_), diagnostics_);
    return say_diagnostics() ? exit_status::file : exit_status::done;
}

FilmFiles SceneSteps::film_files() const {
    FilmFiles files{output_.path, output_.format, options_.alpha, options_.layers};
    files.denoise = options_.denoise;
    files.draft = options_.draft;
    files.threads = options_.render.threads;
    return files;
}

/// Determines the part of the work that this run does, and reports invalid parts.
void SceneSteps::read_part() {
    const RenderSettings& settings = options_.render;
    const Region region = region_of(options_);
    const auto refuse = [&](std::string text, std::string help = {}) {
        diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    };
    if (region.left >= region.right || region.top >= region.bottom)
        refuse("no row or column of the picture is left to render");
    check_kept_lights(options_, diagnostics_);
    const bool frame = options_.facts.initial_frame != 0 || options_.facts.final_frame != 0;
    if (!options_.shard.empty() && options_.shard_by == ShardBy::frames && !frame)
        refuse("a single picture has no frames to share", "--shard-by samples or tiles");
    if (options_.shard.empty() || options_.shard_by == ShardBy::frames) return;
    shard_ = read_shard(options_.shard, console_.environment, diagnostics_);
    if (options_.time || settings.noise > 0)
        refuse(
            "shards must know how many samples there will be: --shard goes neither with "
            "--time nor with --noise");
    else if (options_.shard_by != ShardBy::tiles && !is_even(settings))
        refuse("shards of samples must know how many samples there will be",
               "--samples N, or --shard-by tiles");
    if (options_.output == "-" || !options_.to_file)
        refuse("a shard is a file, which cannot go to standard output or nowhere");
}

/// Sets the memory limit. The evaluation's stack is reserved but hardly used, so it does not count.
void SceneSteps::bound_memory() const {
    if (!console_.owns_process) return;
    const auto bytes = options_.memory_bytes ? options_.memory_bytes : physical_memory();
    const std::uint64_t stacks =
        options_.at_once * memory_of_deep_stack(options_.limits.stack_bytes);
    if (bytes) limit_memory(*bytes + stacks);
}

/// Finds problems with destinations before the long work begins.
bool SceneSteps::destinations_work() {
    const bool renders = options_.task == Task::render, saves = renders && options_.to_file;
    const std::string layers = saves ? layers_path(film_files()) : "";
    const std::string quiet = saves ? denoised_path(film_files()) : "";
    if (saves) can_write(output_.format.type, diagnostics_);
    if (!layers.empty()) can_write(PictureType::exr, diagnostics_);
    const std::string state =
        saves && !is_stream(output_.path) ? state_path(output_.path, shard_) : "";
    const auto works = [&](const std::string& path) {
        const std::string problem = problem_with_output(options_, path);
        if (!problem.empty()) diagnostics_.add(error(Fault::io, {}, problem));
        return problem.empty();
    };
    // The files beside a picture would only repeat its problem.
    if (works(saves ? output_.path : ""))
        for (const std::string& path : {layers, quiet, state}) works(path);
    for (const std::string& path : {options_.stats_file, options_.depfile, options_.mesh_file,
                                    options_.readings_file, options_.kept_lights})
        works(path);
    if (saves && output_.path == "-" && options_.stats_file == "-")
        diagnostics_.add(error(Fault::option, {},
                               "the standard output cannot take both the picture and the "
                               "statistics")
                             .with_help("--stats FILE"));
    return !say_diagnostics();
}

SessionSettings SceneSteps::session_settings() {
    SessionSettings settings;
    SceneSource& source = settings.source;
    source.path = *options_.scene;
    source.standard_library = console_.library;
    source.povray_library = console_.povray_library;
    source.library =
        library_folders(options_.libraries, console_.library, options_.library_paths, diagnostics_);
    source.readable = options_.readable;
    source.writable = options_.writable;
    source.writable.insert(source.writable.begin(), own_folder(output_, options_));
    source.picture = is_stream(output_.path) ? "" : output_.path;
    source.made_files = console_.made_files;
    source.writes_files = options_.task == Task::render || options_.task == Task::export_mesh;
    settings.render = options_.render;
    settings.evaluation = {options_.declares, options_.facts, options_.limits, {}, {}};
    if (options_.task == Task::export_mesh) settings.evaluation.only = options_.mesh_object;
    // Pictures record the files that they were made from; checks need not.
    settings.notes_files = options_.task == Task::render;
    settings.shows_picture = !measures_light(options_);
    settings.follows_lamps = options_.task == Task::balance;
    settings.remembers_objects =
        console_.preview || settings.follows_lamps || options_.task == Task::pick ||
        aovs_for(options_.layers, false).surface;
    return settings;
}

/// Whether the program that calls the run wants it to stop.
bool SceneSteps::stopped_by_caller() const {
    const auto& take = console_.interrupts.take;
    return !console_.owns_process && take && take() == Interrupt::stop;
}

/// Opens the session. The scene may come from standard input.
void SceneSteps::open_session() {
    SessionSettings settings = session_settings();
    settings.source.name = console_.text_name;
    if (settings.source.path == "-")
        settings.source.text = console_.text
                                   ? *console_.text
                                   : std::string(std::istreambuf_iterator<char>(std::cin), {});
    if (!console_.owns_process) settings.evaluation.ended = [this] { return stopped_by_caller(); };
    settings.evaluation.print = [this](std::string_view text) {
        if (options_.diagnostics_as_json) {
            if (console_.heard) console_.heard(Stream::debug, printable_lines(text));
            return console_.err(debug_to_json(text));
        }
        say(console_, Stream::debug, marked(text));
        if (!text.empty()) line_is_open_ = !text.ends_with('\n');
    };
    session_.emplace(std::move(settings), diagnostics_);
}

/// Returns the scene's text as it may be printed. To programs, which obey certain lines, each
/// line of the scene says whose it is.
std::string SceneSteps::marked(std::string_view text) const {
    const std::string shown = printable_lines(text);
    using enum ProgressStyle;
    const auto style = progress_style(options_.progress);
    if (style != alf && style != openjd && style != json) return shown;
    std::string result;
    bool open = line_is_open_;
    for (const char c : shown) {
        if (!open) result += "scene: ";
        open = c != '\n';
        result += c;
    }
    return result;
}

void SceneSteps::write_depfile(const std::string& made) {
    const auto& files = session_->files();
    const std::string odd = unnameable_in_depfile(made, files);
    if (odd.empty())
        write_file(options_.depfile, depfile(made, files), diagnostics_);
    else
        diagnostics_.add(
            error(Fault::io, {},
                  message("`", printable(options_.depfile),
                          "` is not written: a rule of make cannot name `", printable(odd), "`"))
                .with_help("rename the file"));
}

}  // namespace candelabra
