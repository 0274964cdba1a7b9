// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the preview: plain HTML, CSS and JavaScript, whose files in src/app/page become a
// part of the program when it is built (embed.cmake). The page asks /status, which answers when
// there is something new, and then takes /picture; what it changes, it sends by POST. Where one
// looks (pan, zoom) is the page's own business, and so outlives every change of the scene.
#pragma once

#include <string_view>

namespace candelabra {

/// Are replaced by the token that the page needs to change something (web/request.h), and by the
/// name of the scene.
inline constexpr std::string_view token_place = "TOKEN-OF-THIS-RUN";
inline constexpr std::string_view scene_place = "SCENE-OF-THIS-RUN";

extern const std::string_view preview_page, preview_style, preview_script, preview_icon;

}  // namespace candelabra
