// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a scene that users may adjust: names that the scene declares only if they are
// undefined, followed by a comment with the range of their values,
//
//     #ifndef (Height) #declare Height = 2; #end  // 0 to 5 by 0.1: how tall the tree is
//
// so that Declare=Height=3 sets them, and the preview shows a slider for each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct Knob {
    std::string name;
    double value;  ///< the default
    double low, high;
    double step;  ///< a hundredth of the range by default
    std::string help;

    friend bool operator==(const Knob&, const Knob&) = default;
};

/// Returns the knobs in source order. Declarations with empty ranges are ignored.
std::vector<Knob> knobs(std::string_view scene);

}  // namespace candelabra
