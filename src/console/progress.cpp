// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/progress.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

constexpr double terminal_interval = 0.2;  ///< seconds between two updates of the line
/// Seconds after which a line is written even without a tenth of progress.
constexpr double line_interval = 10;
constexpr double program_interval = 0.5;
constexpr double shortest_interval = 1;  ///< so that a quick rendering writes no lines

std::string two_digits(long number) { return message(number < 10 ? "0" : "", number); }

}  // namespace

Progress::Progress(Style style, Seconds clock, Output output, Share share, Heard heard,
                   double pixels)
    : style_(style),
      clock_(std::move(clock)),
      output_(std::move(output)),
      share_(share),
      heard_(std::move(heard)),
      pixels_(pixels),
      start_(clock_()),
      shown_at_(start_) {}

bool Progress::worth_showing(double now) const {
    const double passed = now - shown_at_;
    if (style_ == Style::terminal) return passed >= terminal_interval;
    if (for_programs()) return passed >= program_interval;
    return passed >= line_interval ||
           (passed >= shortest_interval && std::floor(fraction_ * 10) > std::floor(shown_ * 10));
}

void Progress::update(double fraction) {
    if (heard_) heard_(fraction);
    if (style_ == Style::silent) return;
    const std::lock_guard lock(mutex_);
    const double now = clock_();
    if (!(fraction >= fraction_)) return;
    fraction_ = std::min(fraction, 1.0);
    if (worth_showing(now)) show(now);
}

void Progress::show(double now) {
    shown_at_ = now;
    shown_ = fraction_;
    if (for_programs()) {
        const Share share = style_ == Style::povray ? Share() : share_;  // the picture alone
        const double part = share.last - share.first;
        return output_(
            progress_line(style_, share.first + part * fraction_, now - start_, pixels_));
    }
    std::string text = progress_text(fraction_, now - start_);
    if (style_ == Style::lines) return output_(text + "\n");
    const std::size_t length = text.size();
    if (length < width_) text.resize(width_, ' ');
    width_ = length;
    output_(message("\r", text));
}

void Progress::finish() {
    const std::lock_guard lock(mutex_);
    if (style_ == Style::terminal && width_ > 0)
        output_(message("\r", std::string(width_, ' '), "\r"));
    width_ = 0;
    if (for_programs() && fraction_ > shown_) show(clock_());
}

std::string progress_line(Progress::Style style, double fraction, double elapsed, double pixels) {
    const double percent = std::floor(fraction * 1000) / 10;
    if (style == Progress::Style::alf)
        return message("ALF_PROGRESS ", std::lround(std::floor(percent)), "%\n");
    if (style == Progress::Style::openjd) return message("openjd_progress: ", percent, "\n");
    if (style == Progress::Style::povray)
        return message("Rendered ", std::lround(std::floor(fraction * pixels)), " of ",
                       std::lround(pixels), " pixels (", std::lround(std::floor(percent)), "%)\n");
    return message("{\"progress\":", std::floor(fraction * 1000) / 1000,
                   ",\"seconds\":", std::floor(elapsed * 1000) / 1000, "}\n");
}

std::string progress_text(double fraction, double elapsed) {
    const long tenths = std::lround(std::floor(fraction * 1000));
    std::string text = message(tenths / 10, '.', tenths % 10, " %, ", duration(elapsed), " so far");
    if (fraction > 0)
        text += message(", about ", duration(elapsed * (1 - fraction) / fraction), " left");
    return text;
}

std::string duration(double seconds) {
    if (!(seconds > 0)) seconds = 0;
    if (seconds < 9.95) {
        const long tenths = std::lround(seconds * 10);
        return message(tenths / 10, '.', tenths % 10, " s");
    }
    const double most = 1e9;
    const long whole = std::lround(std::min(seconds, most));
    if (whole < 100) return message(whole, " s");
    if (whole < 3600) return message(whole / 60, " min ", two_digits(whole % 60), " s");
    return message(whole / 3600, " h ", two_digits(whole / 60 % 60), " min");
}

}  // namespace candelabra
