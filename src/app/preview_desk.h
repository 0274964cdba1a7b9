// SPDX-License-Identifier: GPL-3.0-or-later
// What the preview's page and its renderer tell each other: how one wants to look at the scene, and
// what there is to see. Every function may be called by any thread.
#pragma once

#include "app/preview_darkroom.h"
#include "app/render_queries.h"
#include "camera/orbit.h"
#include "editor/knobs.h"

#include <atomic>
#include <future>

namespace candelabra {

/// How the page wants the scene to be rendered; what it only wants to be developed is in its Look.
struct Wishes {
    Look look;
    Orbit orbit;
    int orbit_version = 0;           ///< grows when the camera is moved
    std::optional<Vec2> focus = {};  ///< of the whole picture, 0 to 1: where one points
    bool paused = false;
};

/// A statement that makes lights, for the page's list.
struct LampLine {
    std::string name, statement;
    Vec3 shown = Vec3(0);  ///< mean light that it gives the picture; 0 until it is known
};

/// How far the picture is.
struct Standing {
    std::string line;          ///< in words
    std::string errors;        ///< of the scene; the picture is an older one then
    double progress = 0;       ///< share of the work
    double samples = 0;        ///< of a pixel, in the mean
    double noise = 0;          ///< deviation of the mean as it is shown, 0 to 1
    double seconds_left = -1;  ///< below 0: nobody knows
    bool busy = false;         ///< it becomes better
};

class PreviewDesk {
public:
    /// `changed`: called after each change of what the page is shown.
    explicit PreviewDesk(std::function<void()> changed);

    // The page's side.
    /// Nothing, or why it cannot be, as a sentence.
    std::string change_film(const FilmChange&);
    void reset_film();
    bool dim(std::size_t lamp, const Dimmer&);
    void reset_lamps();
    bool choose_view(const std::string& name);
    void denoise(bool);
    void move_camera(const std::function<void(Orbit&, const Sight&)>& move);
    void point_at(const Vec2&);
    void pause(bool);
    bool turn(const std::string& knob, double value);
    /// What the page is shown, as JSON.
    std::string status() const;
    int version() const { return version_; }
    ScreenPicture picture() const;
    std::string picture_file(bool exr) const { return exr ? darkroom_.exr() : darkroom_.png(); }
    std::string camera() const;
    std::string film() const;
    Questions& questions() { return questions_; }

    // The renderer's side.
    Wishes wishes() const;
    /// Number of all wishes up to now: as long as it stays, there is nothing new.
    int wish_version() const { return wish_version_; }
    /// Declarations for the scene; from now on `turned()` is false.
    std::vector<std::pair<std::string, double>> take_knobs(std::vector<Knob>);
    double knob(const std::string& name, double otherwise) const;
    bool turned() const { return turned_; }
    void show(std::shared_ptr<const Plate>, std::shared_ptr<const PlateFrame>);
    void stand(const std::function<void(Standing&)>& change);
    /// `base`: the camera of the scene.
    void show_scene(const Sight& base, const FilmSettings&, std::vector<LampLine>, bool lit_apart);
    int next_generation() { return ++generation_; }
    /// A plate with less noise that is being made, of this scene or the one before; only the
    /// renderer touches it.
    std::future<Plate>& quiet_work() { return quiet_work_; }
    /// Waits for a wish or some milliseconds.
    void rest(int milliseconds) const;

private:
    void wished();
    void told();

    std::function<void()> changed_;
    std::string folder_;  ///< that relative names in messages are of
    mutable std::mutex mutex_;
    mutable std::condition_variable wish_;
    Wishes wishes_;
    std::atomic<int> wish_version_ = 0, version_ = 0, generation_ = 0;
    std::atomic<bool> turned_ = false;
    std::vector<Knob> knobs_;
    std::map<std::string, double> set_;  ///< knobs, by name
    Standing standing_;
    ScreenPicture picture_;
    int pictures_ = 0;
    std::optional<Sight> base_;
    FilmSettings film_;  ///< the scene's
    std::vector<LampLine> lamps_;
    bool lit_apart_ = false;  ///< there is light of each lamp by itself
    Questions questions_;
    std::future<Plate> quiet_work_;
    Darkroom darkroom_;  ///< the last member: its thread uses the others
};

}  // namespace candelabra
