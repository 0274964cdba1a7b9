// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/progress_style.h"

#include <array>
#include <utility>

namespace candelabra {

std::optional<ProgressStyle> progress_style(std::string_view name) {
    using enum ProgressStyle;
    static constexpr auto styles =
        std::array{std::pair{"none", silent}, std::pair{"plain", lines}, std::pair{"json", json},
                   std::pair{"alf", alf}, std::pair{"openjd", openjd},
                   std::pair{"povray", povray}};
    for (const auto& [known, style] : styles)
        if (name == known) return style;
    return std::nullopt;
}

}  // namespace candelabra
