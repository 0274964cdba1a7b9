// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/state.h"

#include "preview/inspect.h"
#include "scene/dump.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <system_error>

namespace candelabra {

namespace {

using Json = nlohmann::json;

Json json_of(const Rgb& c) { return {c.r, c.g, c.b}; }

Json json_of(const FilmSettings& film) {
    return {{"on", film.on},
            {"exposure", film.exposure},
            {"auto", film.auto_exposure},
            {"key", film.key},
            {"white_balance", film.white_balance},
            {"response", film.response},
            {"contrast", film.contrast},
            {"saturation", film.saturation},
            {"vignette", film.vignette},
            {"grain", film.grain},
            {"glare", film.glares},
            {"veil", film.glare.veil},
            {"halo", film.glare.halo},
            {"star", film.glare.star},
            {"blades", film.glare.blades}};
}

std::string current_folder() {
    std::error_code none;
    return std::filesystem::current_path(none).string();
}

/// Adds a change, which replaces an earlier one of the same setting.
void keep(std::vector<FilmChange>& changes, const FilmChange& wanted) {
    std::erase_if(changes, [&](const FilmChange& each) { return each.name == wanted.name; });
    changes.push_back(wanted);
}

}  // namespace

PreviewState::PreviewState(std::function<void()> changed)
    : changed_(std::move(changed)),
      folder_(current_folder()),
      developer_([this](ScreenPicture picture) {
          {
              const std::lock_guard lock(mutex_);
              picture_ = std::move(picture);
              ++pictures_;
          }
          told();
      }) {}

void PreviewState::wished() {
    ++wish_version_;
    wish_.notify_all();
    told();
}

void PreviewState::told() {
    ++version_;
    changed_();
}

std::string PreviewState::change_film(const FilmChange& wanted) {
    Look look;
    {
        const std::lock_guard lock(mutex_);
        FilmSettings film = film_with(film_, wishes_.look);
        if (const std::string wrong = change_look(film, wanted); !wrong.empty()) return wrong;
        keep(wishes_.look.film, wanted);
        look = wishes_.look;
    }
    developer_.set(look);
    wished();
    return {};
}

void PreviewState::reset_film() {
    Look look;
    {
        const std::lock_guard lock(mutex_);
        wishes_.look.film.clear();
        look = wishes_.look;
    }
    developer_.set(look);
    wished();
}

bool PreviewState::dim(std::size_t lamp, const Dimmer& dimmer) {
    Look look;
    {
        const std::lock_guard lock(mutex_);
        if (lamp >= lamps_.size()) return false;
        wishes_.look.lamps[lamps_[lamp].name] = dimmer;
        look = wishes_.look;
    }
    developer_.set(look);
    wished();
    return true;
}

void PreviewState::reset_lamps() {
    Look look;
    {
        const std::lock_guard lock(mutex_);
        for (auto& [name, dimmer] : wishes_.look.lamps) dimmer = {};
        look = wishes_.look;
    }
    developer_.set(look);
    wished();
}

bool PreviewState::choose_view(const std::string& name) {
    const auto all = views();
    if (name != "picture" && std::ranges::find(all, name) == all.end()) return false;
    {
        const std::lock_guard lock(mutex_);
        wishes_.look.view = name;
    }
    wished();
    return true;
}

void PreviewState::denoise(bool on) {
    {
        const std::lock_guard lock(mutex_);
        wishes_.look.denoised = on;
    }
    wished();
}

void PreviewState::move_camera(const std::function<void(Orbit&, const Sight&)>& move) {
    {
        const std::lock_guard lock(mutex_);
        if (!base_ || !can_orbit(base_->camera)) return;
        move(wishes_.orbit, *base_);
        ++wishes_.orbit_version;
    }
    wished();
}

void PreviewState::point_at(const Vec2& place) {
    const std::lock_guard lock(mutex_);
    wishes_.focus = place;
}

void PreviewState::pause(bool on) {
    {
        const std::lock_guard lock(mutex_);
        wishes_.paused = on;
    }
    wished();
}

bool PreviewState::turn(const std::string& name, std::string_view value) {
    {
        const std::lock_guard lock(mutex_);
        const auto knob = std::ranges::find(knobs_, name, &Knob::name);
        const auto wanted = knob == knobs_.end() ? std::nullopt : knob_value(*knob, value);
        if (!wanted) return false;
        set_[name] = *wanted;
        turned_ = true;
    }
    wished();
    return true;
}

std::string PreviewState::status() const {
    const std::lock_guard lock(mutex_);
    Json knobs = Json::array(), lamps = Json::array();
    for (const Knob& knob : knobs_) {
        const auto set = set_.find(knob.name);
        knobs.push_back(json_of(knob, set == set_.end() ? knob.value : set->second));
    }
    for (const LampLine& lamp : lamps_) {
        const auto set = wishes_.look.lamps.find(lamp.name);
        const Dimmer dimmer = set == wishes_.look.lamps.end() ? Dimmer() : set->second;
        lamps.push_back({{"name", lamp.name},
                         {"statement", lamp.statement},
                         {"shown", json_of(lamp.shown)},
                         {"strength", dimmer.strength},
                         {"colour", json_of(dimmer.colour)}});
    }
    std::vector<std::string_view> all = {"picture"};
    for (const std::string_view each : views()) all.push_back(each);
    const Json status = {{"version", version_.load()},
                         {"picture", pictures_},
                         {"generation", picture_.generation},
                         {"width", picture_.width},
                         {"height", picture_.height},
                         {"columns", picture_.columns},
                         {"line", render_status_.line},
                         {"errors", heard_.errors},
                         {"warnings", heard_.warnings},
                         {"more_warnings", heard_.more_warnings},
                         {"said", heard_.said},
                         {"progress", render_status_.progress},
                         {"samples", render_status_.samples},
                         {"noise", render_status_.noise},
                         {"left", render_status_.seconds_left},
                         {"busy", render_status_.busy},
                         {"paused", wishes_.paused},
                         {"views", all},
                         {"view", wishes_.look.view},
                         {"shown_view", picture_.view},
                         {"denoise", wishes_.look.denoised},
                         {"film", json_of(film_with(film_, wishes_.look))},
                         {"film_changed", !wishes_.look.film.empty()},
                         {"lamps", lamps},
                         {"lit_apart", lit_apart_},
                         {"relit", wishes_.look.relights()},
                         {"moved", wishes_.orbit.moved()},
                         {"can_move", base_ && can_orbit(base_->camera)},
                         {"folder", folder_},
                         {"knobs", knobs}};
    return status.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ScreenPicture PreviewState::picture() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::string PreviewState::camera() const {
    const std::lock_guard lock(mutex_);
    return base_ ? camera_script(wishes_.orbit.place(*base_)) : std::string();
}

std::string PreviewState::film() const {
    const std::lock_guard lock(mutex_);
    return film_text(film_with(film_, wishes_.look));
}

Wishes PreviewState::wishes() const {
    const std::lock_guard lock(mutex_);
    return wishes_;
}

std::vector<std::pair<std::string, KnobValue>> PreviewState::take_knobs(std::vector<Knob> knobs) {
    const std::lock_guard lock(mutex_);
    turned_ = false;
    knobs_ = std::move(knobs);
    std::vector<std::pair<std::string, KnobValue>> declared;
    for (const Knob& knob : knobs_)
        if (const auto set = set_.find(knob.name); set != set_.end())
            declared.emplace_back(knob.name, set->second);
    return declared;
}

double PreviewState::knob(const std::string& name, double otherwise) const {
    const std::lock_guard lock(mutex_);
    const auto set = set_.find(name);
    const double* value = set == set_.end() ? nullptr : std::get_if<double>(&set->second);
    return value ? *value : otherwise;
}

void PreviewState::show(std::shared_ptr<const LightSnapshot> snapshot,
                        std::shared_ptr<const SnapshotContext> context) {
    developer_.take(std::move(snapshot), std::move(context));
}

void PreviewState::set_status(const std::function<void(RenderStatus&)>& change) {
    {
        const std::lock_guard lock(mutex_);
        change(render_status_);
    }
    told();
}

void PreviewState::hear(Heard heard) {
    {
        const std::lock_guard lock(mutex_);
        heard_ = std::move(heard);
    }
    told();
}

void PreviewState::show_scene(const Sight& base, const FilmSettings& film,
                              std::vector<LampLine> lamps, bool lit_apart) {
    {
        const std::lock_guard lock(mutex_);
        base_ = base;
        film_ = film;
        lamps_ = std::move(lamps);
        lit_apart_ = lit_apart;
    }
    told();
}

void PreviewState::rest(int milliseconds) const {
    std::unique_lock lock(mutex_);
    const int before = wish_version_;
    wish_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                   [&] { return wish_version_ != before; });
}

}  // namespace candelabra
