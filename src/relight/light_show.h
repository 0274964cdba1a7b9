// SPDX-License-Identifier: GPL-3.0-or-later
// What lamps do in the frames of a show: factors on their light, from options and from files.
#pragma once

#include "base/rgb.h"
#include "relight/lamp_names.h"
#include "text/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// Frames that change the factors of lamps. Factors that a frame does not set stay as they are.
class ShowFrames {
public:
    ShowFrames() = default;
    virtual ~ShowFrames() = default;
    ShowFrames(const ShowFrames&) = delete;
    ShowFrames& operator=(const ShowFrames&) = delete;

    virtual std::size_t count() const = 0;
    /// Sets factors by the places of lamps. `frame` is below count().
    virtual void set(std::size_t frame, std::vector<Rgb>& factors) const = 0;
};

/// Reads a table: its header names lamps and ranges of lamps, each of which has a column for each
/// lamp, and each other row is a frame; or a cue list, with the columns `cue`, `time` and `fade` in
/// seconds, and then cells such as `Facade=0.5`. `rate`: frames a second. Returns nothing after an
/// error has been reported.
std::unique_ptr<ShowFrames> read_show_table(const std::string& path, const LampNames&, double rate,
                                            Diagnostics&);
/// The same for the text of a file.
std::unique_ptr<ShowFrames> show_of_table(std::string_view text, const std::string& path,
                                          const LampNames&, double rate, Diagnostics&);

/// Most frames of a show.
inline constexpr std::size_t most_show_frames = 1'000'000;

class LightShow {
public:
    /// The list must outlive the show.
    explicit LightShow(const LampList& lamps) : names_(lamps) {}

    const LampNames& names() const { return names_; }

    /// Takes `Lamp=VALUE`, for all frames: a number from 0 on, a colour, or both. Returns false
    /// after an error has been reported.
    bool set(std::string_view text, Diagnostics&);
    void set(std::unique_ptr<ShowFrames> frames) { frames_ = std::move(frames); }

    /// Number of frames; 0: one picture that is no frame.
    std::size_t frames() const { return frames_ ? frames_->count() : 0; }
    /// The factors of all lamps by their places; 1 is a lamp as it was rendered.
    std::vector<Rgb> factors(std::size_t frame) const;

private:
    struct Fixed {
        std::vector<std::uint32_t> lamps;
        Rgb factor;
    };

    LampNames names_;
    std::unique_ptr<ShowFrames> frames_;
    std::vector<Fixed> fixed_;
};

}  // namespace candelabra
