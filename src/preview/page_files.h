// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the preview in plain HTML, CSS and JavaScript. Its files in src/preview/page are
// embedded into the program by the build (embed.cmake). The page requests /status, which answers
// when there is news, and then /picture; it sends changes by POST. Pan and zoom are local to the
// page, and so survive every change of the scene.
#pragma once

#include <string_view>

namespace candelabra {

/// Placeholders for the token that permits changes (web/request.h), and for the name of the scene.
inline constexpr std::string_view token_place = "TOKEN-OF-THIS-RUN";
inline constexpr std::string_view scene_place = "SCENE-OF-THIS-RUN";

extern const std::string_view preview_page, preview_style, preview_script, preview_icon;

}  // namespace candelabra
