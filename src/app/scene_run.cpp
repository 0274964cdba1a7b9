// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_run.h"

#include "app/library.h"
#include "base/deep_stack.h"
#include "console/diagnostics_json.h"
#include "console/progress.h"
#include "options/memory_limit.h"
#include "options/output.h"
#include "options/region.h"
#include "output/depfile.h"
#include "output/index_slice.h"
#include "output/layers.h"
#include "output/balance_report.h"
#include "output/light_report.h"
#include "output/measurement.h"
#include "output/mesh_export.h"
#include "output/stats.h"
#include "output/world_report.h"
#include "picture/file.h"
#include "production/file_lock.h"
#include "production/render_job.h"
#include "scene/dump.h"
#include "session/session.h"
#include "syntax/dump.h"
#include "syntax/parser.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/scene_text.h"

#include <iostream>
#include <iterator>
#include <optional>

namespace candelabra {

namespace {

constexpr std::string_view draft_words =
    "draft: noise is averaged away, and small shadows and reflections with it; without --draft the "
    "picture is exact\n";

/// The shared data of the steps of one run.
class SceneRun {
public:
    SceneRun(const Options& options, const Console& console, Diagnostics& diagnostics)
        : options_(options), console_(console), diagnostics_(diagnostics) {}

    int execute() {
        const Output output = output_of(options_, diagnostics_);
        read_part();
        if (say_diagnostics()) return exit_status::usage;
        if (!destinations_work(output)) return exit_status::file;
        bound_memory();
        open_session(output);
        session_->read();
        if (say_diagnostics()) return exit_status::file;
        return dispatch(output);
    }

private:
    /// Determines the part of the work that this run does, and reports invalid parts.
    void read_part() {
        const RenderSettings& settings = options_.render;
        const Region region = region_of(options_);
        const auto refuse = [&](std::string text, std::string help = {}) {
            diagnostics_.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        };
        if (region.left >= region.right || region.top >= region.bottom)
            refuse("no row or column of the picture is left to render");
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

    /// Sets the memory limit. The evaluation's stack is reserved but hardly used, so it does not
    /// count.
    void bound_memory() {
        const auto bytes = options_.memory_bytes ? options_.memory_bytes : physical_memory();
        const std::uint64_t stacks = options_.at_once * options_.limits.stack_bytes;
        if (bytes) limit_memory(*bytes + stacks);
    }

    bool is_check() const {
        return options_.task == Task::check || options_.task == Task::check_syntax;
    }

    SourceStore& sources() { return session_ ? session_->sources() : before_; }

    /// Prints the new diagnostics. Returns whether there are errors.
    bool say_diagnostics() {
        const auto& all = diagnostics_.all();
        for (; said_ < all.size(); ++said_)
            if (options_.verbose || all[said_].severity != Severity::note)
                candelabra::say(console_, options_, all[said_], sources());
        if (diagnostics_.full() && !options_.diagnostics_as_json)
            candelabra::say(console_, Stream::fatal,
                            message("stopped after ", diagnostics_.error_count(), " errors\n"));
        return diagnostics_.failed();
    }

    /// Returns the outputs of the film as far as the options determine them.
    FilmFiles files_of(const Output& output) const {
        FilmFiles files{output.path, output.format, options_.alpha, options_.layers};
        files.denoise = options_.denoise;
        files.draft = options_.draft;
        files.threads = options_.render.threads;
        return files;
    }

    /// Finds problems with destinations before the long work begins.
    bool destinations_work(const Output& output) {
        const bool renders = options_.task == Task::render, saves = renders && options_.to_file;
        const std::string layers = renders ? layers_path(files_of(output)) : "";
        const std::string quiet = saves ? denoised_path(files_of(output)) : "";
        if (saves) can_write(output.format.type, diagnostics_);
        if (!layers.empty()) can_write(PictureType::exr, diagnostics_);
        const std::string state =
            saves && !is_stream(output.path) ? state_path(output.path, shard_) : "";
        for (const std::string& path :
             {saves ? output.path : std::string(), options_.stats_file, options_.depfile,
              options_.mesh_file, options_.readings_file, layers, quiet, state}) {
            const std::string problem = problem_with_output(options_, path);
            if (!problem.empty()) diagnostics_.add(error(Fault::io, {}, problem));
        }
        if (saves && output.path == "-" && options_.stats_file == "-")
            diagnostics_.add(error(Fault::option, {},
                                   "the standard output cannot take both the picture and the "
                                   "statistics")
                                 .with_help("--stats FILE"));
        return !say_diagnostics();
    }

    SessionSettings session_settings(const Output& output) const {
        SessionSettings settings;
        SceneSource& source = settings.source;
        source.path = *options_.scene;
        source.standard_library = console_.library;
        source.povray_library = console_.povray_library;
        source.library = library_folders(options_.libraries, console_.library,
                                         options_.library_paths, diagnostics_);
        source.readable = options_.readable;
        source.writable = options_.writable;
        source.writable.insert(source.writable.begin(), own_folder(output, options_));
        source.picture = is_stream(output.path) ? "" : output.path;
        source.made_files = console_.made_files;
        source.writes_files = options_.task == Task::render || options_.task == Task::export_mesh;
        settings.render = options_.render;
        settings.evaluation = {options_.declares, options_.facts, options_.limits, {}, {}};
        if (options_.task == Task::export_mesh) settings.evaluation.only = options_.mesh_object;
        // Pictures record the files that they were made from; checks need not.
        settings.notes_files = options_.task == Task::render;
        settings.shows_picture = !measures_light(options_);
        settings.follows_lamps = options_.task == Task::balance;
        settings.remembers_objects = console_.preview || settings.follows_lamps ||
                                     aovs_for(options_.layers, false).surface;
        return settings;
    }

    /// Opens the session. The scene may come from standard input.
    void open_session(const Output& output) {
        SessionSettings settings = session_settings(output);
        settings.source.name = "standard input";
        if (settings.source.path == "-")
            settings.source.text = std::string(std::istreambuf_iterator<char>(std::cin), {});
        settings.evaluation.print = [this](std::string_view text) {
            if (options_.diagnostics_as_json) {
                if (console_.heard) console_.heard(Stream::debug, printable_lines(text));
                return console_.err(debug_to_json(text));
            }
            candelabra::say(console_, Stream::debug, marked(text));
            if (!text.empty()) line_is_open_ = !text.ends_with('\n');
        };
        session_.emplace(std::move(settings), diagnostics_);
    }

    /// Returns the scene's text as it may be printed. To programs, which obey certain lines, each
    /// line of the scene says whose it is.
    std::string marked(std::string_view text) const {
        const std::string shown = printable_lines(text);
        using enum Progress::Style;
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

    int dispatch(const Output& output) {
        if (options_.task == Task::dump_tokens)
            return say(dump_tokens(session_->main(), sources(), names_, diagnostics_));
        if (options_.task == Task::dump_tree || options_.task == Task::check_syntax) {
            const Tree tree = parse(session_->main(), sources(), names_, diagnostics_);
            return say(is_check() ? "" : dump(tree, names_));
        }
        statistics_.parse = time_now();
        std::optional<WrittenFunctions> written;  // the dump needs them
        if (options_.task == Task::dump_scene) written.emplace();
        Scene scene = evaluate_scene();
        statistics_.parse = time_now() - statistics_.parse;
        if (console_.files_read) console_.files_read(session_->files());
        if (options_.task == Task::dump_scene) return say(diagnostics_.failed() ? "" : dump(scene));
        if (say_diagnostics()) return exit_status::scene;
        if (options_.task == Task::export_mesh) return export_mesh(scene);
        const bool dumps = options_.task == Task::dump_world || options_.task == Task::dump_index;
        if (!dumps) session_->review(scene);
        if (say_diagnostics()) return exit_status::scene;
        if (is_check() && options_.stats_file.empty()) return say("");
        statistics_.compile = time_now();
        const std::vector<Meter> meters = scene.meters;
        const Vec3 up =
            std::visit([](const View& view) { return view.sky; }, scene.camera);
        Output fitting = output;
        fitting.format.gamma = scene.settings.assumed_gamma;
        fitting.format.encoded = scene.gamma_handling;
        using enum Session::Shutter;
        const SharedWorld world =
            session_->compile(std::move(scene), is_check() || dumps ? first_sample : all_samples);
        if (say_diagnostics()) return exit_status::scene;
        if (options_.task == Task::dump_index) return say(index_slice(*world));
        if (dumps) return say(report(*world));
        if (console_.preview) return look_at(world, fitting);
        const Shot shot(world, ShotSettings::of(options_.render));
        statistics_.compile = time_now() - statistics_.compile;
        if (options_.task == Task::measure) return measure_light(shot, meters);
        if (options_.task == Task::balance) return balance_light(shot, up);
        return is_check() ? finish(shot) : render_picture(shot, fitting);
    }

    int export_mesh(const Scene& scene) {
        const std::string mesh = exported_mesh(
            scene, mesh_format(options_.mesh_file).value_or(MeshFormat::ply), diagnostics_);
        if (!mesh.empty()) write_file(options_.mesh_file, mesh, diagnostics_);
        return say_diagnostics() ? exit_status::file : exit_status::done;
    }

    int measure_light(const Shot& shot, const std::vector<Meter>& meters) {
        const LightUnits units = shot.world->rules.settings.light_units();
        review_meters(*shot.world, meters, diagnostics_);
        if (say_diagnostics()) return exit_status::scene;
        MeasureSettings settings;
        settings.seed = options_.render.seed;
        settings.threads = options_.render.threads;
        settings.samples = options_.render.samples;
        settings.goal = options_.meter_goal;
        bool stopped = false;
        settings.ended = ends_measuring(stopped);
        const std::vector<MeterReading> readings = measure(shot, meters, settings);
        const MeasuredScene measured{meters, readings, units, settings.seed};
        const bool json = reading_format(options_.readings_file) == ReadingFormat::json;
        write_measured(json ? readings_as_json(measured) : readings_as_csv(measured),
                       readings_as_text(measured));
        if (say_diagnostics()) return exit_status::file;
        return stopped ? exit_status::stopped : exit_status::done;
    }

    int balance_light(const Shot& shot, const Vec3& up) {
        review_balance(*shot.world, diagnostics_);
        if (say_diagnostics()) return exit_status::scene;
        BalanceSettings settings;
        settings.seed = options_.render.seed;
        settings.threads = options_.render.threads;
        settings.up = up;
        bool stopped = false;
        settings.ended = ends_measuring(stopped);
        const LightBalance balance = balance_of_light(shot, settings);
        const BalancedScene balanced{*shot.world, balance, sources(), settings.seed};
        const bool json = reading_format(options_.readings_file) == ReadingFormat::json;
        write_measured(json ? balance_as_json(balanced) : balance_as_csv(balanced),
                       balance_as_text(balanced));
        if (say_diagnostics()) return exit_status::file;
        return stopped ? exit_status::stopped : exit_status::done;
    }

    /// Whether measuring is to end: time is over, or a signal has come, which sets `stopped`.
    std::function<bool()> ends_measuring(bool& stopped) {
        return [this, &stopped, begun = seconds_now()] {
            const auto& take = console_.interrupts.take;
            stopped = stopped || (take && take() == Interrupt::stop);
            return stopped || (options_.time && seconds_now() - begun > *options_.time);
        };
    }

    /// Writes a table to its file, and tells people the text.
    void write_measured(const std::string& table, const std::string& text) {
        if (options_.readings_file == "-")
            console_.out(table);
        else if (write_file(options_.readings_file, table, diagnostics_) && options_.verbose)
            console_.out(text);
    }

    /// Prints the result of a check or a dump, and the diagnostics.
    int say(const std::string& text) {
        console_.out(text);
        if (say_diagnostics()) return exit_status::scene;
        if (is_check()) say_correct();
        return exit_status::done;
    }

    void say_correct() {
        if (talks(options_))
            candelabra::say(console_, Stream::render,
                            message(printable(*options_.scene), ": no errors\n"));
    }

    Scene evaluate_scene() {
        Scene scene = session_->evaluate();
        // Ends a line of the scene's output that is still open.
        if (line_is_open_) candelabra::say(console_, Stream::debug, "\n");
        return scene;
    }

    Progress progress() const {
        using enum Progress::Style;
        const bool shown = talks(options_) && options_.streams[Stream::render].shown;
        const Progress::Style usual = !shown ? silent : console_.terminal ? terminal : lines;
        const Progress::Style style = progress_style(options_.progress).value_or(usual);
        // Farm managers read standard output, unless the picture goes there.
        const bool out = (style == alf || style == openjd) && options_.output != "-";
        return Progress(style, seconds_now, out ? console_.out : console_.err, options_.share);
    }

    /// Returns the film with a grain pattern of its own for each picture.
    FilmSettings film_of_frame(FilmSettings film) const {
        constexpr std::uint32_t most = (1u << 30) - 1;
        if (film.grain > 0)
            film.grain_seed =
                static_cast<int>((static_cast<std::uint32_t>(film.grain_seed) +
                                  static_cast<std::uint32_t>(options_.render.seed) +
                                  static_cast<std::uint32_t>(options_.facts.frame_number)) &
                                 most);
        return film;
    }

    /// Passes the scene to the preview, which renders it.
    int look_at(const SharedWorld& world, const Output& output) {
        const std::vector<std::string> lights = light_names(*world, sources());
        const WorldView& view = world->stated_view;
        console_.preview({world, sources(), options_, output.format,
                          film_of_frame(film_in(view.camera, view.film)), lights});
        return exit_status::done;
    }

    int render_picture(const Shot& shot, const Output& output) {
        const World& world = *shot.world;
        Identity identity = identity_of(options_, session_->files(), output.format);
        FilmFiles files = files_of(output);
        files.film = film_of_frame(shot.view.film);
        note_film(identity, files.film);
        if (aovs_for(options_.layers, false).lights) {
            files.lights = light_names(world, sources());
            note_lights(identity, files.lights);
        }
        JobPlan plan{options_, identity, output.path, shard_, console_.winds_down};
        made_path_ = shard_ ? state_path(plan) : output.path;
        RenderJob job(plan, shot, console_.interrupts, diagnostics_);
        const bool locks = job.can_keep();
        const FileLock lock(locks ? state_path(plan) : std::string());
        if (lock.taken())
            diagnostics_.add(error(
                Fault::io, {},
                message("another run is making `", printable(output.path), "` at the moment")));
        else
            job.prepare();
        if (say_diagnostics()) return exit_status::file;
        if (!take_turn()) return exit_status::stopped;
        const JobEnd end = work(job);
        if (end == JobEnd::stopped) return say_stopped(plan, job);
        files.format.description = description(identity, job.samples(), files.format);
        if (options_.to_file && !shard_ && end == JobEnd::finished)
            write_film(job.film(), files, diagnostics_);
        const bool lost = diagnostics_.failed();
        job.leave_state(shard_ || options_.keep_state || lost);
        show_light(world, job);
        if (say_diagnostics()) return exit_status::file;
        const int status = finish(shot);
        if (talks(options_) && status == exit_status::done)
            candelabra::say(console_, Stream::statistics,
                            message(options_.to_file ? printable(made_path_) : "no file", ": ",
                                    summary(statistics_), "\n"));
        if (options_.draft && talks(options_) && status == exit_status::done)
            candelabra::say(console_, Stream::statistics, draft_words);
        return status;
    }

    /// Waits until rendering may begin, and excludes the waiting time from the statistics.
    bool take_turn() {
        const double before = time_now().seconds;
        const bool wanted = !console_.begins_rendering || console_.begins_rendering();
        start_.seconds += time_now().seconds - before;
        return wanted;
    }

    /// Prints the light report if it is requested.
    void show_light(const World& world, const RenderJob& job) {
        if (options_.light_report) console_.err(light_report(world, job.rays(), sources()));
    }

    JobEnd work(RenderJob& job) {
        Progress shown = progress();
        if (console_.interrupts.listening) console_.interrupts.listening(true);
        statistics_.render = time_now();
        const JobEnd end = job.run(shown, seconds_now);
        statistics_.render = time_now() - statistics_.render;
        if (console_.interrupts.listening) console_.interrupts.listening(false);
        statistics_.rays = job.rays();
        shown.finish();
        if (console_.ends_rendering && end == JobEnd::finished) console_.ends_rendering();
        return end;
    }

    int say_stopped(const JobPlan& plan, const RenderJob& job) {
        if (say_diagnostics()) return exit_status::file;
        if (!options_.diagnostics_as_json)
            console_.err(job.can_keep() ? message("stopped; +C goes on from `",
                                                  printable(state_path(plan)), "`\n")
                                        : std::string("stopped; there is no place for a state\n"));
        return exit_status::stopped;
    }

    /// Completes the statistics, which a check prints, too.
    int finish(const Shot& shot) {
        statistics_.total = time_now() - start_;
        statistics_.prepared_ahead = options_.prepared_ahead;
        complete(statistics_, shot, options_.render);
        if (is_check()) say_correct();
        if (!options_.depfile.empty() && options_.task == Task::render) write_depfile();
        if (options_.stats_file == "-")
            console_.out(to_json(statistics_));
        else if (!options_.stats_file.empty())
            write_file(options_.stats_file, to_json(statistics_), diagnostics_);
        return say_diagnostics() ? exit_status::file : exit_status::done;
    }

    void write_depfile() {
        const auto& files = session_->files();
        const std::string odd = unnameable_in_depfile(made_path_, files);
        if (odd.empty())
            write_file(options_.depfile, depfile(made_path_, files), diagnostics_);
        else
            diagnostics_.add(error(Fault::io, {},
                                   message("`", printable(options_.depfile),
                                           "` is not written: a rule of make cannot name `",
                                           printable(odd), "`"))
                                 .with_help("rename the file"));
    }

    const Options& options_;
    const Console& console_;
    Diagnostics& diagnostics_;
    Names names_;
    std::optional<Session> session_;  ///< set once the options are known to be valid
    SourceStore before_;              ///< of earlier messages: empty
    bool line_is_open_ = false;       ///< the scene's last output has no newline yet
    std::optional<Shard> shard_;      ///< unset: the whole picture
    std::string made_path_;           ///< of the picture or the shard
    std::size_t said_ = 0;
    Phase start_ = time_now();
    RunStatistics statistics_;
};

}  // namespace

int run_scene(const Options& options, const Console& console, Diagnostics& diagnostics) {
    int status = exit_status::scene;
    on_deep_stack(options.limits.stack_bytes,
                  [&](std::size_t) { status = SceneRun(options, console, diagnostics).execute(); });
    return status;
}

}  // namespace candelabra
