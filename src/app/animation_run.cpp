// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation_run.h"

#include "app/develop_command.h"
#include "app/frame_commands.h"
#include "app/frame_run.h"
#include "app/movie.h"
#include "app/shell_commands.h"
#include "options/memory_limit.h"
#include "options/output.h"
#include "output/layers.h"
#include "picture/file.h"
#include "picture/flaw.h"
#include "production/checkpoint.h"
#include "tasks/scene_run.h"
#include "text/message.h"
#include "text/printable.h"

#include <filesystem>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

/// Renders the frames of an animation and joins them to a movie.
class AnimationRun {
public:
    AnimationRun(const Options& options, const Animation& animation, const Console& console,
                 Diagnostics& diagnostics)
        : options_(options),
          animation_(animation),
          console_(console),
          interrupts_(console.interrupts),
          diagnostics_(diagnostics) {}

    int execute() {
        Diagnostics checked = diagnostics_.fresh();
        output_ = output_of(options_, checked);
        if (makes_film()) check_film();
        if (diagnostics_.failed()) return end_with_errors();
        const Shard part = part_of_frames();
        if (diagnostics_.failed()) return end_with_errors();
        for (std::size_t i = 0; i < animation_.frames.size(); ++i)
            if (i % static_cast<std::size_t>(part.count) + 1 ==
                static_cast<std::size_t>(part.number))
                mine_.push_back(i);
        const int status = options_.commands.any() ? one_by_one() : side_by_side();
        return status == exit_status::done && makes_film() ? join() : status;
    }

private:
    int end_with_errors() {
        say_errors(console_, options_, diagnostics_);
        return exit_status::usage;
    }

    bool makes_film() const { return !options_.movie.empty() && options_.task == Task::render; }

    /// Finds problems with the movie before the long work begins.
    void check_film() {
        const std::string problem = problem_with_destination(options_.movie);
        if (!problem.empty())
            diagnostics_.add(error(Fault::io, {}, problem));
        else
            can_make_movie(options_.frame_rate, options_.movie, diagnostics_);
        if (!options_.shard.empty())
            diagnostics_.add(
                error(Fault::option, {}, "--movie joins all frames, of which a shard has some")
                    .with_help("--skip-existing --movie FILE when all shards are done"));
        else if (!options_.to_file || is_stream(output_.path))
            diagnostics_.add(error(Fault::option, {},
                                   "--movie joins frames in files, so it goes neither with -F nor "
                                   "with standard output"));
    }

    /// Returns the shard of the frames that this run renders. Shards of an animation divide its
    /// frames, unless they share every frame.
    Shard part_of_frames() {
        const bool by_frames = options_.shard_by.value_or(ShardBy::frames) == ShardBy::frames;
        if (options_.shard.empty() || !by_frames) return {};
        return read_shard(options_.shard, console_.environment, diagnostics_).value_or(Shard());
    }

    /// Whether a frame is skipped because an earlier run has made it and all that belongs to it. A
    /// file that is there but not finished is warned of.
    bool is_there(const std::string& path) {
        std::error_code none;
        if (!options_.to_file || options_.task != Task::render) return false;
        const bool begun = fs::exists(path + std::string(state_ending), none);
        const bool skips = options_.animation.skip_existing || (options_.go_on && !begun);
        if (!skips) return false;
        for (const std::string& each : files_of_frame(path)) {
            if (!fs::exists(each, none)) return false;
            const std::string why =
                flaw_of_picture(each, options_.render.width, options_.render.height);
            if (why.empty()) continue;
            warn_of_flaw(each, why);
            return false;
        }
        return true;
    }

    /// Says it once for a file, though a frame may be begun twice.
    void warn_of_flaw(const std::string& path, const std::string& why) {
        if (!flawed_.insert(path).second) return;
        Diagnostics problems = diagnostics_.fresh();
        problems.add(warning(
            Fault::option, {},
            message("`", printable(path), "` is no finished frame, and is made again: ", why)));
        say_errors(console_, options_, problems);
    }

    /// Returns the paths of all pictures of a frame.
    std::vector<std::string> files_of_frame(const std::string& frame) const {
        FilmFiles files{frame, output_.format, options_.alpha, options_.layers};
        files.denoise = options_.denoise;
        std::vector<std::string> paths = {frame};
        for (const std::string& path : {denoised_path(files), layers_path(files)})
            if (!path.empty() && path != frame) paths.push_back(path);
        return paths;
    }

    /// Returns the denoised picture beside a frame if one was requested, else the frame.
    std::string quietest(const std::string& frame) const {
        FilmFiles files{frame, output_.format};
        files.denoise = options_.denoise;
        const std::string quiet = denoised_path(files);
        return quiet.empty() ? frame : quiet;
    }

    Options frame_options(std::size_t i) const {
        const AnimationFrame& frame = animation_.frames[i];
        Options options = options_;
        options.type = output_.format.type;
        options.output = is_stream(output_.path)
                             ? output_.path
                             : numbered(output_.path, frame.number, animation_.digits);
        set_frame(options.facts, options_.animation, animation_, frame);
        for (std::string* each : files_beside(options))
            if (!each->empty() && *each != "-")
                *each = numbered(*each, frame.number, animation_.digits);
        const double count = static_cast<double>(animation_.frames.size());
        options.share = {static_cast<double>(i) / count, static_cast<double>(i + 1) / count};
        if (!options.shard_by) options.shard_by = ShardBy::frames;
        return options;
    }

    void announce(std::size_t i, bool there) const {
        if (!talks(options_)) return;
        const AnimationFrame& frame = animation_.frames[i];
        const std::size_t count = animation_.frames.size();
        if (progress_style(options_.progress) == ProgressStyle::povray)
            return say(console_, Stream::render,
                       message("Rendering frame ", i + 1, " of ", count, " (#", frame.number,
                               there ? ") is there\n" : ")\n"));
        say(console_, Stream::render,
            message("frame ", frame.number, " (", i + 1, " of ", count, "), clock ", frame.clock,
                    there ? ": is there\n" : "\n"));
    }

    /// Returns the diagnostics for a frame. Problems with the command line are reported only once.
    Diagnostics problems_of_frame() {
        return std::exchange(said_, true) ? diagnostics_.fresh() : diagnostics_;
    }

    /// Completes each frame before the next, since shell commands may make files that a frame
    /// needs.
    int one_by_one() {
        for (const std::size_t i : mine_) {
            const Options options = frame_options(i);
            files_.push_back(options.output);
            const bool there = is_there(options.output);
            announce(i, there);
            if (there) continue;
            Diagnostics problems = problems_of_frame();
            const Outcome outcome = with_frame_commands(
                options, [&] { return run_scene(options, console_, problems); });
            if (outcome.status != exit_status::done) return outcome.status;
            if (outcome.ends) break;
        }
        return exit_status::done;
    }

    /// Overlaps frames: each is prepared while the previous one is rendered, begins when that one
    /// leaves cores free, and is written while the next one is rendered.
    int side_by_side() {
        std::unique_ptr<FrameRun> before, next;
        for (std::size_t at = 0; at < mine_.size(); ++at) {
            // A frame that was not begun ahead may read the previous picture, which is still being
            // written.
            if (!next && before && before->finish() != exit_status::done) return before->finish();
            std::unique_ptr<FrameRun> now = next ? std::move(next) : begin(at, {});
            if (!before) speak(at, now.get());
            const bool renders = now && begin_turn(at, before.get(), now);
            if (before && before->finish() != exit_status::done) return before->finish();
            if (before) speak(at, now.get());
            if (!now) continue;
            if (renders && at + 1 < mine_.size() && may_look_ahead())
                next = begin(at + 1, now->options().output);
            if (!now->wait_wound_down() && now->finish() != exit_status::done) return now->finish();
            before = std::move(now);
        }
        return before ? before->finish() : exit_status::done;
    }

    void speak(std::size_t at, FrameRun* frame) const {
        announce(mine_[at], !frame);
        if (frame) frame->speak();
    }

    /// Lets a frame render while the previous one winds down and ends. Returns false if the frame
    /// has ended without rendering.
    bool begin_turn(std::size_t at, FrameRun* before, std::unique_ptr<FrameRun>& now) {
        if (now->render()) return true;
        if (!now->options().prepared_ahead || now->finish() == exit_status::done) return false;
        // The frame may have needed the previous picture; otherwise it fails again in the same way.
        if (before && before->finish() != exit_status::done) return false;
        looks_ahead_ = false;
        now = begin(at, {});
        return now && now->render();
    }

    bool may_look_ahead() const {
        return looks_ahead_ && options_.task == Task::render && options_.render.threads != 1 &&
               may_double(memory_in_use(), options_.memory_bytes);
    }

    /// `unfinished`: a picture that is still being made. Returns null if the frame is skipped.
    std::unique_ptr<FrameRun> begin(std::size_t at, const std::string& unfinished) {
        Options options = frame_options(mine_[at]);
        if (files_.size() <= at) files_.push_back(options.output);
        if (is_there(options.output)) return nullptr;
        options.prepared_ahead = !unfinished.empty();
        options.at_once = max_at_once;
        Console console = console_;
        console.interrupts = interrupts_.for_one();
        return std::make_unique<FrameRun>(std::move(options), console, problems_of_frame(),
                                          unfinished);
    }

    int join() {
        Diagnostics problems = diagnostics_.fresh();
        // Frames in OpenEXR files are first developed to temporary pictures.
        const bool light = output_.format.type == PictureType::exr;
        std::vector<std::string> shown;
        for (const std::string& each : files_) {
            shown.push_back(light ? hidden_part(options_.movie, shown.size(), ".png")
                                  : quietest(each));
            if (light)
                develop_file(each, options_.denoise ? denoised_layer : "", shown.back(), problems);
        }
        const bool made =
            !problems.failed() && make_movie(shown, options_.frame_rate, options_.movie, problems);
        std::error_code none;
        if (light)
            for (const std::string& each : shown) fs::remove(each, none);
        if (made) return exit_status::done;
        say_errors(console_, options_, problems);
        return exit_status::file;
    }

    const Options& options_;
    const Animation& animation_;
    const Console& console_;
    SharedInterrupts interrupts_;
    Diagnostics& diagnostics_;
    Output output_;
    /// One frame is being completed and written, one rendered and one prepared.
    static constexpr unsigned max_at_once = 3;

    std::vector<std::size_t> mine_;  ///< frames of this run
    std::vector<std::string> files_;
    std::set<std::string> flawed_;  ///< files that were warned of
    bool said_ = false;             ///< problems with the command line have been reported
    bool looks_ahead_ = true;
};

}  // namespace

void set_frame(RunFacts& facts, const AnimationSettings& settings, const Animation& animation,
               const AnimationFrame& frame) {
    facts.clock = frame.clock;
    facts.clock_given = true;
    facts.frame_number = frame.number;
    facts.initial_frame = animation.initial_frame;
    facts.final_frame = animation.final_frame;
    facts.initial_clock = settings.initial_clock;
    facts.final_clock = settings.final_clock;
    facts.clock_delta = animation.clock_delta;
}

int run_animation(const Options& options, const Animation& animation, const Console& console,
                  Diagnostics& diagnostics) {
    return AnimationRun(options, animation, console, diagnostics).execute();
}

}  // namespace candelabra
