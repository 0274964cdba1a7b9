// SPDX-License-Identifier: GPL-3.0-or-later
// How far a rendering is, for people and for programs. On a terminal one line that is rewritten,
// elsewhere a line now and then. May be told from several threads; time and output are arguments,
// so that it can be tested.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

class Progress {
public:
    /// The last three are for programs: a JSON object on a line, and what RenderMan's queues and
    /// Open Job Description read.
    enum class Style { silent, lines, terminal, json, alf, openjd };
    using Seconds = std::function<double()>;
    using Output = std::function<void(std::string_view)>;

    /// The share of a whole job that this work is, of which programs hear.
    struct Share {
        double first = 0, last = 1;
    };

    Progress(Style style, Seconds clock, Output output, Share share = {0, 1});

    /// `fraction` of the work is done. What comes late, from another thread, and says less than
    /// before, is left out.
    void update(double fraction);

    /// Takes the line on a terminal away, and tells programs how far it came.
    void finish();

private:
    bool worth_showing(double now) const;
    bool for_programs() const { return style_ >= Style::json; }
    void show(double now);

    Style style_;
    Seconds clock_;
    Output output_;
    Share share_;
    std::mutex mutex_;
    double start_;
    double shown_at_;
    double shown_ = 0;  ///< fraction when something was last shown
    double fraction_ = 0;
    std::size_t width_ = 0;  ///< of the line on the terminal
};

/// The style that `--progress` calls so; nothing for another word.
std::optional<Progress::Style> progress_style(std::string_view name);

/// What a program reads, with the end of its line.
std::string progress_line(Progress::Style, double fraction, double elapsed);

/// "42.0 %, 12 s so far, about 17 s left"
std::string progress_text(double fraction, double elapsed);

/// A time as people say it: "8.3 s", "42 s", "3 min 20 s", "1 h 02 min".
std::string duration(double seconds);

}  // namespace candelabra
