// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/diagnostics_json.h"
#include "app/help.h"
#include "app/memory_limit.h"
#include "app/movie.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/stats.h"
#include "app/world_report.h"
#include "base/parallel.h"
#include "evaluate/evaluate.h"
#include "picture/file.h"
#include "render/render.h"
#include "scene/dump.h"
#include "syntax/dump.h"
#include "syntax/lexer.h"
#include "syntax/parser.h"
#include "text/excerpt.h"
#include "text/harmless.h"
#include "text/loader.h"
#include "text/message.h"
#include "world/compile.h"
#include "world/review.h"

#include <filesystem>
#include <iostream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

/// One run over one scene: what the steps share.
class Run {
public:
    Run(const Options& options, const Console& console, Diagnostics& diagnostics)
        : options_(options), console_(console), diagnostics_(diagnostics) {}

    int execute() {
        const Output output = output_of(options_, diagnostics_);
        if (say_diagnostics()) return exit_status::usage;
        if (!destinations_work(output)) return exit_status::file;
        bound_memory();
        const std::optional<SourceId> main = read_scene();
        if (say_diagnostics() || !main) return exit_status::file;
        return dispatch(*main, output);
    }

private:
    /// The evaluation's stack is room that is set aside and hardly ever used, so it does not count.
    void bound_memory() {
        const auto bytes = options_.memory_bytes ? options_.memory_bytes : physical_memory();
        if (bytes) limit_memory(*bytes + options_.limits.stack_bytes);
    }

    /// What the scene may touch: what belongs to it, and what the options add.
    Door door(const std::string& picture_folder, const std::vector<std::string>& library) const {
        std::vector<std::string> readable = {scene_folder_, ""};
        std::vector<std::string> writable = {picture_folder};
        readable.insert(readable.end(), library.begin(), library.end());
        readable.insert(readable.end(), options_.readable.begin(), options_.readable.end());
        writable.insert(writable.end(), options_.writable.begin(), options_.writable.end());
        return Door(readable, std::move(writable));
    }

    bool is_check() const {
        return options_.task == Task::check || options_.task == Task::check_syntax;
    }

    std::string written(const Diagnostic& diagnostic) const {
        return options_.diagnostics_as_json ? to_json(diagnostic, sources_)
                                            : format(diagnostic, sources_, console_.coloured);
    }

    /// Prints what is new; true when there are errors.
    bool say_diagnostics() {
        const auto& all = diagnostics_.all();
        for (; said_ < all.size(); ++said_)
            if (options_.verbose || all[said_].severity != Severity::note)
                console_.err(written(all[said_]));
        if (diagnostics_.full() && !options_.diagnostics_as_json)
            console_.err(message("stopped after ", diagnostics_.error_count(), " errors\n"));
        return diagnostics_.failed();
    }

    /// Long work should not end at a missing folder.
    bool destinations_work(const Output& output) {
        const bool renders = options_.task == Task::render;
        for (const std::string& path :
             {renders && options_.to_file ? output.path : std::string(), options_.stats_file}) {
            if (path.empty()) continue;
            std::error_code none;
            std::string problem = problem_with_destination(path);
            if (fs::equivalent(path, *options_.scene, none))
                problem = message("`", harmless(path), "` is the scene itself");
            if (!problem.empty()) diagnostics_.add(error(Fault::io, {}, problem));
        }
        return !say_diagnostics();
    }

    std::optional<SourceId> read_scene() {
        std::string path = *options_.scene;
        if (path == "-")
            return sources_.add("standard input", {std::istreambuf_iterator<char>(std::cin), {}});
        const Reader read = disk_reader();
        std::optional<std::string> text = read(path);
        if (!text && !fs::path(path).has_extension()) text = read(path += ".pov");
        if (!text) {
            const std::string name = harmless(*options_.scene);
            diagnostics_.add(
                error(Fault::io, {}, message("there is no scene `", name, "` that can be read")));
            return std::nullopt;
        }
        scene_folder_ = directory_of(path);
        return sources_.add(path, std::move(*text));
    }

    std::vector<std::string> library_paths() {
        // As in POV-Ray, whose settings name its own library before the command line is read.
        std::vector<std::string> paths;
        if (!console_.library.empty()) paths.push_back(console_.library);
        for (std::string path : options_.library_paths) {
            while (path.size() > 1 && path.ends_with('/')) path.pop_back();
            std::error_code none;
            if (!fs::is_directory(path, none))
                diagnostics_.add(warning(
                    Fault::option, {},
                    message("there is no folder `", harmless(path), "` to look for files in")));
            paths.push_back(std::move(path));
        }
        return paths;
    }

    int dispatch(SourceId main, const Output& output) {
        if (options_.task == Task::dump_tokens)
            return say(dump_tokens(main, sources_, names_, diagnostics_));
        if (options_.task == Task::dump_tree || options_.task == Task::check_syntax) {
            const Tree tree = parse(main, sources_, names_, diagnostics_);
            return say(is_check() ? "" : dump(tree, names_));
        }
        statistics_.parse = time_now();
        Scene scene = evaluate_scene(main, folder_of(output));
        statistics_.parse = time_now() - statistics_.parse;
        if (options_.task == Task::dump_scene) return say(diagnostics_.failed() ? "" : dump(scene));
        if (say_diagnostics()) return exit_status::scene;
        if (options_.task != Task::dump_world)
            review(scene, survey(scene, diagnostics_), diagnostics_);
        if (say_diagnostics()) return exit_status::scene;
        if (is_check() && options_.stats_file.empty()) return say("");
        statistics_.compile = time_now();
        const World world =
            compile(std::move(scene), {options_.render.threads, options_.render.light_sampler},
                    diagnostics_);
        statistics_.compile = time_now() - statistics_.compile;
        if (options_.task == Task::dump_world) return say(report(world));
        if (is_check()) return finish(world);
        Output fitting = output;
        fitting.format.gamma = scene.settings.assumed_gamma;
        fitting.format.encoded = scene.gamma_handling;
        return render_picture(world, fitting);
    }

    /// The result of a check or a dump, and what is wrong.
    int say(const std::string& text) {
        console_.out(text);
        if (say_diagnostics()) return exit_status::scene;
        if (is_check()) say_correct();
        return exit_status::done;
    }

    void say_correct() {
        if (talks(options_)) console_.err(message(harmless(*options_.scene), ": no errors\n"));
    }

    Scene evaluate_scene(SourceId main, const std::string& picture_folder) {
        const std::vector<std::string> library = library_paths();
        const Loader loader(disk_reader(), scene_folder_, library, door(picture_folder, library),
                            disk_lister());
        EvaluateOptions options;
        options.limits = options_.limits;
        options.declares = options_.declares;
        options.facts = options_.facts;
        options.facts.image_width = options_.render.width;
        options.facts.image_height = options_.render.height;
        if (options_.diagnostics_as_json)
            options.print = [&](std::string_view text) { console_.err(debug_to_json(text)); };
        else if (options_.verbose)
            options.print = console_.err;
        return evaluate(sources_, loader, main, options, diagnostics_);
    }

    int render_picture(const World& world, const Output& output) {
        using enum Progress::Style;
        Progress progress(
            !talks(options_)    ? silent
            : console_.terminal ? terminal
                                : lines,
            [] { return time_now().seconds; }, console_.err);
        statistics_.render = time_now();
        const Rendering rendering =
            render(world, options_.render, {[&](double done) { progress.update(done); }, {}});
        statistics_.render = time_now() - statistics_.render;
        statistics_.rays = rendering.rays;
        progress.finish();
        if (options_.to_file)
            write_picture(rendering.image, output.path, output.format, diagnostics_);
        if (say_diagnostics()) return exit_status::file;
        const int status = finish(world);
        if (talks(options_) && status == exit_status::done)
            console_.err(message(options_.to_file ? harmless(output.path) : "no file", ": ",
                                 summary(statistics_), "\n"));
        return status;
    }

    /// The statistics, which a check has, too.
    int finish(const World& world) {
        statistics_.total = time_now() - start_;
        complete_statistics(world);
        if (is_check()) say_correct();
        if (options_.stats_file == "-")
            console_.out(to_json(statistics_));
        else if (!options_.stats_file.empty())
            write_file(options_.stats_file, to_json(statistics_), diagnostics_);
        return say_diagnostics() ? exit_status::file : exit_status::done;
    }

    void complete_statistics(const World& world) {
        statistics_.objects = world.objects;
        statistics_.primitives = world.material_of.size();
        statistics_.luminaires = world.luminaires.size();
        statistics_.light_sources = world.lights.size();
        statistics_.kdtree = ::statistics(world.tree);
        statistics_.peak_memory_bytes = peak_memory_bytes();
        statistics_.light_sampler_bytes =
            std::visit([](const auto& built) { return built.memory_bytes(); }, world.sampler);
        const LightSampler& sampler = world.settings.light_sampler;
        statistics_.light_sampler = Kinds<LightSampler>::infos[sampler.index()]->name;
        if (std::holds_alternative<LightOctree>(sampler))
            statistics_.light_octree_bytes = statistics_.light_sampler_bytes;
        const RenderSettings& settings = options_.render;
        statistics_.seed = settings.seed;
        statistics_.threads = settings.threads > 0 ? settings.threads : core_count();
        statistics_.width = settings.width;
        statistics_.height = settings.height;
        statistics_.samples = settings.samples;
        statistics_.shadow_rays = settings.shadow_rays;
    }

    const Options& options_;
    const Console& console_;
    Diagnostics& diagnostics_;
    SourceStore sources_;
    Names names_;
    std::string scene_folder_;
    std::size_t said_ = 0;
    Phase start_ = time_now();
    RunStatistics statistics_;
};

std::string explanation(const Options& options, Diagnostics& diagnostics) {
    if (options.task == Task::version) return version_text();
    if (options.task == Task::help) return help_text(options.topic, diagnostics);
    return description(options.topic, options.form, diagnostics);
}

int usage_errors(const Console& console, const Options& options, const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics.all())
        console.err(options.diagnostics_as_json ? to_json(each, SourceStore())
                                                : format(each, SourceStore(), console.coloured));
    return exit_status::usage;
}

/// Renders the frames of an animation, and joins them to a film.
class AnimationRun {
public:
    AnimationRun(const Options& options, const Animation& animation, const Console& console,
                 Diagnostics& diagnostics)
        : options_(options), animation_(animation), console_(console), diagnostics_(diagnostics) {}

    int execute() {
        Diagnostics checked = diagnostics_.fresh();
        output_ = output_of(options_, checked);
        if (!options_.movie.empty()) find_ffmpeg(diagnostics_);
        if (diagnostics_.failed()) return usage_errors(console_, options_, diagnostics_);
        for (std::size_t i = 0; i < animation_.frames.size(); ++i)
            if (const int status = render_frame(i); status != exit_status::done) return status;
        return options_.movie.empty() ? exit_status::done : join();
    }

private:
    int render_frame(std::size_t i) {
        const AnimationFrame& frame = animation_.frames[i];
        Options options = options_;
        options.type = output_.format.type;
        options.output = output_.path == "-"
                             ? output_.path
                             : numbered(output_.path, frame.number, animation_.digits);
        RunFacts& facts = options.facts;
        facts.clock = frame.clock;
        facts.clock_given = true;
        facts.frame_number = frame.number;
        facts.initial_frame = animation_.initial_frame;
        facts.final_frame = animation_.final_frame;
        facts.initial_clock = options_.animation.initial_clock;
        facts.final_clock = options_.animation.final_clock;
        facts.clock_delta = animation_.clock_delta;
        files_.push_back(options.output);
        std::error_code none;
        const bool there = options_.animation.skip_existing && options_.to_file &&
                           options_.task == Task::render && fs::exists(options.output, none);
        if (talks(options_))
            console_.err(message("frame ", frame.number, " (", i + 1, " of ",
                                 animation_.frames.size(), "), clock ", frame.clock,
                                 there ? ": is there\n" : "\n"));
        if (there) return exit_status::done;
        // What is wrong with the command line is said once.
        Diagnostics later = diagnostics_.fresh();
        return Run(options, console_, i == 0 ? diagnostics_ : later).execute();
    }

    int join() {
        Diagnostics problems = diagnostics_.fresh();
        if (make_movie(files_, options_.frame_rate, options_.movie, problems))
            return exit_status::done;
        usage_errors(console_, options_, problems);
        return exit_status::file;
    }

    const Options& options_;
    const Animation& animation_;
    const Console& console_;
    Diagnostics& diagnostics_;
    Output output_;
    std::vector<std::string> files_;
};

/// The options in force as an INI file.
std::string ini_text(const Options& options) {
    std::string text;
    for (const std::string& line : options.given) text += line + "\n";
    return text;
}

}  // namespace

int run(std::span<const std::string_view> arguments, const Console& console) {
    Diagnostics diagnostics;
    std::vector<std::string_view> all(arguments.begin(), arguments.end());
    if (!console.settings.empty()) all.insert(all.begin(), console.settings);
    const Options options = read_options(all, diagnostics, disk_reader());
    const std::optional<Animation> animation = plan(options.animation, diagnostics);
    if (diagnostics.failed()) return usage_errors(console, options, diagnostics);
    if (options.task == Task::help || options.task == Task::version ||
        options.task == Task::describe) {
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
    if (animation) return AnimationRun(options, *animation, console, diagnostics).execute();
    return Run(options, console, diagnostics).execute();
}
