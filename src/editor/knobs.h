// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a scene that users may adjust: names that the scene declares only if they are
// undefined, followed by a comment that says what they may be,
//
//     // [Tree]
//     #ifndef (Height) #declare Height = 2; #end         // 0 to 5 by 0.1: how tall it is
//     #ifndef (Snow) #declare Snow = 1; #end             // on or off
//     #ifndef (Kind) #declare Kind = "fir"; #end         // one of "fir", "oak"
//     #ifndef (Sign) #declare Sign = "Hello"; #end       // text: on the sign
//     #ifndef (Tint) #declare Tint = rgb <1, 0.5, 0>; #end  // colour
//     #ifndef (Place) #declare Place = <0, 0, 1>; #end   // -5 to 5: where it stands
//
// so that Declare=Height=3 sets them, and the preview shows a widget for each.
#pragma once

#include "interpret/value.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace candelabra {

/// A number, a text, or the numbers of a vector or a colour.
using KnobValue = std::variant<double, std::string, Numbers>;

struct Knob {
    enum class Kind {
        slider,  ///< a number in the range
        toggle,  ///< 0 or 1
        list,    ///< one of the choices
        text,
        colour,  ///< from 0 on
        vector,  ///< each number in the range
    };

    std::string name;
    KnobValue value;  ///< the default
    Kind kind = Kind::slider;
    double low = 0, high = 0;
    double step = 0;                      ///< a hundredth of the range by default
    std::vector<KnobValue> choices = {};  ///< of the type of the default
    std::string help = {};
    std::string section = {};  ///< the last comment `// [Section]` before it

    friend bool operator==(const Knob&, const Knob&) = default;
};

/// Returns the knobs in source order. Declarations with empty ranges are ignored.
std::vector<Knob> knobs(std::string_view scene);

/// Returns the value that a text of the page states for the knob: numbers with commas between, or
/// the text itself. Numbers outside the range become its bounds; nothing for what the knob cannot
/// be.
std::optional<KnobValue> knob_value(const Knob&, std::string_view stated);

/// Returns the knob for a page that shows a widget for it: name, kind, low, high, step, choices,
/// help, section, and the value.
nlohmann::json json_of(const Knob&, const KnobValue&);

}  // namespace candelabra
