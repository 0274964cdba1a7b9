// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's `photons` blocks: light that reaches surfaces by mirrors and glass. Each generation
// shoots its photons anew, so parameters of a single map and its search have little meaning here.
#pragma once

#include "vocabulary/item_info.h"

#include <cstdint>
#include <string>

namespace candelabra {

/// The block in global_settings.
struct PhotonSettings {
    double count = 0;          ///< photons in a generation; not above 0: by `spacing`
    double spacing = 0;        ///< mean distance between photons on a target; not above 0: by
                               ///< `count`
    double gather = 20;        ///< has no effect
    double gather_most = 100;  ///< approximate number of photons within the first radius
    double radius = 0;         ///< the first radius; not above 0: by `gather`
    double radius_more = 0, media_radius = 0, media_radius_more = 0;
    /// Maximum number of surfaces on a photon's path, and its minimum weight; unset: as for rays.
    std::optional<double> max_trace_level = {}, adc_bailout = {};
    double media = 0;
    double media_factor = 1;
    double jitter = 0.4, autostop = 0;
    double expand_thresholds = 0.2, expand_most = 40;
    std::string save_file = {}, load_file = {};
    bool on = false;  ///< the block is present

    static const ItemInfo vocabulary;

    /// Whether the number of photons is given.
    bool shoots() const { return on && (count > 0 || spacing > 0); }
};

/// Setting of a light or object for reflection or refraction.
enum class PhotonWay : std::uint8_t { unsaid, off, on };

/// Whether photons are reflected (or refracted), given the settings of the light and the object.
constexpr bool is_open(PhotonWay light, PhotonWay object) {
    const bool on = light == PhotonWay::on || object == PhotonWay::on;
    return on && light != PhotonWay::off && object != PhotonWay::off;
}

/// Settings of a light or an object.
struct PhotonWays {
    PhotonWay reflection = PhotonWay::unsaid, refraction = PhotonWay::unsaid;

    friend bool operator==(const PhotonWays&, const PhotonWays&) = default;
};

/// Whether photons are reflected or refracted.
constexpr bool any_open(const PhotonWays& light, const PhotonWays& object) {
    return is_open(light.reflection, object.reflection) ||
           is_open(light.refraction, object.refraction);
}

/// The block of an object.
struct ObjectPhotons {
    std::optional<double> target = {};  ///< factor of the spacing, if above 0; unset: no target
    std::optional<double> reflection = {}, refraction = {};
    bool collect = true;        ///< whether it receives the light of photons
    bool pass_through = false;  ///< whether photons pass through it in a straight line

    static const ItemInfo vocabulary;

    PhotonWays ways() const;
    friend bool operator==(const ObjectPhotons&, const ObjectPhotons&) = default;
};

/// The block of a light source.
struct LightPhotons {
    std::optional<double> reflection = {}, refraction = {};
    bool area_light = false;  ///< photons start from its whole grid

    static const ItemInfo vocabulary;

    PhotonWays ways() const;
};

}  // namespace candelabra
