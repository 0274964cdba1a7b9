// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/render_picture.h"

#include "console/progress.h"
#include "output/idle_lights.h"
#include "output/light_report.h"
#include "production/file_lock.h"
#include "production/render_job.h"
#include "relight/idle_lamps.h"
#include "relight/light_recorder.h"
#include "tasks/frame_film.h"
#include "tasks/kept_lights.h"
#include "text/message.h"
#include "text/printable.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

constexpr std::string_view draft_words =
    "draft: noise is averaged away, and small shadows and reflections with it; without --draft the "
    "picture is exact\n";

Progress progress(const Options& options, const Console& console) {
    using enum ProgressStyle;
    const bool shown = talks(options) && options.streams[Stream::render].shown;
    const Progress::Style usual = !shown ? silent : console.terminal ? terminal : lines;
    const Progress::Style style = progress_style(options.progress).value_or(usual);
    // Farm managers read standard output, unless the picture goes there.
    const bool out = (style == alf || style == openjd) && options.output != "-";
    return Progress(style, seconds_now, out ? console.out : console.err, options.share,
                    console.progressed,
                    1.0 * options.render.width * options.render.height);
}

/// Waits until rendering may begin, and excludes the waiting time from the statistics.
bool take_turn(SceneSteps& steps) {
    const double before = time_now().seconds;
    const auto& begins = steps.console().begins_rendering;
    const bool wanted = !begins || begins();
    steps.leave_out(time_now().seconds - before);
    return wanted;
}

JobEnd work(SceneSteps& steps, RenderJob& job) {
    const Console& console = steps.console();
    RunStatistics& statistics = steps.statistics();
    Progress shown = progress(steps.options(), console);
    if (console.interrupts.listening) console.interrupts.listening(true);
    statistics.render = time_now();
    const JobEnd end = job.run(shown, seconds_now);
    statistics.render = time_now() - statistics.render;
    if (console.interrupts.listening) console.interrupts.listening(false);
    statistics.rays = job.rays();
    shown.finish();
    if (console.ends_rendering && end == JobEnd::finished) console.ends_rendering();
    return end;
}

/// `sampled`: whether this run came to its samples. A state of an earlier run stays if it did not.
int say_stopped(SceneSteps& steps, const JobPlan& plan, const RenderJob& job, bool sampled) {
    if (steps.say_diagnostics()) return exit_status::file;
    const Options& options = steps.options();
    const std::string state = state_path(plan);
    const bool goes_on =
        job.can_keep() && (sampled || (options.go_on && std::filesystem::exists(state)));
    if (!options.diagnostics_as_json)
        steps.console().err(goes_on ? message("stopped; +C goes on from `", printable(state), "`\n")
                            : sampled ? std::string("stopped; there is no place for a state\n")
                                      : std::string("stopped before the first sample\n"));
    return exit_status::stopped;
}

/// Says what was made, and how.
void say_made(SceneSteps& steps, const std::string& made) {
    const Options& options = steps.options();
    if (!talks(options)) return;
    say(steps.console(), Stream::statistics,
        message(options.to_file ? printable(made) : "no file", ": ", summary(steps.statistics()),
                "\n"));
    if (options.draft) say(steps.console(), Stream::statistics, draft_words);
}

int render_shot(SceneSteps& steps, const Shot& shot, std::span<const Meter> meters) {
    const Options& options = steps.options();
    const World& world = *shot.world;
    Diagnostics& diagnostics = steps.diagnostics();
    const std::string& path = steps.output().path;
    Identity identity = identity_of(options, steps.session().files(), steps.output().format);
    FilmFiles files = steps.film_files();
    files.film = film_of_frame(shot.view.film, options);
    note_film(identity, files.film);
    if (aovs_for(options.layers, false).lights) {
        files.lights = light_names(world, steps.sources());
        note_lights(identity, files.lights);
    }
    JobPlan plan{options,
                 identity,
                 path,
                 steps.shard(),
                 steps.console().winds_down,
                 options.to_file ? bytes_to_write(files) : 0,
                 {}};
    const auto recorder =
        light_recorder(shot, steps.sources(), steps.output().format, options, diagnostics);
    if (steps.say_diagnostics()) return exit_status::usage;
    const int threads = options.render.threads;
    if (recorder)
        plan.lamps = {recorder.get(), recorder->most_memory(),
                      [&] { return recorder->state(threads); },
                      [&](std::string_view state) { return recorder->go_on(state); }};
    RenderJob job(plan, shot, steps.console().interrupts, diagnostics);
    if (job.stopped()) return say_stopped(steps, plan, job, false);
    const bool locks = job.can_keep();
    const FileLock lock(locks ? state_path(plan) : std::string());
    if (lock.taken())
        diagnostics.add(error(
            Fault::io, {}, message("another run is making `", printable(path), "` at the moment")));
    else
        job.prepare();
    if (steps.say_diagnostics()) return exit_status::file;
    if (!take_turn(steps)) return exit_status::stopped;
    if (recorder && !keep_meters(*recorder, steps, shot, meters))
        return say_stopped(steps, plan, job, false);
    const JobEnd end = work(steps, job);
    if (end == JobEnd::stopped) return say_stopped(steps, plan, job, true);
    files.format.description = description(identity, job.samples(), files.format);
    const bool whole = !steps.shard();
    const auto& finished = steps.console().finished;
    if (finished && whole && end == JobEnd::finished)
        finished({job.film(), files, world, job.rays(), steps.sources()});
    if (options.to_file && whole && end == JobEnd::finished)
        write_film(job.film(), files, diagnostics);
    std::string idle;
    if (recorder && whole) {
        const LightRecords kept =
            write_kept_lights(*recorder, job.film(), files, options.kept_lights, diagnostics);
        if (options.light_report)
            idle = idle_lamps_report(kept.lamps, idle_lamps(kept, recorder->lit(), threads));
    }
    const bool lost = diagnostics.failed();
    job.leave_state(!whole || options.keep_state || lost);
    if (options.light_report) {
        steps.console().err(light_report(world, job.rays(), steps.sources()));
        if (whole && end == JobEnd::finished && files.aovs().lights)
            steps.console().err(
                idle_lights_report(world, changes_without(job.film(), files), steps.sources()));
        steps.console().err(idle);
    }
    if (steps.say_diagnostics()) return exit_status::file;
    const std::string made = whole ? path : state_path(plan);
    const int status = steps.finish(shot, made);
    if (status == exit_status::done) say_made(steps, made);
    return status;
}

}  // namespace

int render_picture(SceneSteps& steps) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const std::vector<Meter> meters = scene->meters;
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    return render_shot(steps, shot, meters);
}

}  // namespace candelabra
