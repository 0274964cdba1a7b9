// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation_run.h"

#include "app/checkpoint.h"
#include "app/frame_commands.h"
#include "app/movie.h"
#include "app/output.h"
#include "app/scene_run.h"
#include "picture/file.h"
#include "text/message.h"

#include <filesystem>
#include <utility>

namespace {

namespace fs = std::filesystem;

/// Renders the frames of an animation, and joins them to a film.
class AnimationRun {
public:
    AnimationRun(const Options& options, const Animation& animation, const Console& console,
                 Diagnostics& diagnostics)
        : options_(options), animation_(animation), console_(console), diagnostics_(diagnostics) {}

    int execute() {
        Diagnostics checked = diagnostics_.fresh();
        output_ = output_of(options_, checked);
        if (makes_film()) check_film();
        if (diagnostics_.failed()) return end_with_errors();
        const Shard part = part_of_frames();
        if (diagnostics_.failed()) return end_with_errors();
        for (std::size_t i = 0; i < animation_.frames.size(); ++i) {
            const std::size_t turn = i % static_cast<std::size_t>(part.count) + 1;
            if (turn != static_cast<std::size_t>(part.number)) continue;
            const Outcome outcome = render_frame(i);
            if (outcome.status != exit_status::done) return outcome.status;
            if (outcome.ends) break;
        }
        return makes_film() ? join() : exit_status::done;
    }

private:
    int end_with_errors() {
        say_errors(console_, options_, diagnostics_);
        return exit_status::usage;
    }

    bool makes_film() const { return !options_.movie.empty() && options_.task == Task::render; }

    /// Long work should not end at a film that cannot be made.
    void check_film() {
        find_ffmpeg(diagnostics_);
        const std::string problem = problem_with_destination(options_.movie);
        if (!problem.empty()) diagnostics_.add(error(Fault::io, {}, problem));
        if (!options_.shard.empty())
            diagnostics_.add(
                error(Fault::option, {}, "--movie joins all frames, of which a shard has some")
                    .with_help("--skip-existing --movie FILE when all shards are done"));
        else if (!options_.to_file || output_.path == "-")
            diagnostics_.add(error(Fault::option, {},
                                   "--movie joins frames in files, so it goes neither with -F nor "
                                   "with standard output"));
    }

    /// Shards of an animation have every so many frames each, unless they share every frame.
    Shard part_of_frames() {
        const bool by_frames = options_.shard_by.value_or(ShardBy::frames) == ShardBy::frames;
        if (options_.shard.empty() || !by_frames) return {};
        return read_shard(options_.shard, console_.environment, diagnostics_).value_or(Shard());
    }

    /// Whether a frame is left out, being there from an earlier run and needing nothing more.
    bool is_there(const std::string& path) const {
        std::error_code none;
        if (!options_.to_file || options_.task != Task::render) return false;
        const bool begun = fs::exists(path + std::string(state_ending), none);
        const bool skips = options_.animation.skip_existing || (options_.go_on && !begun);
        return skips && fs::exists(path, none);
    }

    Outcome render_frame(std::size_t i) {
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
        for (std::string* each : {&options.stats_file, &options.depfile})
            if (!each->empty() && *each != "-")
                *each = numbered(*each, frame.number, animation_.digits);
        const double count = static_cast<double>(animation_.frames.size());
        options.share = {static_cast<double>(i) / count, static_cast<double>(i + 1) / count};
        files_.push_back(options.output);
        if (!options.shard_by) options.shard_by = ShardBy::frames;
        const bool there = is_there(options.output);
        if (talks(options_))
            say(console_, Stream::render,
                message("frame ", frame.number, " (", i + 1, " of ", animation_.frames.size(),
                        "), clock ", frame.clock, there ? ": is there\n" : "\n"));
        if (there) return {};
        // What is wrong with the command line is said once.
        Diagnostics later = diagnostics_.fresh();
        return with_frame_commands(options, [&] {
            return run_scene(options, console_, std::exchange(said_, true) ? later : diagnostics_);
        });
    }

    int join() {
        Diagnostics problems = diagnostics_.fresh();
        if (make_movie(files_, options_.frame_rate, options_.movie, problems))
            return exit_status::done;
        say_errors(console_, options_, problems);
        return exit_status::file;
    }

    const Options& options_;
    const Animation& animation_;
    const Console& console_;
    Diagnostics& diagnostics_;
    Output output_;
    std::vector<std::string> files_;
    bool said_ = false;  ///< what is wrong with the command line
};

}  // namespace

int run_animation(const Options& options, const Animation& animation, const Console& console,
                  Diagnostics& diagnostics) {
    return AnimationRun(options, animation, console, diagnostics).execute();
}
