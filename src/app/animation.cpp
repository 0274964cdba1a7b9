// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation.h"

#include "text/message.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

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
        F{"initial_frame", &A::initial_frame, item, "number of the first frame (1)"},
        F{"final_frame", &A::final_frame, item,
          "number of the last frame; makes an animation of the scene"},
        F{"initial_clock", &A::initial_clock, item, "clock at the first frame"},
        F{"final_clock", &A::final_clock, item, "clock at the last frame"},
        F{"subset_start_frame", &A::subset_start_frame, item,
          "first frame that is rendered; below 1 a fraction of all", at_least(0)},
        F{"subset_end_frame", &A::subset_end_frame, item,
          "last frame that is rendered; below 1 a fraction of all", at_least(0)},
        F{"frame_step", &A::frame_step, item, "renders every so many frames only",
          between(1, max_step)},
        F{"cyclic_animation", &A::cyclic, flag, "the first frame follows the last one"},
        F{"skip_existing", &A::skip_existing, flag, "leaves out frames whose file is there"});
});

namespace {

constexpr int max_frames = 1'000'000;

/// Returns the frame number for a bound of the subset. Precondition: the bound is not negative.
int subset_frame(double given, int first, int count) {
    if (given >= 1) return static_cast<int>(std::min(given, 2e9));
    return first - 1 + static_cast<int>(std::trunc(count * given));
}

bool whole(const std::optional<double>& number) {
    return !number || (std::floor(*number) == *number && std::abs(*number) <= 1e9);
}

}  // namespace

std::optional<Animation> plan(const AnimationSettings& settings, Diagnostics& diagnostics) {
    if (!settings.initial_frame && !settings.final_frame) return std::nullopt;
    const auto refuse = [&](std::string text) -> std::optional<Animation> {
        diagnostics.add(error(Fault::option, {}, std::move(text)));
        return std::nullopt;
    };
    if (!whole(settings.initial_frame) || !whole(settings.final_frame))
        return refuse("the number of a frame is a whole number");
    const int first = static_cast<int>(settings.initial_frame.value_or(1));
    const int last = static_cast<int>(settings.final_frame.value_or(first));
    if (last < first)
        return refuse(message("the last frame, ", last, ", comes before the first, ", first));
    if (last - first >= max_frames)
        return refuse(message("an animation has at most ", max_frames, " frames"));

    Animation result;
    const int count = last - first + 1;
    const int steps = settings.cyclic ? count : count - 1;
    result.initial_frame = first;
    result.final_frame = settings.cyclic ? last + 1 : last;
    result.digits = static_cast<int>(std::to_string(std::max(std::abs(first), last)).size());
    if (steps > 0) result.clock_delta = (settings.final_clock - settings.initial_clock) / steps;
    const int from = std::max(first, settings.subset_start_frame
                                         ? subset_frame(*settings.subset_start_frame, first, count)
                                         : first);
    const int to = std::min(last, settings.subset_end_frame
                                      ? subset_frame(*settings.subset_end_frame, first, count)
                                      : last);
    // 64 bits, since the loop variable may step beyond the range of int.
    for (std::int64_t at = from; at <= to; at += settings.frame_step) {
        const int number = static_cast<int>(at);
        // Computed from the frame number rather than by adding clock_delta, so that the last clock
        // is exact.
        const double share = steps > 0 ? static_cast<double>(number - first) / steps : 0;
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
