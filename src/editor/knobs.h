// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene lets people turn: names that it declares only where nobody else has, with the range
// of their values in a comment behind,
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
    double value;  ///< when nobody says anything
    double low, high;
    double step;  ///< a hundredth of the range when none is given
    std::string help;

    friend bool operator==(const Knob&, const Knob&) = default;
};

/// In the order of the text. Ranges that are empty make none.
std::vector<Knob> knobs(std::string_view scene);

}  // namespace candelabra
