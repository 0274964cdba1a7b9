// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_stage.h"

#include "app/film_images.h"
#include "app/inspect.h"
#include "app/layers.h"
#include "app/light_report.h"
#include "app/render_job.h"
#include "app/stats.h"
#include "film/film.h"
#include "options/region.h"
#include "render/render.h"
#include "text/message.h"
#include "transport/primary_hit.h"
#include "world/shot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <utility>

namespace candelabra {

namespace {

/// Time in seconds after which the first coarse picture is shown rather than waiting for the
/// second.
constexpr double soon = 0.1;
/// Minimum width and height of a coarse picture.
constexpr int min_edge = 8;
/// Maximum memory for the sums of lights, in bytes.
constexpr double light_bytes = 512e6;

bool has_room_for_lights(const Staged& staged) {
    const RenderSettings& settings = staged.options.render;
    return static_cast<double>(settings.width) * settings.height * 3 * sizeof(ExactSum) *
               static_cast<double>(staged.lights.size()) <=
           light_bytes;
}

/// Returns the outputs to gather, as for a run with layers.
FilmFiles gathered(const Staged& staged, bool denoised) {
    FilmFiles files{{}, staged.format};
    if (!staged.lights.empty() && has_room_for_lights(staged))
        files.layers = {PictureLayer::lights};
    files.lights = staged.lights;
    files.film = staged.film;
    files.denoise = denoised;
    files.threads = staged.options.render.threads;
    return files;
}

double distance_ahead(const World& world, const RenderSettings& settings) {
    const PicturePoint middle{settings.width / 2, settings.height / 2, settings.width,
                              settings.height};
    const WorldView& view = world.stated_view;
    const PrimaryHit seen = primary_hit(world, middle_ray(world, view, middle));
    if (seen.met && seen.distance > 0) return seen.distance;
    return std::max(1.0, length(view.camera.location));
}

Vec3 mean_of(const Image& image) {
    Vec3 sum(0);
    for (const Vec3& pixel : image.pixels) sum += pixel;
    return image.pixels.empty() ? sum : sum / static_cast<double>(image.pixels.size());
}

/// A shot, and what is made before its first sample.
struct Prepared {
    Prepared(Shot made, const RenderSettings& settings)
        : shot(std::move(made)), sent(SentLight::of(shot, settings.seed, settings.threads)) {}
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;

    const Shot shot;
    const SentLight sent;
    std::optional<RenderPlan> plan = {};  ///< none: not yet made
};

class StageRun {
public:
    StageRun(const Staged& staged, PreviewDesk& desk, const Leaving& leaving)
        : staged_(staged),
          desk_(desk),
          leaving_(leaving),
          settings_(timed(staged.options)),
          base_{staged.world->stated_view.camera, distance_ahead(*staged.world, settings_)} {
        for (std::size_t k = 0; k < staged.lights.size(); ++k)
            lamps_.push_back(
                {staged.lights[k],
                 statement_text(staged.world->provenance.light_statements[k], staged.sources)});
    }

    /// Renders until the scene is left. While the page keeps changing it, each scene is still shown
    /// once.
    void run() {
        tell_scene();
        do render();
        while (!leaving_.soon());
        desk_.questions().close();
    }

private:
    void tell_scene() {
        desk_.show_scene(base_, staged_.film, lamps_,
                         !lamps_.empty() && has_room_for_lights(staged_));
    }

    /// Renders the picture of one camera.
    void render() {
        take_wishes();
        rendered_ = wishes_;
        files_ = gathered(staged_, wishes_.look.denoised);
        aovs_ = files_.aovs();
        begun_ = seconds_now();
        frame_ = std::make_shared<const PlateFrame>(PlateFrame{staged_.film, staged_.format,
                                                               staged_.lights, settings_.threads,
                                                               desk_.next_generation()});
        still_.clear();
        rough_ = {};
        quiet_ = {};
        quiet_samples_ = 0;
        if (!make_rough()) return;
        make_fine();
    }

    /// The shot of the camera that is shown.
    Shot shot(bool quick) const {
        ShotSettings settings = ShotSettings::of(settings_);
        settings.quick = quick;
        return {staged_.world, settings, [&](const Projection& stated) {
                    return rendered_.orbit.place({stated, base_.distance}).camera;
                }};
    }

    void prepare() {
        if (prepared_ && prepared_version_ == rendered_.orbit_version) return;
        prepared_.reset();
        prepared_ = std::make_unique<Prepared>(shot(false), settings_);
        prepared_version_ = rendered_.orbit_version;
    }

    /// Light sent from lamps for a coarse picture: that for the camera shown before, if there was
    /// one. The first picture of all does not wait for photons, which may take seconds to shoot.
    SentLight light_for_rough(bool first) {
        if (!prepared_ && !(first && !staged_.world->photon_targets.empty())) prepare();
        return prepared_ ? prepared_->sent : SentLight{};
    }

    void take_wishes() {
        wish_version_ = desk_.wish_version();
        wishes_ = desk_.wishes();
    }

    /// Whether the picture being made is no longer wanted.
    bool outdated() const {
        if (leaving_.soon()) return true;
        if (desk_.wish_version() == wish_version_) return false;
        return is_other(desk_.wishes());
    }

    bool is_other(const Wishes& wishes) const {
        return wishes.orbit_version != rendered_.orbit_version ||
               (wishes.look.denoised && !rendered_.look.denoised);
    }

    /// Makes the coarse pictures. The first is always shown, so that continuous changes stay
    /// visible. Returns false if something else is wanted.
    bool make_rough() {
        const Shot quick = shot(true);
        bool shown = false;
        for (const int step : coarse_steps) {
            RenderSettings settings = settings_;
            settings.width = (settings_.width + step - 1) / step;
            settings.height = (settings_.height + step - 1) / step;
            if (std::min(settings.width, settings.height) < min_edge) continue;
            settings.samples = 1;
            settings.noise = 0;
            settings.antialias = false;
            RenderHooks hooks;
            hooks.aovs = aovs_;
            const double before = seconds_now();
            // Nobody waits long for the first one.
            constexpr double patience = 1;
            hooks.cancelled = hooks.ended = [&] {
                return leaving_.at_once() ||
                       ((shown || seconds_now() - before > patience) && outdated());
            };
            RenderState state = begin_picture(settings, aovs_.count(*staged_.world));
            LightLedger rays;
            const RenderPlan plan{quick, settings,   ShadowRays{1}, light_for_rough(!shown),
                                  1,     NoiseRule{}};
            if (!advance(plan, state, rays, hooks)) return false;
            const double now = seconds_now();
            constexpr double growth = 4;
            const bool waits =
                step == coarse_steps[0] && now - begun_ + growth * (now - before) < soon;
            rough_ = plate_of(state.film, aovs_, staged_.film, true);
            rough_->width = settings_.width;
            rough_->height = settings_.height;
            if (waits) continue;
            shown = true;
            const std::string& view_name = wishes_.look.view;
            if (is_still(view_name)) {
                Plate layer = *rough_;
                layer.view_name = view_name;
                layer.view = view({quick, staged_.sources, settings, state.film, rays}, view_name);
                show(std::move(layer));
            } else if (view_name == "picture") {
                show(*rough_);
            }
            desk_.stand([&](Standing& standing) {
                standing = {};
                standing.line = message(settings.width, " x ", settings.height);
                standing.busy = true;
            });
        }
        return !(shown && outdated());
    }

    void make_fine() {
        prepare();
        RenderState state = begin_picture(settings_, aovs_.count(*staged_.world));
        state.shard.region = region_of(staged_.options);
        rays_ = {};
        done_ = 0;
        begin_clock();
        bool finished = finished_ = false;
        while (!outdated()) {
            if (!finished && !wishes_.paused) finished = stretch(state);
            if (outdated()) return;
            attend(state, finished);
            constexpr int moment = 50;
            if ((finished || wishes_.paused) && desk_.wish_version() == wish_version_ &&
                !desk_.questions().waiting())
                desk_.rest(moment);
        }
    }

    void begin_clock() {
        begun_ = seconds_now();
        constexpr double first_look = 0.3;
        show_at_ = begun_ + first_look;
    }

    /// Whether a wish or a question waits.
    bool called() const {
        return leaving_.soon() || desk_.wish_version() != wish_version_ ||
               desk_.questions().waiting();
    }

    /// Renders until a wish or a question waits. Returns whether the picture is finished.
    bool stretch(RenderState& state) {
        Prepared& ready = *prepared_;
        if (!ready.plan) {
            const auto plan =
                plan_of(ready.shot, settings_, ready.sent, [this] { return called(); });
            if (!plan) return false;
            ready.plan.emplace(*plan);
            begin_clock();
        }
        RenderHooks hooks;
        hooks.counts_lights = true;
        hooks.aovs = aovs_;
        if (wishes_.focus)
            hooks.first =
                Vec2(wishes_.focus->x * settings_.width, wishes_.focus->y * settings_.height);
        hooks.progress = [this](double done) { done_ = std::max<double>(done_, done); };
        hooks.cancelled = [this] {
            return called() || seconds_now() >= std::min(show_at_, deadline());
        };
        hooks.ended = [this] { return called() || seconds_now() >= deadline(); };
        return advance(*ready.plan, state, rays_, hooks) || seconds_now() >= deadline();
    }

    double deadline() const {
        return staged_.options.time ? begun_ + *staged_.options.time
                                    : std::numeric_limits<double>::infinity();
    }

    /// Handles wishes and questions between two stretches.
    void attend(const RenderState& state, bool finished) {
        const Wishes before = wishes_;
        take_wishes();
        if (is_other(wishes_)) return;
        const Film& film = state.film;
        const Exhibit exhibit{prepared_->shot, staged_.sources, settings_, film, rays_};
        desk_.questions().answer(exhibit);
        const bool new_view = wishes_.look.view != before.look.view || plate_ == nullptr;
        const bool lacks_lights = wishes_.look.relights() && plate_ && plate_->lights.empty();
        const bool over = finished && !finished_;
        const bool quiet = takes_quiet();
        const bool denoises = wishes_.look.denoised != before.look.denoised;
        finished_ = finished;
        const bool needs_film = lacks_lights || over || quiet || denoises;
        if (new_view || needs_film || seconds_now() >= show_at_)
            show_film(exhibit, finished, new_view && !needs_film && plate_frame_ == frame_);
        if (before.paused != wishes_.paused)
            desk_.stand([&](Standing& standing) { standing.busy = !finished && !wishes_.paused; });
    }

    /// Shows the film. With `reuses`, the light of the last plate serves first, because the sums of
    /// all pixels take longer than a change of the view may.
    void show_film(const Exhibit& exhibit, bool finished, bool reuses) {
        const double before = seconds_now();
        const Film& film = exhibit.film;
        const bool relights = wishes_.look.relights();
        Plate plate = reuses ? *plate_
                      : quiet_ && wishes_.look.denoised
                          ? *quiet_
                          : plate_of(film, aovs_, staged_.film, relights || finished,
                                     rough_ ? &*rough_ : nullptr);
        const std::string& view_name = wishes_.look.view;
        plate.view_name = view_name;
        plate.view.reset();
        if (view_name != "picture") {
            const auto kept = still_.find(view_name);
            if (kept != still_.end()) {
                plate.view = kept->second;
            } else if (is_still(view_name)) {
                constexpr int quick = 4;
                plate.view = view(exhibit, view_name, quick);
                show(plate);
                plate.view = view(exhibit, view_name, 1, [this] { return called(); });
                if (called()) {
                    show_at_ = before;  // the complete layer is still to be shown
                    return;
                }
                still_[view_name] = *plate.view;
            } else {
                plate.view = view(exhibit, view_name);
            }
        }
        show(std::move(plate));
        tell(film, finished);
        if (wishes_.look.denoised && !desk_.quiet_work().valid()) begin_quiet(film);
        const double now = seconds_now();
        constexpr double least = 0.5, greatest = 3, share = 10;
        show_at_ = finished ? std::numeric_limits<double>::infinity()
                            : now + std::clamp(share * (now - before), least, greatest);
        if (reuses && !finished) show_at_ = now + (view_name == "picture" ? 0 : least);
    }

    void show(Plate plate) {
        note_lamps(plate);
        plate_ = std::make_shared<const Plate>(std::move(plate));
        plate_frame_ = frame_;
        desk_.show(plate_, frame_);
    }

    /// Records the light of each lamp once it is available separately.
    void note_lamps(const Plate& plate) {
        if (plate.lights.size() != lamps_.size() || plate.lights.empty()) return;
        for (std::size_t k = 0; k < lamps_.size(); ++k) lamps_[k].shown = mean_of(plate.lights[k]);
        tell_scene();
    }

    void tell(const Film& film, bool finished) {
        double samples = 0, variance = 0;
        for (const PixelSum& pixel : film.pixels()) {
            samples += pixel.samples;
            variance += pixel.variance_of_mean();
        }
        const auto pixels = static_cast<double>(film.pixels().size());
        const double spent = seconds_now() - begun_;
        const double done =
            staged_.options.time ? spent / *staged_.options.time : static_cast<double>(done_);
        desk_.stand([&](Standing& standing) {
            standing.line = message(film.width(), " x ", film.height());
            standing.progress = finished ? 1 : std::clamp(done, 0.0, 1.0);
            standing.samples = samples / pixels;
            standing.noise = std::sqrt(variance / pixels);
            constexpr double known_from = 0.02;
            standing.seconds_left = finished             ? 0
                                    : done >= known_from ? spent * (1 - done) / done
                                                         : -1;
            standing.busy = !finished && !wishes_.paused;
        });
    }

    /// Denoises a copy of the film in parallel with the rendering, each time the number of samples
    /// has doubled.
    void begin_quiet(const Film& film) {
        std::uint64_t samples = 0;
        bool covered = true;
        for (const PixelSum& pixel : film.pixels()) {
            samples += pixel.samples;
            covered &= pixel.samples > 1 || pixel.target == 0;
        }
        const bool last = finished_ && samples > quiet_samples_;
        if (!covered || (samples < 2 * quiet_samples_ && !last)) return;
        quiet_samples_ = samples;
        quiet_generation_ = frame_->generation;
        desk_.quiet_work() = std::async(std::launch::async, [copy = film, files = files_] {
            QuietFilm quiet = denoised_film(copy, files);
            Plate plate;
            plate.width = copy.width();
            plate.height = copy.height();
            plate.light = std::move(quiet.light);
            plate.smooth = std::move(quiet.smooth);
            plate.lights = std::move(quiet.lights);
            return plate;
        });
    }

    /// Takes a denoised plate that is ready. Returns whether there was one.
    bool takes_quiet() {
        if (!desk_.quiet_work().valid() ||
            desk_.quiet_work().wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return false;
        Plate plate = desk_.quiet_work().get();
        if (quiet_generation_ != frame_->generation) return false;
        quiet_ = std::move(plate);
        return true;
    }

    const Staged& staged_;
    PreviewDesk& desk_;
    const Leaving& leaving_;
    const RenderSettings settings_;
    const Sight base_;
    std::vector<LampLine> lamps_;
    FilmFiles files_;
    Aovs aovs_;
    std::unique_ptr<Prepared> prepared_;  ///< for the last fine picture; null: there was none
    int prepared_version_ = -1;           ///< of the orbit
    Wishes wishes_;                       ///< newest known
    Wishes rendered_;                     ///< at the start of the picture
    int wish_version_ = -1;
    std::shared_ptr<const PlateFrame> frame_;
    std::shared_ptr<const Plate> plate_;
    std::shared_ptr<const PlateFrame> plate_frame_;  ///< of the last plate
    std::optional<Plate> rough_, quiet_;
    std::map<std::string, Image> still_;  ///< layers that do not change
    std::uint64_t quiet_samples_ = 0;
    int quiet_generation_ = 0;
    LightLedger rays_;
    std::atomic<double> done_ = 0;
    double begun_ = 0, show_at_ = 0;
    bool finished_ = false;
};

}  // namespace

void render_on_stage(const Staged& staged, PreviewDesk& desk, const Leaving& leaving) {
    StageRun(staged, desk, leaving).run();
}

}  // namespace candelabra
