// SPDX-License-Identifier: GPL-3.0-or-later
// How far a rendering is, for people. On a terminal one line that is rewritten, elsewhere a line
// now and then. May be told from several threads; time and output are arguments, so that it can be
// tested.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

class Progress {
public:
    enum class Style { silent, lines, terminal };
    using Seconds = std::function<double()>;
    using Output = std::function<void(std::string_view)>;

    Progress(Style style, Seconds clock, Output output);

    /// `fraction` of the work is done. What comes late, from another thread, and says less than
    /// before, is left out.
    void update(double fraction);

    /// Takes the line on a terminal away.
    void finish();

private:
    bool worth_showing(double now) const;

    Style style_;
    Seconds clock_;
    Output output_;
    std::mutex mutex_;
    double start_;
    double shown_at_;
    double shown_ = 0;  ///< fraction when something was last shown
    double fraction_ = 0;
    std::size_t width_ = 0;  ///< of the line on the terminal
};

/// "42.0 %, 12 s so far, about 17 s left"
std::string progress_text(double fraction, double elapsed);

/// A time as people say it: "8.3 s", "42 s", "3 min 20 s", "1 h 02 min".
std::string duration(double seconds);
