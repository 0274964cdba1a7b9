// SPDX-License-Identifier: GPL-3.0-or-later
// From the text of a scene to a picture in memory, in one call. For programs that use the renderer
// as a library, and for tests. Nothing is global: several may be made at once.
#pragma once

#include "base/image.h"
#include "session/session.h"
#include "transport/light_ledger.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

/// Who is told while a picture is made. All may be empty.
struct Listener {
    /// What is wrong, in the order in which it is found. Without an error there is a picture.
    std::function<void(const Diagnostic&, const SourceStore&)> diagnostic = {};
    std::function<void(std::string_view)> print = {};  ///< what #debug and its relatives say
    /// The share of the rendering that is done, 0 to 1. Called by several threads.
    std::function<void(double done)> progress = {};
    /// True: no picture is wanted any more. Called by several threads.
    std::function<bool()> cancelled = {};
};

struct Picture {
    Image image;
    double gamma = 1;     ///< see PictureFormat: a file of the picture is to have the same
    bool encoded = true;  ///< the same
    LightLedger rays;
    std::vector<ReadFile> files;  ///< that it was made from
};

/// Nothing when there was an error, or when the listener has cancelled it.
std::optional<Picture> make_picture(const SessionSettings&, const Listener& = {});

}  // namespace candelabra
