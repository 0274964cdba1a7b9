// SPDX-License-Identifier: GPL-3.0-or-later
// Media for tests, from scripts.
#pragma once

#include "support/scripts.h"

#include <string>

namespace candelabra {

/// The one medium of a scene, between the braces of `media { }`.
inline Media media_of(const std::string& words) {
    return scene_of("#version 3.7; media { " + words + " } sphere { 9, 1 }").media.at(0);
}

}  // namespace candelabra
