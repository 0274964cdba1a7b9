// SPDX-License-Identifier: GPL-3.0-or-later
// One run over one scene, step by step and without a console: reads the text, evaluates it, reviews
// the scene and compiles it. It is independent of the command line, prints nothing and does not end
// the program. Used by make_picture(), and by the command line, which does more between the steps.
#pragma once

#include "bind/evaluate.h"
#include "scene/settings.h"
#include "session/read_files.h"
#include "text/made_files.h"
#include "world/instance_plan.h"
#include "world/world.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// The location of a scene, and the files that it may access.
struct SceneSource {
    /// Path of the scene's file; `.pov` may be omitted. The scene finds other files beside it, or,
    /// if it is given as text, in the current folder.
    std::string path = {};
    std::optional<std::string> text = {};    ///< text of a scene without a file
    std::string name = {};                   ///< name of the text in messages
    std::string standard_library = {};       ///< its folder; empty: none
    std::vector<std::string> library = {};   ///< folders that are searched for files, in order
    std::string povray_library = {};  ///< of POV-Ray's include files, if installed; empty: none
    std::vector<std::string> readable = {};  ///< folders below which the scene may also read
    /// Path of the picture: the scene may read pictures of that name, and what lies beside it if
    /// the scene itself lies there. Empty: none.
    std::string picture = {};
    /// Folders below which it may write. The first is its own folder, which is made when it is
    /// needed (text/file_access.h).
    std::vector<std::string> writable = {};
    bool writes_files = false;  ///< false: its output files are not stored on disk
    /// Files made by other runs, which this one may write to. Null: none.
    std::shared_ptr<MadeFiles> made_files = {};
};

struct SessionSettings {
    SceneSource source;
    RenderSettings render = {};
    /// Facts for the scene, and its limits. The size of the picture is that of `render`.
    EvaluateOptions evaluation = {};
    bool notes_files = true;         ///< records Session::files()
    bool shows_picture = true;       ///< review() warns of a picture that is stretched
    bool remembers_objects = false;  ///< records Provenance::object_of
    bool follows_lamps = false;      ///< keeps luminaires also if no surface shows their light
    InstanceLimits instances = {};   ///< which unions are stored once
};

class Session {
public:
    /// The diagnostics must outlive the session and receive all errors. Do not call a step whose
    /// input has errors.
    Session(SessionSettings, Diagnostics&);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Reads the scene's text. Returns false, after an error, if there is none.
    bool read();

    /// Evaluates the text, with the run's rule for which objects are luminaires. The scene is
    /// incomplete if there are errors.
    Scene evaluate();

    /// Warns of probable mistakes in a valid scene that is not compiled.
    void review(const Scene&);

    enum class Shutter {
        first_sample,  ///< the scene when the shutter opens
        all_samples    ///< also later moments of the open shutter, each evaluated again
    };
    /// `reviewed`: warns of probable mistakes, too, which needs less time than review().
    SharedWorld compile(Scene&&, Shutter, bool reviewed = false);

    /// Sources of the scene and of all files that it includes.
    SourceStore& sources() { return sources_; }
    SourceId main() const { return main_; }
    const std::vector<ReadFile>& files() const { return files_; }

private:
    void review_text();
    void review_shape(const Scene&);
    Reader noted(Reader);
    FileAccess file_access() const;
    Scene evaluate(double clock_ahead, Diagnostics&);
    std::optional<Scene> scene_at(double clock_ahead);

    SessionSettings settings_;
    Diagnostics& diagnostics_;
    SourceStore sources_;
    SourceId main_ = no_source;
    std::string folder_;  ///< that contains the scene
    std::vector<ReadFile> files_;
};

}  // namespace candelabra
