// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/animation.h"

#include "text/ascii.h"
#include "text/message.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>

namespace candelabra {

namespace {

/// Maximum frame step, so that frame numbers do not overflow.
constexpr double max_step = 1e9;

}  // namespace

const ItemInfo AnimationSettings::vocabulary = described<AnimationSettings>([] {
    using F = Field<AnimationSettings>;
    using A = AnimationSettings;
    return schema<A>(
        "animation", "Pictures in a row, each with its own clock.",
        F{"initial_frame", &A::initial_frame, item, "number of the first frame, usually 1"},
        F{"final_frame", &A::final_frame, item,
          "number of the last frame; turns the scene into an animation; below the first frame: "
          "counts downwards"},
        F{"initial_clock", &A::initial_clock, item, "value of clock in the first frame"},
        F{"final_clock", &A::final_clock, item, "value of clock in the last frame"},
        F{"subset_start_frame", &A::subset_start_frame, item,
          "first frame to render; below 1: a fraction of all frames", at_least(0)},
        F{"subset_end_frame", &A::subset_end_frame, item,
          "last frame to render; below 1: a fraction of all frames", at_least(0)},
        F{"frame_step", &A::frame_step, item,
          "step between rendered frames: 5 renders every fifth frame", between(1, max_step)},
        F{"cyclic_animation", &A::cyclic, flag,
          "loops the animation: the frame after the last is the first"},
        F{"skip_existing", &A::skip_existing, flag, "skips frames whose picture file exists"});
});

namespace {

constexpr int max_frames = 1'000'000;

bool whole(const std::optional<double>& number) {
    return !number || (std::floor(*number) == *number && std::abs(*number) <= 1e9);
}

/// All frames of an animation, numbered upwards or backwards.
struct FrameRow {
    int first = 1, last = 1;

    int way() const { return last < first ? -1 : 1; }
    int count() const { return std::abs(last - first) + 1; }
    /// Returns the number of frames before that one; negative before the first.
    std::int64_t before(std::int64_t number) const { return (number - first) * way(); }
    bool has(int number) const { return before(number) >= 0 && before(number) < count(); }

    /// Returns the frame number for a bound of the subset. Precondition: the bound is not negative.
    std::int64_t bound(double given) const {
        if (given >= 1) return static_cast<std::int64_t>(std::min(given, 2e9));
        return first + way() * (static_cast<std::int64_t>(count() * given) - 1);
    }
};

/// Returns the numbers of the frames to render, in order.
std::vector<int> wanted(const FrameRow& row, const AnimationSettings& settings) {
    std::vector<int> numbers;
    std::set<int> taken;
    for (const int number : settings.chosen)
        if (row.has(number) && taken.insert(number).second) numbers.push_back(number);
    if (!settings.chosen.empty()) return numbers;
    const auto index = [&](const std::optional<double>& bound, std::int64_t usual) {
        return bound ? row.before(row.bound(*bound)) : usual;
    };
    const std::int64_t from = std::max<std::int64_t>(0, index(settings.subset_start_frame, 0));
    const std::int64_t to =
        std::min<std::int64_t>(row.count() - 1, index(settings.subset_end_frame, row.count() - 1));
    for (std::int64_t at = from; at <= to; at += settings.frame_step)
        numbers.push_back(static_cast<int>(row.first + row.way() * at));
    return numbers;
}

/// Extracts a whole number of at most 9 digits from the front; nothing if there is none.
std::optional<int> take_whole(std::string_view& text) {
    int number = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failed != std::errc() || std::abs(static_cast<std::int64_t>(number)) > 999'999'999)
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

}  // namespace

std::optional<std::vector<int>> frame_list(std::string_view text) {
    std::vector<int> numbers;
    if (text.ends_with(',')) return std::nullopt;
    do {
        std::string_view part = take_until(text, ",");
        FrameRow row;
        const auto first = take_whole(part);
        if (!first) return std::nullopt;
        row.first = row.last = *first;
        if (part.starts_with('-')) {
            part.remove_prefix(1);
            const auto last = take_whole(part);
            if (!last) return std::nullopt;
            row.last = *last;
        }
        const auto more = static_cast<std::size_t>(std::abs(std::int64_t{row.last} - row.first));
        if (!part.empty() || numbers.size() + more >= max_frames) return std::nullopt;
        for (int i = 0; i < row.count(); ++i) numbers.push_back(row.first + row.way() * i);
    } while (!text.empty());
    return numbers;
}

std::optional<Animation> plan(const AnimationSettings& settings, Diagnostics& diagnostics) {
    const auto refuse = [&](std::string text, std::string help = {}) -> std::optional<Animation> {
        diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
        return std::nullopt;
    };
    if (!settings.initial_frame && !settings.final_frame) {
        if (settings.chosen.empty()) return std::nullopt;
        return refuse("--frames chooses some frames of an animation", "+KFF240");
    }
    if (!whole(settings.initial_frame) || !whole(settings.final_frame))
        return refuse("the number of a frame is a whole number");
    FrameRow row;
    row.first = static_cast<int>(settings.initial_frame.value_or(1));
    row.last = static_cast<int>(settings.final_frame.value_or(row.first));
    if (std::abs(std::int64_t{row.last} - row.first) >= max_frames)
        return refuse(message("an animation has at most ", max_frames, " frames"));

    Animation result;
    const int steps = settings.cyclic ? row.count() : row.count() - 1;
    result.initial_frame = row.first;
    result.final_frame = settings.cyclic ? row.last + row.way() : row.last;
    const int longest = std::max(std::abs(row.first), std::abs(row.last));
    result.digits = static_cast<int>(std::to_string(longest).size());
    if (steps > 0) result.clock_delta = (settings.final_clock - settings.initial_clock) / steps;
    for (const int number : wanted(row, settings)) {
        // Computed from the frame number rather than by adding clock_delta, so that the last clock
        // is exact.
        const double share = steps > 0 ? static_cast<double>(row.before(number)) / steps : 0;
        result.frames.push_back(
            {number,
             settings.initial_clock + share * (settings.final_clock - settings.initial_clock)});
    }
    if (result.frames.empty()) return refuse("no frame of the animation is in the subset");
    return result;
}

std::string numbered(const std::string& path, int frame, int digits) {
    const std::filesystem::path whole(path);
    std::string number = std::to_string(std::abs(frame));
    number.insert(
        0, static_cast<std::size_t>(std::max(0, digits - static_cast<int>(number.size()))), '0');
    const std::string name =
        message(whole.stem().string(), frame < 0 ? "-" : "", number, whole.extension().string());
    return (whole.parent_path() / name).string();
}

}  // namespace candelabra
