// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that the tasks of a run share: text, Scene, World, Shot. Each step prints its messages,
// and yields nothing after an error.
#pragma once

#include "console/console.h"
#include "options/output.h"
#include "options/shard.h"
#include "output/layers.h"
#include "output/stats.h"
#include "session/session.h"
#include "world/shot.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

class SceneSteps {
public:
    /// All arguments outlive the steps.
    SceneSteps(const Options&, const Console&, Diagnostics&);
    SceneSteps(const SceneSteps&) = delete;
    SceneSteps& operator=(const SceneSteps&) = delete;

    /// Checks the options and the destinations, limits the memory, and reads the scene's text.
    /// Returns exit_status::done, or why nothing can be done. To be called first.
    int open();
    /// The text with what it includes. To be called after open().
    Session& session() { return *session_; }

    /// The scene as it is written, with its errors unprinted.
    Scene evaluated();
    /// The scene, if it has no errors, and the calling program has not stopped the run.
    std::optional<Scene> valid_scene();
    /// Warns of probable mistakes in a scene that is not compiled. Returns whether it goes on.
    bool reviewed(const Scene&);
    /// The world; null after an error.
    SharedWorld compiled(Scene&&, Session::Shutter);
    /// The same, with warnings of probable mistakes.
    SharedWorld reviewed_world(Scene&&, Session::Shutter);
    /// The view of the scene's camera. The world has no error.
    Shot shot(const SharedWorld&);

    /// Prints the new diagnostics. Returns whether there are errors.
    bool say_diagnostics();
    /// Prints a result and the diagnostics. Returns the exit status.
    int print(const std::string&);
    /// Completes and writes the statistics and the list of dependencies, for which `made` is the
    /// path of the result. Returns the exit status.
    int finish(const Shot&, const std::string& made);
    /// Excludes some seconds of waiting from the statistics.
    void leave_out(double seconds) { start_.seconds += seconds; }

    const Options& options() const { return options_; }
    const Console& console() const { return console_; }
    Diagnostics& diagnostics() { return diagnostics_; }
    SourceStore& sources() { return session_ ? session_->sources() : before_; }
    RunStatistics& statistics() { return statistics_; }
    /// The destination of the picture. After compilation of a scene it has the scene's gamma.
    const Output& output() const { return output_; }
    /// The files that are made of the film, as far as the options determine them.
    FilmFiles film_files() const;
    /// The part of the picture that this run makes; unset: the whole picture.
    const std::optional<Shard>& shard() const { return shard_; }

private:
    SharedWorld compiled(Scene&&, Session::Shutter, bool reviewed);
    void read_part();
    void bound_memory() const;
    bool destinations_work();
    bool stopped_by_caller() const;
    SessionSettings session_settings();
    void open_session();
    std::string marked(std::string_view text) const;
    void write_depfile(const std::string& made);

    const Options& options_;
    const Console& console_;
    Diagnostics& diagnostics_;
    Output output_;
    std::optional<Session> session_;  ///< set once the options are known to be valid
    SourceStore before_;              ///< of earlier messages: empty
    bool line_is_open_ = false;       ///< the scene's last output has no newline yet
    std::optional<Shard> shard_;
    std::size_t said_ = 0;
    Phase start_ = time_now();
    RunStatistics statistics_;
};

}  // namespace candelabra
