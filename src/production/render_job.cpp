// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/render_job.h"

#include "options/memory_limit.h"
#include "options/region.h"
#include "output/layers.h"
#include "picture/file.h"
#include "text/message.h"
#include "text/printable.h"
#include "transport/tracing.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr double never = std::numeric_limits<double>::infinity();

/// Number of samples per pixel if only --time limits them.
constexpr int max_samples_in_time = 1'000'000;

std::uint32_t max_samples(const RenderState& state) {
    std::uint32_t most = 0;
    for (const PixelSum& pixel : state.film.pixels()) most = std::max(most, pixel.samples);
    return most;
}

/// Returns the plan. If its trials take longer than the picture may, the plan does without them.
RenderPlan planned(const Shot& shot, const Options& options) {
    const RenderSettings settings = timed(options);
    if (!options.time) return plan_of(shot, settings);
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    const std::function<bool()> late = [&] {
        return std::chrono::duration<double>(Clock::now() - begun).count() > *options.time;
    };
    const SentLight sent = SentLight::of(shot, settings.seed, settings.threads);
    if (const auto plan = plan_of(shot, settings, sent, late)) return *plan;
    RenderSettings simple = settings;
    simple.shadow_rays = 1;
    RenderPlan plan = plan_of(shot, simple);
    plan.settings = settings;
    return plan;
}

}  // namespace

RenderSettings timed(const Options& options) {
    RenderSettings settings = options.render;
    if (options.time && settings.samples == 0 && settings.noise == 0)
        settings.samples = max_samples_in_time;
    return settings;
}

std::string state_path(const std::string& picture, const std::optional<Shard>& shard) {
    const std::string part = shard ? message('.', shard_name(*shard)) : std::string();
    return message(picture, part, state_ending);
}

std::string state_path(const JobPlan& plan) { return state_path(plan.picture, plan.shard); }

RenderJob::RenderJob(JobPlan plan, const Shot& shot, const Interrupts& interrupts,
                     Diagnostics& diagnostics)
    : plan_(std::move(plan)),
      extras_(
          aovs_for(plan_.options.layers, plan_.options.alpha,
                   {shot.view.film.smooths_edges(), plan_.options.denoise || plan_.options.draft})),
      rendering_(planned(shot, plan_.options)),
      interrupts_(interrupts),
      diagnostics_(diagnostics) {}

bool RenderJob::can_keep() const {
    std::error_code none;
    const fs::file_status status = fs::status(plan_.picture, none);
    return plan_.options.to_file && plan_.options.leaves_state && plan_.picture != "-" &&
           (!fs::exists(status) || fs::is_regular_file(status));
}

void RenderJob::begin() {
    RenderState& state = checkpoint_.state;
    state = begin_picture(rendering_.settings, extras_.count(*rendering_.shot.world));
    state.shard.region = region_of(plan_.options);
    checkpoint_.identity = plan_.identity;
    checkpoint_.all_samples = rendering_.samples;
    checkpoint_.samples = checkpoint_.all_samples;
    if (!plan_.shard) return;
    const Shard& shard = *plan_.shard;
    if (plan_.options.shard_by == ShardBy::tiles) {
        state.shard.first_tile = shard.number - 1;
        state.shard.tile_step = shard.count;
        return;
    }
    state.shard.first_sample = first_of(shard, checkpoint_.all_samples);
    const Shard next{shard.number + 1, shard.count};
    checkpoint_.samples =
        first_of(next, checkpoint_.all_samples) - checkpoint_.state.shard.first_sample;
    rendering_.samples = checkpoint_.samples;
    rendering_.settings.samples = static_cast<int>(checkpoint_.samples);
}

bool RenderJob::fits(const Checkpoint& old) {
    const std::string path = printable(state_path(plan_));
    const auto refuse = [&](const std::string& why) {
        diagnostics_.add(error(Fault::option, {}, message("cannot go on from `", path, "`: ", why))
                             .with_help("+C goes on with the options that the run was begun with; "
                                        "without it the picture is begun anew"));
        return false;
    };
    const std::string changed = difference(old.identity, plan_.identity);
    if (!changed.empty()) return refuse(changed);
    if (!(old.state.shard == checkpoint_.state.shard) ||
        old.state.film.width() != rendering_.settings.width ||
        old.state.film.height() != rendering_.settings.height ||
        old.state.film.aovs() != checkpoint_.state.film.aovs())
        return refuse("it is of another part of the picture");
    if (rendering_.is_even() && max_samples(old.state) > checkpoint_.samples)
        return refuse(message("it has up to ", max_samples(old.state),
                              " samples in a pixel already, and ", checkpoint_.samples,
                              " are to be made"));
    return true;
}

/// Whether the sums of the picture fit into the memory of the run; reports what they need if not.
bool RenderJob::has_room() {
    const RenderSettings& settings = plan_.options.render;
    constexpr double per_megabyte = 1 << 20;
    // An image of the film, and its encoded form, stand beside it at the end.
    constexpr std::uint64_t beside = sizeof(Vec3) + 8;
    const auto pixels = static_cast<std::uint64_t>(settings.width) *
                        static_cast<std::uint64_t>(settings.height);
    const std::uint64_t sums = extras_.count(*rendering_.shot.world);
    const std::uint64_t need =
        pixels * (sizeof(PixelSum) + sums * sizeof(ExactSum) + beside) + memory_in_use();
    const auto limit = plan_.options.memory_bytes;
    if (!limit || need <= *limit) return true;
    const auto megabytes = [&](std::uint64_t bytes) {
        return static_cast<std::uint64_t>(std::ceil(static_cast<double>(bytes) / per_megabyte));
    };
    diagnostics_.add(
        error(Fault::option, {},
              message("a picture of ", settings.width, "x", settings.height, " needs ",
                      megabytes(need), " MB of memory for this scene, and the limit is ",
                      megabytes(*limit), " MB"))
            .with_help(message("--limit-memory ", megabytes(need),
                               sums > 0 ? "; without layers and --denoise it needs less" : "")));
    return false;
}

bool RenderJob::prepare() {
    const bool of_samples = plan_.shard && plan_.options.shard_by != ShardBy::tiles;
    if (of_samples && !rendering_.is_even()) {
        diagnostics_.add(error(Fault::option, {},
                               "shards of samples must know how many samples there will be, which "
                               "the camera's blur_samples leave open")
                             .with_help("--samples N, or --shard-by tiles"));
        return false;
    }
    if (!has_room()) return false;
    begin();
    if (checkpoint_.samples == 0)
        diagnostics_.add(error(Fault::option, {},
                               message("there are more shards than the ", checkpoint_.all_samples,
                                       " samples of each pixel")));
    if (checkpoint_.samples == 0) return false;
    if (!can_keep()) return true;
    const std::string path = state_path(plan_);
    std::error_code none;
    if (!fs::exists(path, none)) return true;
    if (!plan_.options.go_on) {
        diagnostics_.add(note(Fault::option, {},
                              message("`", printable(path),
                                      "` is left of an earlier run; +C would "
                                      "have gone on from it")));
        return true;
    }
    auto old = read_checkpoint(path, diagnostics_);
    if (!old || !fits(*old)) return false;
    checkpoint_.state = std::move(old->state);
    // The state may ask for more samples than any run would.
    const std::uint32_t most = max_wanted(rendering_.settings, rendering_.samples, rendering_.rule);
    for (PixelSum& pixel : checkpoint_.state.film.pixels())
        pixel.target = std::min(pixel.target, most);
    return true;
}

bool RenderJob::save(Diagnostics& diagnostics) {
    const auto bytes = encode(checkpoint_, diagnostics);
    return bytes && write_file(state_path(plan_), *bytes, diagnostics);
}

/// Saves the state. Failure is only a warning, since a later attempt may succeed.
void RenderJob::save_and_go_on() {
    Diagnostics problems;
    if (save(problems)) return;
    diagnostics_.add(warning(Fault::option, {},
                             message(problems.all().front().message, "; the rendering goes on")));
}

void RenderJob::leave_state(bool keep) {
    if (!can_keep()) return;
    checkpoint_.finished = true;
    std::error_code none;
    if (keep)
        save(diagnostics_);
    else
        fs::remove(state_path(plan_), none);
}

/// Renders until the picture is finished (none), or returns the reason for stopping.
Interrupt RenderJob::work(Progress& progress, const std::function<double()>& clock) {
    std::atomic<Interrupt> asked = Interrupt::none;
    RenderHooks hooks;
    hooks.counts_lights = plan_.options.light_report;
    hooks.aovs = extras_;
    if (!plan_.options.time) hooks.winds_down = plan_.winds_down;
    hooks.progress = [&](double done) {
        const double spent = plan_.options.time ? (clock() - begun_) / *plan_.options.time : 0;
        progress.update(std::max(done, spent));
    };
    hooks.cancelled = [&] {
        if (asked == Interrupt::stop) return true;
        const Interrupt now = interrupts_.take ? interrupts_.take() : Interrupt::none;
        const double time = clock();
        Interrupt none = Interrupt::none;
        // A stop that another thread has received takes precedence over saving.
        if (now == Interrupt::stop)
            asked = now;
        else if (now == Interrupt::save || time >= save_at_ || time >= deadline_)
            asked.compare_exchange_strong(none, Interrupt::save);
        return asked != Interrupt::none;
    };
    // A state can wait until a sample is finished; the end cannot.
    hooks.ended = [&] {
        return hooks.cancelled() && (asked == Interrupt::stop || clock() >= deadline_);
    };
    hooks.cut = [&](int x, int y) {
        const std::lock_guard lock(cut_mutex_);
        const std::pair place(y, x);
        if (cut_samples_++ == 0 || place < first_cut_) first_cut_ = place;
    };
    const bool finished = advance(rendering_, checkpoint_.state, rays_, hooks);
    return finished ? Interrupt::none : asked.load();
}

void RenderJob::warn_of_cut() {
    if (cut_samples_ == 0) return;
    diagnostics_.add(
        warning(Fault::recursion_limit, {},
                message("reflections and refractions of ", cut_samples_,
                        cut_samples_ == 1 ? " camera ray" : " camera rays",
                        " multiply without end: of each ", Tracing().max_rays,
                        " were followed, and the rest counts as black; the first is in the pixel ",
                        first_cut_.second, ", ", first_cut_.first))
            .with_help("a smaller max_trace_level or a larger adc_bailout in global_settings, or "
                       "`integrator { path_traced }`, which follows one of them at a time"));
}

JobEnd RenderJob::run(Progress& progress, const std::function<double()>& clock) {
    const double interval = plan_.options.checkpoint_interval;
    const bool saves = can_keep();
    const auto plan_save = [&](double now, double cost) {
        // Keeps the share of time spent on states low: an interval is at least 20 times the cost of
        // a state.
        constexpr double max_share = 20;
        save_at_ = saves && interval > 0 ? now + std::max(interval, max_share * cost) : never;
    };
    begun_ = clock();
    deadline_ = plan_.options.time ? begun_ + *plan_.options.time : never;
    plan_save(begun_, 0);
    for (;;) {
        const Interrupt asked = work(progress, clock);
        const double now = clock();
        if (asked == Interrupt::none || (asked == Interrupt::save && now >= deadline_)) {
            warn_of_cut();
            return JobEnd::finished;
        }
        if (asked == Interrupt::stop) {
            if (saves) save(diagnostics_);
            return JobEnd::stopped;
        }
        if (saves) save_and_go_on();
        plan_save(clock(), clock() - now);
    }
}

}  // namespace candelabra
