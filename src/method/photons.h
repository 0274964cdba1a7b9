// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's `photons` blocks: light that gets to surfaces by way of mirrors and glass. Photons are
// shot in generations, each of them anew, so that words about one map and about its search have
// little meaning here.
#pragma once

#include "vocabulary/item_info.h"

#include <cstdint>
#include <string>

namespace candelabra {

/// Of the scene: in global_settings.
struct PhotonSettings {
    double count = 0;          ///< of photons in a generation; 0 and less: by `spacing`
    double spacing = 0;        ///< mean distance of photons on a target; 0 and less: by `count`
    double gather = 20;        ///< has no effect
    double gather_most = 100;  ///< photons within the first radius, about
    double radius = 0;         ///< the first radius; 0 and less: by `gather`
    double radius_more = 0, media_radius = 0, media_radius_more = 0;
    /// Surfaces that a photon may meet, and the least share that it is worth; unset: as of rays.
    std::optional<double> max_trace_level = {}, adc_bailout = {};
    double media = 0;
    double media_factor = 1;
    double jitter = 0.4, autostop = 0;
    double expand_thresholds = 0.2, expand_most = 40;
    std::string save_file = {}, load_file = {};
    bool on = false;  ///< the block is there

    static const ItemInfo vocabulary;

    /// Whether it says how many photons there are.
    bool shoots() const { return on && (count > 0 || spacing > 0); }
};

/// What is said of a way of light.
enum class PhotonWay : std::uint8_t { unsaid, off, on };

/// Whether photons go that way, by what the light and the object say.
constexpr bool is_open(PhotonWay light, PhotonWay object) {
    const bool on = light == PhotonWay::on || object == PhotonWay::on;
    return on && light != PhotonWay::off && object != PhotonWay::off;
}

/// What a light or an object says of both ways.
struct PhotonWays {
    PhotonWay reflection = PhotonWay::unsaid, refraction = PhotonWay::unsaid;

    friend bool operator==(const PhotonWays&, const PhotonWays&) = default;
};

/// Whether photons go any of both ways.
constexpr bool any_open(const PhotonWays& light, const PhotonWays& object) {
    return is_open(light.reflection, object.reflection) ||
           is_open(light.refraction, object.refraction);
}

/// Of an object.
struct ObjectPhotons {
    std::optional<double> target = {};  ///< factor of the spacing, if above 0; unset: no target
    std::optional<double> reflection = {}, refraction = {};
    bool collect = true;        ///< it shows light that photons bring
    bool pass_through = false;  ///< photons pass it in a straight line

    static const ItemInfo vocabulary;

    PhotonWays ways() const;
    friend bool operator==(const ObjectPhotons&, const ObjectPhotons&) = default;
};

/// Of a light source.
struct LightPhotons {
    std::optional<double> reflection = {}, refraction = {};
    bool area_light = false;  ///< photons start from all of its grid

    static const ItemInfo vocabulary;

    PhotonWays ways() const;
};

}  // namespace candelabra
