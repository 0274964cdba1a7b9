// SPDX-License-Identifier: GPL-3.0-or-later
// The connection of the commands to the outside, and their exit status. main() connects it to the
// terminal and the system; tests provide their own functions. All output of the commands goes
// through it.
#pragma once

#include "console/interrupt.h"
#include "options/options.h"
#include "text/made_files.h"
#include "text/source.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct FinishedPicture;
struct ReadFile;
struct ReadyScene;
struct SandboxRules;

/// Exit statuses of the program.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int scene = 1;    ///< an error in the scene
inline constexpr int usage = 2;    ///< an error in the command line
inline constexpr int file = 3;     ///< a file could not be read or written
inline constexpr int stopped = 4;  ///< a signal ended the work, and the state was saved
}  // namespace exit_status

inline constexpr std::string_view no_memory_message =
    "error: there is not enough memory for this scene and picture\n"
    "help: --limit-memory sets how much there may be\n";

struct Console {
    std::function<void(std::string_view)> out;  ///< results: dumps, help
    std::function<void(std::string_view)> err;  ///< diagnostics, progress
    /// Output by stream, if options sort it. If empty, all goes to err. `plain`: the text without
    /// colours.
    std::function<void(Stream, std::string_view text, std::string_view plain)> sorted;
    /// Receives all messages of diagnostics and of the scene, whatever their form for err. May be
    /// empty.
    std::function<void(Stream, std::string_view plain)> heard;
    /// Receives each diagnostic of a scene or of its options as data. May be empty.
    std::function<void(const Diagnostic&, const SourceStore&)> diagnosed = {};
    /// Receives the completed fraction of a rendering, 0 to 1. Called by several threads; may be
    /// empty.
    std::function<void(double fraction)> progressed = {};
    bool terminal = false;  ///< err can rewrite its line
    bool coloured = false;
    std::string library;                            ///< folder of the standard library; empty: none
    std::vector<std::string> first_libraries = {};  ///< folders that come before it
    std::string povray_library;  ///< folder of POV-Ray's include files; empty: not installed
    Interrupts interrupts;       ///< requests by signals
    Environment environment;     ///< variables; empty: none
    /// The text of the scene `-`; unset: that of standard input.
    std::optional<std::string> text = {};
    std::string text_name = "standard input";  ///< of this text in messages
    /// Whether the process does nothing but this run, so that its memory may be limited.
    bool owns_process = true;
    /// Confines the process to these rules; returns false if the system cannot. If empty, the
    /// process is not confined.
    std::function<bool(const SandboxRules&)> confine;
    /// `preview` takes over the rendering of the scene for display, and no picture is written.
    /// `files_read` receives the files that the scene is made from. Both may be empty.
    std::function<void(const ReadyScene&)> preview;
    std::function<void(const std::vector<ReadFile>&)> files_read;
    /// Receives each finished picture before it is written. May be empty.
    std::function<void(const FinishedPicture&)> finished = {};
    /// Hooks by which several runs take turns; all may be empty. The first is called before
    /// rendering, which it prevents by returning false. The second is called once when the
    /// rendering may leave cores idle (not with a time limit), the last between rendering and
    /// writing.
    std::function<bool()> begins_rendering;
    std::function<void()> winds_down;
    std::function<void()> ends_rendering;
    std::shared_ptr<MadeFiles> made_files;  ///< by the scene in all pictures of the run
    std::string settings;  ///< INI file that is read before the command line; empty: none
};

/// Outputs a text to a stream.
void say(const Console&, Stream, std::string_view text, std::string_view plain);
inline void say(const Console& console, Stream stream, std::string_view text) {
    say(console, stream, text, text);
}
void say(const Console&, const Options&, const Diagnostic&, const SourceStore&);

/// Writes all diagnostics to the console in the format that the options select.
void say_errors(const Console&, const Options&, const Diagnostics&);

}  // namespace candelabra
