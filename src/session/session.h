// SPDX-License-Identifier: GPL-3.0-or-later
// One run over one scene, step by step and without a console: reads the text, evaluates it, reviews
// the scene and compiles it. It knows no command line, prints nothing and ends nothing. Used by
// make_picture(), and by the command line, which has more to do between the steps.
#pragma once

#include "bind/evaluate.h"
#include "scene/settings.h"
#include "session/read_files.h"
#include "text/made_files.h"
#include "world/world.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// Where a scene is, and which files it may touch.
struct SceneSource {
    /// Of the scene's file; `.pov` may be left out. The scene finds other files beside it, or, when
    /// it is a text, in the current folder.
    std::string path = {};
    std::optional<std::string> text = {};    ///< a scene that is in no file; nothing: it is in one
    std::string name = {};                   ///< of such a text, in messages
    std::string standard_library = {};       ///< its folder; empty: there is none
    std::vector<std::string> library = {};   ///< folders in which files are looked for, in order
    std::vector<std::string> readable = {};  ///< folders that the scene may read below, too
    std::vector<std::string> writable = {};  ///< folders that it may write below; else none
    bool writes_files = false;               ///< false: what it writes goes to no disk
    /// Files that other runs have made, which this one may write to. Null: there are none.
    std::shared_ptr<MadeFiles> made_files = {};
};

struct SessionSettings {
    SceneSource source;
    RenderSettings render = {};
    /// What the scene is told and may do. The size of the picture is that of `render`.
    EvaluateOptions evaluation = {};
    bool notes_files = true;         ///< Session::files() is wanted
    bool remembers_objects = false;  ///< Provenance::object_of is wanted
};

class Session {
public:
    /// The diagnostics outlive this; all that is wrong goes there, and steps whose input has errors
    /// are not to be taken.
    Session(SessionSettings, Diagnostics&);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Reads the scene's text. False, after an error: there is none.
    bool read();

    /// The scene of the text that has been read, with the run's rule of what is a luminaire. It has
    /// holes when there are errors.
    Scene evaluate();

    /// Says what is likely a mistake in the scene though it is legal.
    void review(const Scene&);

    enum class Shutter {
        first_sample,  ///< the scene as it is when the shutter opens
        all_samples    ///< also what it is while the shutter stays open, for which it is evaluated
                       ///< again
    };
    const World compile(Scene&&, Shutter);

    /// Of the scene and of all files that it includes.
    SourceStore& sources() { return sources_; }
    SourceId main() const { return main_; }
    const std::vector<ReadFile>& files() const { return files_; }

private:
    Reader noted(Reader);
    FileAccess file_access() const;
    Scene evaluate(double clock_ahead, Diagnostics&);
    std::optional<Scene> scene_at(double clock_ahead);

    SessionSettings settings_;
    Diagnostics& diagnostics_;
    SourceStore sources_;
    SourceId main_ = no_source;
    std::string folder_;  ///< of the scene
    std::vector<ReadFile> files_;
};

}  // namespace candelabra
