// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/renderer.h"

#include "base/unless_ended.h"
#include "film/film.h"
#include "options/region.h"
#include "output/film_images.h"
#include "output/layers.h"
#include "output/light_report.h"
#include "output/stats.h"
#include "preview/inspect.h"
#include "production/render_job.h"
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
/// Samples of a coarse picture that is denoised, which must not take longer than `soon`.
constexpr int rough_samples = 4;
/// Maximum memory for the sums of lights, in bytes.
constexpr double light_bytes = 512e6;

bool has_room_for_lights(const ReadyScene& scene) {
    const RenderSettings& settings = scene.options.render;
    return static_cast<double>(settings.width) * settings.height * 3 * sizeof(ExactSum) *
               static_cast<double>(scene.lights.size()) <=
           light_bytes;
}

/// Returns the outputs to gather, as for a run with layers.
FilmFiles gathered(const ReadyScene& scene, bool denoised) {
    FilmFiles files{{}, scene.format};
    if (!scene.lights.empty() && has_room_for_lights(scene)) files.layers = {PictureLayer::lights};
    files.lights = scene.lights;
    files.film = scene.film;
    files.denoise = denoised;
    files.threads = scene.options.render.threads;
    return files;
}

/// Returns a snapshot of a film of denoised() files.
LightSnapshot quiet_snapshot(const Film& film, const FilmFiles& files) {
    QuietFilm quiet = denoised_film(film, files);
    LightSnapshot snapshot;
    snapshot.width = film.width();
    snapshot.height = film.height();
    snapshot.light = std::move(quiet.light);
    snapshot.smooth = std::move(quiet.smooth);
    snapshot.lights = std::move(quiet.lights);
    return snapshot;
}

double distance_ahead(const World& world, const RenderSettings& settings) {
    const PicturePoint middle{settings.width / 2, settings.height / 2, settings.width,
                              settings.height};
    const WorldView& view = world.stated_view;
    const PrimaryHit seen = primary_hit(world, middle_ray(world, view, middle));
    if (seen.met && seen.distance > 0) return seen.distance;
    return std::max(1.0, length(view.camera.location));
}

Rgb mean_of(const Image& image) {
    Rgb sum(0);
    for (const Rgb& pixel : image.pixels) sum += pixel;
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

class PreviewRenderer {
public:
    PreviewRenderer(const ReadyScene& scene, PreviewState& preview, const Leaving& leaving)
        : scene_(scene),
          preview_(preview),
          leaving_(leaving),
          settings_(timed(scene.options)),
          base_{scene.world->stated_view.camera, distance_ahead(*scene.world, settings_)} {
        for (std::size_t k = 0; k < scene.lights.size(); ++k)
            lamps_.push_back(
                {scene.lights[k],
                 statement_text(scene.world->provenance.light_statements[k], scene.sources)});
    }

    /// Renders until the scene is left. While the page keeps changing it, each scene is still shown
    /// once.
    void run() {
        tell_scene();
        do render_or_leave();
        while (!leaving_.soon());
        preview_.questions().close();
    }

private:
    void tell_scene() {
        preview_.show_scene(base_, scene_.film, lamps_,
                            !lamps_.empty() && has_room_for_lights(scene_));
    }

    /// Renders the picture of one camera, unless the run ends meanwhile.
    void render_or_leave() {
        unless_ended(leaving_.at_once, [&] {
            render();
            return true;
        });
    }

    void render() {
        take_wishes();
        rendered_ = wishes_;
        files_ = gathered(scene_, wishes_.look.denoised);
        aovs_ = files_.aovs();
        begun_ = seconds_now();
        context_ = std::make_shared<const SnapshotContext>(
            SnapshotContext{scene_.film, scene_.format, scene_.lights, settings_.threads,
                            preview_.next_generation()});
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
        return {scene_.world, settings, [&](const Projection& stated) {
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
        if (!prepared_ && !(first && !scene_.world->photon_targets.empty())) prepare();
        return prepared_ ? prepared_->sent : SentLight{};
    }

    void take_wishes() {
        wish_version_ = preview_.wish_version();
        wishes_ = preview_.wishes();
    }

    /// Whether the picture being made is no longer wanted.
    bool outdated() const {
        if (leaving_.soon()) return true;
        if (preview_.wish_version() == wish_version_) return false;
        return is_other(preview_.wishes());
    }

    bool is_other(const Wishes& wishes) const {
        return wishes.orbit_version != rendered_.orbit_version ||
               (wishes.look.denoised && !rendered_.look.denoised);
    }

    /// Makes the coarse pictures. The first is always shown, so that continuous changes stay
    /// visible. Returns false if something else is wanted.
    bool make_rough() {
        const Shot quick = shot(true);
        const FilmFiles files = gathered(scene_, true);
        const Aovs aovs = files.aovs();
        bool shown = false;
        for (const int step : coarse_steps) {
            RenderSettings settings = settings_;
            settings.width = (settings_.width + step - 1) / step;
            settings.height = (settings_.height + step - 1) / step;
            if (std::min(settings.width, settings.height) < min_edge) continue;
            // While the camera moves, a few samples without their noise show more than one with it.
            double& pace = rough_pace_.try_emplace(step, soon).first->second;
            const bool quiet = rough_samples * pace < soon;
            settings.samples = quiet ? rough_samples : 1;
            settings.noise = 0;
            settings.antialias = quiet;
            RenderHooks hooks;
            hooks.aovs = aovs;
            const double before = seconds_now();
            // Nobody waits long for the first one.
            constexpr double patience = 1;
            hooks.cancelled = hooks.ended = [&] {
                return leaving_.at_once() ||
                       ((shown || seconds_now() - before > patience) && outdated());
            };
            RenderState state = begin_picture(settings, aovs.count(*scene_.world));
            LightLedger rays;
            const RenderPlan plan{
                quick,         settings,
                ShadowRays{1}, light_for_rough(!shown),
                static_cast<std::uint32_t>(settings.samples), NoiseRule{}};
            if (!advance(plan, state, rays, hooks)) return false;
            rough_ = quiet ? quiet_snapshot(state.film, files)
                           : snapshot_of(state.film, aovs, scene_.film, true);
            const double now = seconds_now();
            pace = (now - before) / settings.samples;
            constexpr double growth = 4;
            const bool waits =
                step == coarse_steps[0] && now - begun_ + growth * (now - before) < soon;
            rough_->width = settings_.width;
            rough_->height = settings_.height;
            if (waits) continue;
            shown = true;
            const std::string& view_name = wishes_.look.view;
            if (is_still(view_name)) {
                LightSnapshot layer = *rough_;
                layer.view_name = view_name;
                layer.view = view({quick, scene_.sources, settings, state.film, rays}, view_name);
                show(std::move(layer));
            } else if (view_name == "picture") {
                show(*rough_);
            }
            preview_.set_status([&](RenderStatus& status) {
                status = {};
                status.line = message(settings.width, " x ", settings.height);
                status.busy = true;
            });
        }
        return !(shown && outdated());
    }

    void make_fine() {
        prepare();
        RenderState state = begin_picture(settings_, aovs_.count(*scene_.world));
        state.shard.region = region_of(scene_.options);
        rays_ = {};
        done_ = 0;
        begin_clock();
        bool finished = finished_ = false;
        while (!outdated()) {
            if (!finished && !wishes_.paused) finished = stretch(state);
            if (outdated()) return;
            attend(state, finished);
            constexpr int moment = 50;
            if ((finished || wishes_.paused) && preview_.wish_version() == wish_version_ &&
                !preview_.questions().waiting())
                preview_.rest(moment);
        }
    }

    void begin_clock() {
        begun_ = seconds_now();
        constexpr double first_look = 0.3;
        show_at_ = begun_ + first_look;
    }

    /// Whether a wish or a question waits.
    bool called() const {
        return leaving_.soon() || preview_.wish_version() != wish_version_ ||
               preview_.questions().waiting();
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
        return scene_.options.time ? begun_ + *scene_.options.time
                                   : std::numeric_limits<double>::infinity();
    }

    /// Handles wishes and questions between two stretches.
    void attend(const RenderState& state, bool finished) {
        const Wishes before = wishes_;
        take_wishes();
        if (is_other(wishes_)) return;
        const Film& film = state.film;
        const RenderedPicture picture{prepared_->shot, scene_.sources, settings_, film, rays_};
        preview_.questions().answer(picture);
        const bool new_view = wishes_.look.view != before.look.view || snapshot_ == nullptr;
        const bool lacks_lights = wishes_.look.relights() && snapshot_ && snapshot_->lights.empty();
        const bool over = finished && !finished_;
        const bool quiet = takes_quiet();
        const bool denoises = wishes_.look.denoised != before.look.denoised;
        finished_ = finished;
        const bool needs_film = lacks_lights || over || quiet || denoises;
        if (new_view || needs_film || seconds_now() >= show_at_)
            show_film(picture, finished, new_view && !needs_film && snapshot_context_ == context_);
        if (before.paused != wishes_.paused)
            preview_.set_status(
                [&](RenderStatus& status) { status.busy = !finished && !wishes_.paused; });
    }

    /// Shows the film. With `reuses`, the light of the last snapshot serves first, because the sums
    /// of all pixels take longer than a change of the view may.
    void show_film(const RenderedPicture& picture, bool finished, bool reuses) {
        const double before = seconds_now();
        const Film& film = picture.film;
        const bool relights = wishes_.look.relights();
        LightSnapshot snapshot = reuses ? *snapshot_
                                 : quiet_ && wishes_.look.denoised
                                     ? *quiet_
                                     : snapshot_of(film, aovs_, scene_.film, relights || finished,
                                                   rough_ ? &*rough_ : nullptr);
        const std::string& view_name = wishes_.look.view;
        snapshot.view_name = view_name;
        snapshot.view.reset();
        if (view_name != "picture") {
            const auto kept = still_.find(view_name);
            if (kept != still_.end()) {
                snapshot.view = kept->second;
            } else if (is_still(view_name)) {
                constexpr int quick = 4;
                snapshot.view = view(picture, view_name, quick);
                show(snapshot);
                snapshot.view = view(picture, view_name, 1, [this] { return called(); });
                if (called()) {
                    show_at_ = before;  // the complete layer is still to be shown
                    return;
                }
                still_[view_name] = *snapshot.view;
            } else {
                snapshot.view = view(picture, view_name);
            }
        }
        show(std::move(snapshot));
        tell(film, finished);
        if (wishes_.look.denoised && !preview_.quiet_work().valid()) begin_quiet(film);
        const double now = seconds_now();
        constexpr double least = 0.5, greatest = 3, share = 10;
        show_at_ = finished ? std::numeric_limits<double>::infinity()
                            : now + std::clamp(share * (now - before), least, greatest);
        if (reuses && !finished) show_at_ = now + (view_name == "picture" ? 0 : least);
    }

    void show(LightSnapshot snapshot) {
        note_lamps(snapshot);
        snapshot_ = std::make_shared<const LightSnapshot>(std::move(snapshot));
        snapshot_context_ = context_;
        preview_.show(snapshot_, context_);
    }

    /// Records the light of each lamp once it is available separately.
    void note_lamps(const LightSnapshot& snapshot) {
        if (snapshot.lights.size() != lamps_.size() || snapshot.lights.empty()) return;
        for (std::size_t k = 0; k < lamps_.size(); ++k)
            lamps_[k].shown = mean_of(snapshot.lights[k]);
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
            scene_.options.time ? spent / *scene_.options.time : static_cast<double>(done_);
        preview_.set_status([&](RenderStatus& status) {
            status.line = message(film.width(), " x ", film.height());
            status.progress = finished ? 1 : std::clamp(done, 0.0, 1.0);
            status.samples = samples / pixels;
            status.noise = std::sqrt(variance / pixels);
            constexpr double known_from = 0.02;
            status.seconds_left = finished             ? 0
                                  : done >= known_from ? spent * (1 - done) / done
                                                       : -1;
            status.busy = !finished && !wishes_.paused;
        });
    }

    /// Denoises a copy of the film in parallel with the rendering, each time the number of samples
    /// has doubled.
    void begin_quiet(const Film& film) {
        std::uint64_t samples = 0;
        bool covered = true;
        for (const PixelSum& pixel : film.pixels()) {
            samples += pixel.samples;
            covered &= pixel.samples > 1 || pixel.planned == 0;
        }
        const bool last = finished_ && samples > quiet_samples_;
        if (!covered || (samples < 2 * quiet_samples_ && !last)) return;
        quiet_samples_ = samples;
        quiet_generation_ = context_->generation;
        preview_.quiet_work() = std::async(std::launch::async, [copy = film, files = files_] {
            return quiet_snapshot(copy, files);
        });
    }

    /// Takes a denoised snapshot that is ready. Returns whether there was one.
    bool takes_quiet() {
        if (!preview_.quiet_work().valid() ||
            preview_.quiet_work().wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return false;
        LightSnapshot snapshot = preview_.quiet_work().get();
        if (quiet_generation_ != context_->generation) return false;
        quiet_ = std::move(snapshot);
        return true;
    }

    const ReadyScene& scene_;
    PreviewState& preview_;
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
    std::shared_ptr<const SnapshotContext> context_;
    std::shared_ptr<const LightSnapshot> snapshot_;
    std::shared_ptr<const SnapshotContext> snapshot_context_;  ///< of the last snapshot
    std::optional<LightSnapshot> rough_, quiet_;
    std::map<int, double> rough_pace_;  ///< seconds of a sample of the last coarse pictures
    std::map<std::string, Image> still_;  ///< layers that do not change
    std::uint64_t quiet_samples_ = 0;
    int quiet_generation_ = 0;
    LightLedger rays_;
    std::atomic<double> done_ = 0;
    double begun_ = 0, show_at_ = 0;
    bool finished_ = false;
};

}  // namespace

void render_preview(const ReadyScene& scene, PreviewState& preview, const Leaving& leaving) {
    PreviewRenderer(scene, preview, leaving).run();
}

}  // namespace candelabra
