// SPDX-License-Identifier: GPL-3.0-or-later
// A room with lamps, and the settings for reflected luminaires in it.
#pragma once

#include <string>

namespace candelabra {

/// Settings with that number of light paths and of bounces.
inline std::string with_reflected(int paths, int bounces) {
    return "#version 3.7; global_settings { max_trace_level 12 integrator { path_traced { "
           "bounces " +
           std::to_string(bounces) + " reflected_luminaires " + std::to_string(paths) +
           " } } } #default { finish { ambient 0 diffuse 1 } }\n";
}

inline const std::string lamps_in_room = R"(
    #for (I, 0, 3) sphere { <I - 1.5, 2.6, 0.5>, 0.15 pigment { rgb 1 }
        finish { diffuse 0 emission <9, 7, 4> } } #end )";
inline const std::string bare_room = R"(
    box { <-3, 0, -3>, <3, 3, 3> pigment { rgb <0.8, 0.7, 0.6> } }
    box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <0.3, 0.4, 0.8> } } )";
/// The same room with air in it, which may be foggy.
inline const std::string hollow_room = R"(
    box { <-3, 0, -3>, <3, 3, 3> hollow pigment { rgb <0.8, 0.7, 0.6> } }
    box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <0.3, 0.4, 0.8> } } )";

}  // namespace candelabra
