// SPDX-License-Identifier: GPL-3.0-or-later
// Who the program talks to, and what it answers in the end: main() fills it with the terminal and
// the system, tests with what they want to hear. Everything that the commands say goes through it.
#pragma once

#include "app/identity.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "text/made_files.h"
#include "text/source.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace candelabra {

class Film;
class World;
struct SandboxRules;
struct LightLedger;

/// What the shell is told.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int scene = 1;    ///< an error in the scene
inline constexpr int usage = 2;    ///< an error in the command line
inline constexpr int file = 3;     ///< a file could not be read or written
inline constexpr int stopped = 4;  ///< a signal ended the work, and its state was kept
}  // namespace exit_status

inline constexpr std::string_view no_memory_message =
    "error: there is not enough memory for this scene and picture\n"
    "help: --limit-memory says how much there may be\n";

/// A picture on its way or finished, with all that it is made from.
struct Exhibit {
    const World& world;
    const SourceStore& sources;
    const RenderSettings& settings;
    const Film& film;
    const LightLedger& rays;
};

/// A scene that is ready to be rendered.
struct Staged {
    World& world;
    const SourceStore& sources;
    const Options& options;
    PictureFormat format;                    ///< of a picture that is written
    FilmSettings film;                       ///< with the grain of this picture
    const std::vector<std::string>& lights;  ///< names of the statements that make lights
};

struct Console {
    std::function<void(std::string_view)> out;  ///< results: dumps, help
    std::function<void(std::string_view)> err;  ///< diagnostics, progress
    /// The same by kind, when options sort it; empty: err gets all. `plain`: without colours.
    std::function<void(Stream, std::string_view text, std::string_view plain)> sorted;
    bool terminal = false;  ///< err can rewrite its line
    bool coloured = false;
    std::string library;      ///< folder of the standard library; empty: none
    Interrupts interrupts;    ///< what signals ask
    Environment environment;  ///< variables; empty: there are none
    /// Confines the process to these rules; false when the system cannot. Empty: it stays free.
    std::function<bool(const SandboxRules&)> confine;
    /// Who renders the scene to look at it, so that no picture is written; and who wants to know
    /// the files that it is made from. May be empty.
    std::function<void(const Staged&)> stage;
    std::function<void(const std::vector<ReadFile>&)> files_read;
    /// So that several runs can take turns: called before a picture is rendered, which false
    /// prevents; once there may be cores that it has no work for (not with a time limit); and when
    /// it is rendered, before it is written. May be empty.
    std::function<bool()> begins_rendering;
    std::function<void()> winds_down;
    std::function<void()> ends_rendering;
    std::shared_ptr<MadeFiles> made_files;  ///< by the scene, in all pictures of the run
    std::string settings;  ///< INI file that is read before the command line; empty: none
};

/// Says something of that kind.
void say(const Console&, Stream, std::string_view text, std::string_view plain);
inline void say(const Console& console, Stream stream, std::string_view text) {
    say(console, stream, text, text);
}
void say(const Console&, const Options&, const Diagnostic&, const SourceStore&);

/// Writes all diagnostics to the console in the form that the options ask for.
void say_errors(const Console&, const Options&, const Diagnostics&);

}  // namespace candelabra
