// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/photons.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo PhotonSettings::vocabulary = described<PhotonSettings>([] {
    using F = Field<PhotonSettings>;
    constexpr const char* of_map = "of POV-Ray's map; no effect, as none is kept";
    return schema<PhotonSettings>(
        "photons",
        {"Lets light reach surfaces by way of mirrors and glasses that are targets. Photons are "
         "shot anew for some samples at a time, and looked for in ever smaller circles, so that "
         "more samples make the light quieter and sharper.",
         "global_settings { photons { count 2000 } }",
         "global_settings { photons { spacing 0.1 gather 20, 60 radius 0.2 media 10, 2 jitter 0.4 "
         "autostop 0 expand_thresholds 0.2, 40 max_trace_level 5 adc_bailout 0.01 } }"},
        F{"count", &PhotonSettings::count, item,
          "photons that are shot at a time, at most 262144; or by `spacing`"},
        F{"spacing", &PhotonSettings::spacing, item, "mean distance of photons on a target"},
        F{"gather", &PhotonSettings::gather, item,
          "no effect: few photons light small circles, too", at_least(0)},
        F{"gather_most", &PhotonSettings::gather_most, following,
          "photons that the first circles hold, about", at_least(0)},
        F{"radius", &PhotonSettings::radius, item,
          "radius of the first circles; 0 or less: by `gather`"},
        maybe(F{"radius_more", &PhotonSettings::radius_more, following, "no effect"}),
        maybe(F{"media_radius", &PhotonSettings::media_radius, following,
                "the first radius in media; 0: by `gather`"}),
        maybe(F{"media_radius_more", &PhotonSettings::media_radius_more, following, "no effect"}),
        F{"max_trace_level", &PhotonSettings::max_trace_level, item,
          "surfaces that a photon may meet, the last one included; unset: as many as rays",
          between(0, 300)},
        F{"adc_bailout", &PhotonSettings::adc_bailout, item,
          "photons that are worth less of what they were are dropped; unset: as rays"},
        F{"media", &PhotonSettings::media, item,
          "photons on each part of a way through media; 0: these are dark behind targets"},
        maybe(F{"media_factor", &PhotonSettings::media_factor, following, "no effect"}),
        F{"jitter", &PhotonSettings::jitter, item, of_map},
        F{"autostop", &PhotonSettings::autostop, item, of_map},
        F{"expand_thresholds", &PhotonSettings::expand_thresholds, item, of_map},
        F{"expand_most", &PhotonSettings::expand_most, following, "no effect"},
        F{"save_file", &PhotonSettings::save_file, item, of_map},
        F{"load_file", &PhotonSettings::load_file, item, of_map});
});

namespace {

constexpr const char* of_reflection =
    "photons are reflected; off unless the object or the light switches it on";
constexpr const char* of_refraction =
    "photons go through, and no other light does; off unless the object or the light switches it "
    "on";

PhotonWay way(const std::optional<double>& said) {
    if (!said) return PhotonWay::unsaid;
    return *said > 0 ? PhotonWay::on : PhotonWay::off;
}

}  // namespace

const ItemInfo ObjectPhotons::vocabulary = described<ObjectPhotons>([] {
    using F = Field<ObjectPhotons>;
    return schema<ObjectPhotons>(
        "photons",
        {"What photons do at an object. Luminaires shoot at targets with `on`.",
         "sphere { y, 1 pigment { rgbt 0.9 } interior { ior 1.5 } photons { target reflection on "
         "refraction on } }",
         "sphere { y, 1 photons { target on reflection off collect off pass_through } }"},
        F{"target", &ObjectPhotons::target, item,
          "photons are shot at it; a number above 0 multiplies their spacing"},
        F{"reflection", &ObjectPhotons::reflection, item, of_reflection},
        F{"refraction", &ObjectPhotons::refraction, item, of_refraction},
        F{"collect", &ObjectPhotons::collect, flag, "`off`: it is lit as if there were no photons"},
        F{"pass_through", &ObjectPhotons::pass_through, flag,
          "photons pass it without being bent"});
});

const ItemInfo LightPhotons::vocabulary = described<LightPhotons>([] {
    using F = Field<LightPhotons>;
    return schema<LightPhotons>(
        "photons",
        {"Whether a light shoots photons at targets.",
         "light_source { <-2, 4, -3>, rgb 1 photons { reflection on refraction on } }",
         "light_source { <-2, 4, -3>, rgb 1 area_light x, z, 3, 3 photons { area_light } }"},
        F{"reflection", &LightPhotons::reflection, item, of_reflection},
        F{"refraction", &LightPhotons::refraction, item, of_refraction},
        F{"area_light", &LightPhotons::area_light, flag,
          "photons start from all of the light's grid"});
});

PhotonWays ObjectPhotons::ways() const { return {way(reflection), way(refraction)}; }

PhotonWays LightPhotons::ways() const { return {way(reflection), way(refraction)}; }

}  // namespace candelabra
