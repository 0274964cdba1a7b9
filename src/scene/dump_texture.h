// SPDX-License-Identifier: GPL-3.0-or-later
// Writes pigments, normals and their patterns as text that reads back the same, for dump(Scene).
#pragma once

#include "backdrop/rainbow.h"
#include "backdrop/sky_sphere.h"
#include "pattern/use.h"
#include "surface/texture.h"
#include "text/message.h"
#include "vocabulary/kinds.h"
#include "vocabulary/written.h"

#include <string>

namespace candelabra {

/// "pigment { ... }".
std::string dump(const Pigment&);

/// " normal { ... }"; empty for a smooth surface.
std::string dump(const Bump&);

/// "texture { ... }", one for each layer, the lowest first.
std::string dump(const Texture&);

/// "pattern { ... }", as in a function.
std::string dump(const PatternUse&, const Transform&);

/// Written as a line.
std::string dump(const SkySphere&);
std::string dump(const Rainbow&);

/// Writes the active alternative of a variant as "name fields".
template <class Variant>
std::string item_text(Variant alternative) {
    const ItemInfo& info = *Kinds<Variant>::infos[alternative.index()];
    const std::string fields = written_fields(info, Kinds<Variant>::address(alternative));
    return message(info.name, fields.empty() ? "" : " ", fields);
}

std::string colour_text(const Colour&);

}  // namespace candelabra
