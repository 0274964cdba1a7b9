// SPDX-License-Identifier: GPL-3.0-or-later
// Exchanges data between the preview's page and its renderer: the wishes of the page, and the
// picture with its state. All functions are thread-safe.
#pragma once

#include "base/rgb.h"
#include "camera/orbit.h"
#include "console/heard.h"
#include "editor/knobs.h"
#include "preview/developer.h"
#include "preview/queries.h"

#include <atomic>
#include <future>

namespace candelabra {

/// The page's wishes for the rendering. Its Look holds those that only affect developing.
struct Wishes {
    Look look;
    Orbit orbit;
    int orbit_version = 0;           ///< increments when the camera is moved
    std::optional<Vec2> focus = {};  ///< point in the picture to focus on, from 0 to 1
    bool paused = false;
};

/// A statement that makes lights, for the page's list.
struct LampLine {
    std::string name, statement;
    Rgb shown = Rgb(0);  ///< mean light that it adds to the picture; 0 until known
};

/// The state of the picture.
struct RenderStatus {
    std::string line;          ///< in words
    double progress = 0;       ///< fraction of the work
    double samples = 0;        ///< mean per pixel
    double noise = 0;          ///< standard deviation of the mean in display values, 0 to 1
    double seconds_left = -1;  ///< negative: unknown
    bool busy = false;         ///< the picture is converging
};

class PreviewState {
public:
    /// `changed`: called after each change of the data for the page.
    explicit PreviewState(std::function<void()> changed);

    // Called by the page.
    /// Returns an error as a sentence, or empty.
    std::string change_film(const FilmChange&);
    void reset_film();
    bool dim(std::size_t lamp, const Dimmer&);
    void reset_lamps();
    bool choose_view(const std::string& name);
    void denoise(bool);
    void move_camera(const std::function<void(Orbit&, const Sight&)>& move);
    void point_at(const Vec2&);
    void pause(bool);
    /// `value`: as knob_value() reads it.
    bool turn(const std::string& knob, std::string_view value);
    /// Returns the state for the page as JSON.
    std::string status() const;
    int version() const { return version_; }
    ScreenPicture picture() const;
    std::string picture_file(bool exr) const { return exr ? developer_.exr() : developer_.png(); }
    std::string camera() const;
    std::string film() const;
    Questions& questions() { return questions_; }

    // Called by the renderer.
    Wishes wishes() const;
    /// Returns the version of the wishes; it changes with every new wish.
    int wish_version() const { return wish_version_; }
    /// Returns declarations for the scene and resets `turned()`.
    std::vector<std::pair<std::string, KnobValue>> take_knobs(std::vector<Knob>);
    /// Returns what the page has set a slider to.
    double knob(const std::string& name, double otherwise) const;
    bool turned() const { return turned_; }
    void show(std::shared_ptr<const LightSnapshot>, std::shared_ptr<const SnapshotContext>);
    void set_status(const std::function<void(RenderStatus&)>& change);
    /// Tells what has been said of the scene. With errors the picture is an older one.
    void hear(Heard);
    /// `base`: the camera of the scene.
    void show_scene(const Sight& base, const FilmSettings&, std::vector<LampLine>, bool lit_apart);
    int next_generation() { return ++generation_; }
    /// A denoised snapshot that is being made, of this or the previous scene; only used by the
    /// renderer.
    std::future<LightSnapshot>& quiet_work() { return quiet_work_; }
    /// Waits for a wish, at most this many milliseconds.
    void rest(int milliseconds) const;

private:
    void wished();
    void told();

    std::function<void()> changed_;
    std::string folder_;  ///< base of relative names in messages
    mutable std::mutex mutex_;
    mutable std::condition_variable wish_;
    Wishes wishes_;
    std::atomic<int> wish_version_ = 0, version_ = 0, generation_ = 0;
    std::atomic<bool> turned_ = false;
    std::vector<Knob> knobs_;
    std::map<std::string, KnobValue> set_;  ///< values of knobs, by name
    RenderStatus render_status_;
    Heard heard_;
    ScreenPicture picture_;
    int pictures_ = 0;
    std::optional<Sight> base_;
    FilmSettings film_;  ///< the scene's
    std::vector<LampLine> lamps_;
    bool lit_apart_ = false;  ///< the light of each lamp is available separately
    Questions questions_;
    std::future<LightSnapshot> quiet_work_;
    SnapshotDeveloper developer_;  ///< the last member: its thread uses the others
};

}  // namespace candelabra
