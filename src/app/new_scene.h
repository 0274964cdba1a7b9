// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra new`: a scene to begin with. The templates are scenes in the folder `templates` of
// the standard library.
#pragma once

#include "console/console.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The template that is taken if none is named.
inline constexpr std::string_view usual_template = "studio";

/// Names of the templates in a standard library, in alphabetical order; none if it has none.
std::vector<std::string> scene_templates(const std::string& library);

/// Writes a copy of a template as a new file. A file that exists is never overwritten.
int new_scene(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
