// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sun.h"

#include <string>

namespace candelabra {

std::optional<PlacedLight> sun_of(const std::optional<DaylightSky>& sky, const Span& statement) {
    if (!sky || sky->sunlight() == Rgb(0)) return std::nullopt;
    constexpr double away = 1e7;
    PointLight light;
    light.location = away * sky->sun();
    light.point_at = Vec3(0);
    light.parallel = true;
    light.colour = sky->sunlight();
    light.disc_edge = DaylightSky::sun_edge();
    return PlacedLight{light, statement, {}, {}, {}, make_handle<std::string>("sun")};
}

}  // namespace candelabra
