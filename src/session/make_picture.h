// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the text of a scene to a picture in memory, in one call, for programs that use the
// renderer as a library, and for tests. There is no global state, so several pictures may be made
// at once.
#pragma once

#include "base/image.h"
#include "session/session.h"
#include "transport/light_ledger.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

/// Callbacks while a picture is made. All may be empty.
struct Listener {
    /// Receives each diagnostic when it is found. Without an error there is a picture.
    std::function<void(const Diagnostic&, const SourceStore&)> diagnostic = {};
    std::function<void(std::string_view)> print = {};  ///< output of #debug and its relatives
    /// Receives the completed fraction of the rendering, 0 to 1. Called by several threads.
    std::function<void(double done)> progress = {};
    /// Returns true if the picture is no longer wanted. Called by several threads, also while the
    /// scene is evaluated.
    std::function<bool()> cancelled = {};
};

struct Picture {
    Image image;
    double gamma = 1;     ///< for a file of the picture; see PictureFormat
    bool encoded = true;  ///< likewise
    LightLedger rays;
    std::vector<ReadFile> files;  ///< files that it was made from
};

/// Renders a scene. Returns nothing after an error, or if the listener has cancelled it.
std::optional<Picture> make_picture(const SessionSettings&, const Listener& = {});

}  // namespace candelabra
