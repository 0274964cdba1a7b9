// SPDX-License-Identifier: GPL-3.0-or-later
// Reports the progress of a rendering to people and programs. On a terminal one line is rewritten;
// elsewhere lines are written at intervals. Thread-safe. Clock and output are parameters, so that
// it can be tested.
#pragma once

#include "options/progress_style.h"

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace candelabra {

class Progress {
public:
    using Style = ProgressStyle;
    using Share = ProgressShare;
    using Seconds = std::function<double()>;
    using Output = std::function<void(std::string_view)>;
    using Heard = std::function<void(double fraction)>;

    /// `heard`: receives each fraction, whatever the style; several threads call it. May be empty.
    /// `pixels`: those of the picture, of which the style povray speaks.
    Progress(Style style, Seconds clock, Output output, Share share = {0, 1}, Heard heard = {},
             double pixels = 0);

    /// Reports that `fraction` of the work is done. An update that arrives late from another
    /// thread, with a smaller fraction, is ignored.
    void update(double fraction);

    /// Removes the line on a terminal, and reports the final fraction to programs.
    void finish();

private:
    bool worth_showing(double now) const;
    bool for_programs() const { return style_ >= Style::json; }
    void show(double now);

    Style style_;
    Seconds clock_;
    Output output_;
    Share share_;
    Heard heard_;
    double pixels_;
    std::mutex mutex_;
    double start_;
    double shown_at_;
    double shown_ = 0;  ///< fraction when something was last shown
    double fraction_ = 0;
    std::size_t width_ = 0;  ///< of the line on the terminal
};

/// Returns a line for programs, with its newline. `pixels`: those of the picture, for povray.
std::string progress_line(Progress::Style, double fraction, double elapsed, double pixels = 0);

/// "42.0 %, 12 s so far, about 17 s left"
std::string progress_text(double fraction, double elapsed);

/// Formats a time for people: "8.3 s", "42 s", "3 min 20 s", "1 h 02 min".
std::string duration(double seconds);

}  // namespace candelabra
