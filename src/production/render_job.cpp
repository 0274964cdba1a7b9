// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/render_job.h"

#include "base/unless_ended.h"
#include "options/memory_limit.h"
#include "options/region.h"
#include "output/layers.h"
#include "picture/file.h"
#include "text/message.h"
#include "text/printable.h"
#include "transport/tracing.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <new>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr double never = std::numeric_limits<double>::infinity();

/// Number of samples per pixel if only --time limits them.
constexpr int max_samples_in_time = 1'000'000;

std::uint32_t max_samples(const RenderState& state) {
    std::uint32_t most = 0;
    state.film.each([&](std::size_t i) { most = std::max(most, state.film.pixels()[i].samples); });
    return most;
}

/// Returns the plan; none if it is asked to stop. If its trials take longer than the picture may,
/// the plan does without them. `save`: whether it is asked to save meanwhile.
std::optional<RenderPlan> planned(const Shot& shot, const Options& options,
                                  const Interrupts& interrupts, std::atomic<bool>& save) {
    using Clock = std::chrono::steady_clock;
    constexpr double interval = 0.1;  // between two questions, in seconds
    const auto begun = Clock::now();
    const auto spent = [begun] {
        return std::chrono::duration<double>(Clock::now() - begun).count();
    };
    std::atomic<double> next = interval;
    std::atomic<bool> stopped = false;
    const std::function<bool()> stops = [&] {
        double due = next;
        const double now = spent();
        if (now < due || !interrupts.take || !next.compare_exchange_strong(due, now + interval))
            return stopped.load();
        const Interrupt asked = interrupts.take();
        if (asked == Interrupt::save) save = true;
        if (asked == Interrupt::stop) stopped = true;
        return stopped.load();
    };
    const RenderSettings settings = timed(options);
    if (!options.time) return plan_of(shot, settings, stops);
    const std::function<bool()> ends = [&] { return stops() || spent() > *options.time; };
    const auto sent =
        unless_ended(stops, [&] { return SentLight::of(shot, settings.seed, settings.threads); });
    if (!sent) return std::nullopt;
    if (auto plan = plan_of(shot, settings, *sent, ends)) return plan;
    if (stopped) return std::nullopt;
    return plan_without_trials(shot, settings, *sent);
}

/// Returns a number of megabytes, rounded up.
std::uint64_t megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t one = std::uint64_t{1} << 20;
    return (bytes + one - 1) / one;
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
      rendering_(planned(shot, plan_.options, interrupts, asked_to_save_)),
      interrupts_(interrupts),
      diagnostics_(diagnostics) {}

bool RenderJob::can_keep() const {
    std::error_code none;
    const fs::file_status status = fs::status(plan_.picture, none);
    return state_fits_ && plan_.options.to_file && plan_.options.leaves_state &&
           plan_.picture != "-" && (!fs::exists(status) || fs::is_regular_file(status));
}

void RenderJob::begin() {
    RenderState& state = checkpoint_.state;
    const RenderSettings& settings = rendering_->settings;
    const std::size_t sums = extras_.count(*rendering_->shot.world);
    state = begin_picture(settings, sums, std::move(pages_));
    const Region region = region_of(plan_.options);
    state.shard.region = region;
    // Antialiasing compares the rows of the region with those beside it.
    state.film.keep_to_rows(region.top - 1, region.bottom + 1);
    checkpoint_.identity = plan_.identity;
    checkpoint_.all_samples = rendering_->samples;
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
    rendering_->samples = checkpoint_.samples;
    rendering_->settings.samples = static_cast<int>(checkpoint_.samples);
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
        old.state.film.width() != rendering_->settings.width ||
        old.state.film.height() != rendering_->settings.height ||
        old.state.film.aovs() != checkpoint_.state.film.aovs())
        return refuse("it is of another part of the picture");
    if (rendering_->is_even() && max_samples(old.state) > checkpoint_.samples)
        return refuse(message("it has up to ", max_samples(old.state),
                              " samples in a pixel already, and ", checkpoint_.samples,
                              " are to be made"));
    return true;
}

/// Whether the light of lamps can be kept if that is wanted; reports why not. `old`: the state to
/// go on from; null: none.
bool RenderJob::can_keep_lamps(const Checkpoint* old) {
    if (!plan_.lamps.sink) return true;
    const auto refuse = [&](const char* text, const char* help) {
        diagnostics_.add(error(Fault::option, {}, text).with_help(help));
        return false;
    };
    if (decided_by(rendering_->settings, rendering_->rule) == DecidedBy::tile)
        return refuse("--keep-lights needs samples, and this picture is made of compared rays",
                      "--samples 16");
    if (rendering_->shot.moments() > 1)
        return refuse("--keep-lights is for lamps that stand still, and the shutter is open",
                      "a camera without a shutter, or --layers lights");
    if (old && max_samples(old->state) > 0 && !plan_.lamps.go_on(old->lamps))
        return refuse(old->lamps.empty()
                          ? "the state has samples whose light was not kept by --keep-lights"
                          : "the state keeps light in another way than this run would",
                      "the same --keep-lights-size goes on; without +C it is begun anew, and "
                      "without --keep-lights it goes on");
    return true;
}

/// Whether the memory of the run holds the picture's sums and what is made of them at the end;
/// reports what they need if not. Sums that are too large go to a file.
bool RenderJob::has_room() {
    const RenderSettings& settings = plan_.options.render;
    const auto limit = plan_.options.memory_bytes;
    if (!limit) return true;
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(settings.width) * static_cast<std::uint64_t>(settings.height);
    const std::size_t aovs = extras_.count(*rendering_->shot.world);
    // The sums of other rows are never touched, except for those beside the region.
    const Region region = region_of(plan_.options);
    const int rows = std::min(settings.height, region.bottom - region.top + 2);
    const std::uint64_t sums = Film::bytes_of(settings.width, rows, aovs);
    const std::uint64_t beside = pixels * plan_.writing + plan_.lamps.memory + memory_in_use();
    if (sums + beside <= *limit) {
        if (rows < settings.height)
            pages_ = ZeroedPages::sparse(Film::bytes_of(settings.width, settings.height, aovs));
        return has_room_for_state(sums + beside, *limit);
    }
    const std::uint64_t held = Film::bytes_of(static_cast<int>(Film::held_pixels), 1, aovs);
    const bool filed = plan_.options.to_file && !is_stream(plan_.picture) && held < sums;
    const bool fits = filed && held + beside <= *limit;
    if (fits) pages_ = pages_in_file(Film::bytes_of(settings.width, settings.height, aovs));
    if (pages_) return has_room_for_state(held + beside, *limit);
    const std::uint64_t need = megabytes((filed && !fits ? held : sums) + beside);
    const char* const less = plan_.lamps.sink ? "; with a smaller --keep-lights-size it needs less"
                             : aovs > 0       ? "; without layers and --denoise it needs less"
                                              : "";
    diagnostics_.add(
        error(Fault::option, {},
              message("a picture of ", settings.width, "x", settings.height, " needs ", need,
                      " MB of memory for this scene, and the limit is ", megabytes(*limit), " MB"))
            .with_help(message("--limit-memory ", need, less)));
    return false;
}

/// Notes whether a state can be made beside `held` bytes. Returns false after an error, if the run
/// is to leave one.
bool RenderJob::has_room_for_state(std::uint64_t held, std::uint64_t limit) {
    if (!can_keep()) return true;
    const RenderSettings& settings = plan_.options.render;
    const std::uint64_t need =
        held +
        bytes_to_encode(settings.width, settings.height, extras_.count(*rendering_->shot.world)) +
        plan_.lamps.memory;
    if (need <= limit) return true;
    state_fits_ = false;
    const bool wanted = plan_.shard || plan_.options.keep_state;
    std::string text = message("a state of this picture needs ", megabytes(need),
                               " MB of memory, and the limit is ", megabytes(limit), " MB");
    diagnostics_.add(
        (wanted ? error(Fault::option, {}, text)
                : warning(Fault::option, {}, text + ": it cannot be stopped and gone on with"))
            .with_help(message("--limit-memory ", megabytes(need))));
    return !wanted;
}

/// Returns pages in the folder of the picture, or in that of the scene's own files, which the
/// program may read, too; nothing if neither has room.
std::optional<ZeroedPages> RenderJob::pages_in_file(std::size_t bytes) const {
    auto pages = ZeroedPages::in_file(fs::path(plan_.picture).parent_path().string(), bytes);
    if (pages) return pages;
    return ZeroedPages::in_file(own_folder({plan_.picture, {}}, plan_.options), bytes);
}

bool RenderJob::prepare() {
    const bool of_samples = plan_.shard && plan_.options.shard_by != ShardBy::tiles;
    if (of_samples && !rendering_->is_even()) {
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
    if (!can_keep_lamps(nullptr)) return false;
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
    if (!old || !fits(*old) || !can_keep_lamps(&*old)) return false;
    checkpoint_.state = std::move(old->state);
    // The state may ask for more samples than any run would.
    const std::uint32_t most =
        max_wanted(rendering_->settings, rendering_->samples, rendering_->rule);
    for (PixelSum& pixel : checkpoint_.state.film.pixels())
        pixel.planned = std::min(pixel.planned, most);
    return true;
}

bool RenderJob::save(Diagnostics& diagnostics) {
    try {
        if (plan_.lamps.sink) checkpoint_.lamps = plan_.lamps.state();
        const auto bytes = encode(checkpoint_, diagnostics);
        checkpoint_.lamps.clear();
        return bytes && write_file(state_path(plan_), *bytes, diagnostics);
    } catch (const std::bad_alloc&) {  // the scene has taken more memory since prepare()
        diagnostics.add(error(Fault::io, {}, "there is not enough memory for a state")
                            .with_help("--limit-memory sets how much there may be"));
        return false;
    }
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
    hooks.lamps = plan_.lamps.sink;
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
        else if (now == Interrupt::save || asked_to_save_.exchange(false) || time >= save_at_ ||
                 time >= deadline_)
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
    const bool finished = advance(*rendering_, checkpoint_.state, rays_, hooks);
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
