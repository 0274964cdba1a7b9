// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a lamp in numbers, as its data sheet does: `luminaire { ... }` of a finish or an
// object. The radiance of its surface follows when its place and size are known (world).
#pragma once

#include "base/rgb.h"
#include "photometry/aimed_web.h"
#include "vocabulary/item_info.h"

#include <optional>

namespace candelabra {

struct LampData : WebPlace {
    std::optional<double> flux;         ///< in units of LightUnits; unset: that of the web, if any
    std::optional<double> temperature;  ///< of the light's colour in kelvin, on Planck's locus

    static const ItemInfo vocabulary;

    /// Whether its radiance follows from its flux.
    bool has_flux() const { return flux || web; }
    /// In units of LightUnits. Precondition: has_flux().
    double total_flux() const {
        return flux ? *flux : web->flux() * per_candela * tilt_factor(*this);
    }
    friend bool operator==(const LampData&, const LampData&) = default;
};

/// The emission of a finish of that lamp, up to a factor: white if it had none.
Rgb lamp_emission(const LampData&, const Rgb& emission);

}  // namespace candelabra
