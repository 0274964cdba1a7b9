// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/finish.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Reflection::vocabulary = described<Reflection>([] {
    using F = Field<Reflection>;
    return schema<Reflection>(
        "reflection",
        {"Mirror reflection, from straight on to grazing.", "finish { reflection 0.4 }",
         "finish { reflection { 0, 1 falloff 4 } }",
         "finish { reflection { 0.8 metallic } diffuse 0.3 }",
         "finish { reflection { 0.7 exponent 2 } diffuse 0.3 }",
         "finish { reflection { 0, 1 fresnel } }",
         "finish { reflection 0.5 reflection_exponent 1 }"},
        F{"minimum", &Reflection::least, positional, "amount seen straight on"},
        maybe(F{"maximum", &Reflection::greatest, positional,
                "amount at grazing angles; the minimum when left out"}),
        F{"fresnel", &Reflection::fresnel, flag,
          "amount by Fresnel's equations and the interior's ior"},
        F{"falloff", &Reflection::falloff, item, "exponent of the change with the angle"},
        F{"exponent", &Reflection::exponent, item, "dims dark reflections more than bright ones",
          above(0)},
        F{"metallic", &Reflection::metallic, item, "tints the reflection with the pigment"});
});

const ItemInfo Irid::vocabulary = described<Irid>([] {
    using F = Field<Irid>;
    return schema<Irid>("irid",
                        {"Colours as of a film of oil, which change with the angle.",
                         "finish { irid { 0.5 thickness 0.6 } }",
                         "finish { irid { 0.5 thickness 0.6 turbulence 0.2 } }"},
                        F{"amount", &Irid::amount, positional, "how strongly light is tinted"},
                        F{"thickness", &Irid::thickness, item, "of the film"},
                        F{"turbulence", &Irid::turbulence, item,
                          "how much the thickness differs from place to place"});
});

const ItemInfo Microfacet::vocabulary = described<Microfacet>([] {
    using F = Field<Microfacet>;
    return schema<Microfacet>(
        "microfacet",
        {"Scatters light as small facets do; the pigment is the base colour.",
         "finish { microfacet { roughness 0.1 metallic 1 } }",
         "finish { microfacet { roughness 0.3 metallic 1 } }",
         "finish { microfacet { roughness 0.6 metallic 1 } }",
         "finish { microfacet { roughness 0.4 } }",
         "finish { microfacet { roughness 0.9 specular 0.5 } }",
         "finish { microfacet { roughness 0.6 coat 1 coat_roughness 0.05 } }"},
        F{"roughness", &Microfacet::roughness, item, "0: a mirror, 1: dull", between(0, 1)},
        F{"metallic", &Microfacet::metallic, item,
          "1: a metal, which reflects with its base colour", between(0, 1)},
        F{"specular", &Microfacet::specular, item,
          "of what is no metal: 8 % of this are reflected straight on", between(0, 1)},
        F{"coat", &Microfacet::coat, item, "strength of a clear coat above", between(0, 1)},
        F{"coat_roughness", &Microfacet::coat_roughness, item,
          "roughness of the coat, from 0 for a mirror to 1", between(0, 1)});
});

const ItemInfo Finish::vocabulary = described<Finish>([] {
    using F = Field<Finish>;
    return schema<Finish>(
        "finish",
        {"How a surface answers light.", "finish { diffuse 0.9 }",
         "finish { ambient 0.6 diffuse 0.3 }", "finish { brilliance 4 }",
         "finish { phong 0.9 phong_size 60 }", "finish { specular 0.9 roughness 0.02 }",
         "finish { specular 0.8 roughness 0.05 metallic }", "finish { crand 0.3 }",
         "finish { emission 0.7 diffuse 0.2 }", "finish { diffuse 0.4, 0.6 }",
         "finish { emission 0.7 no_luminaire }",
         "finish { diffuse albedo 0.5 specular albedo 0.3 }",
         "finish { reflection 0.4 conserve_energy use_alpha }",
         "finish { refraction 1 ior 1.3 caustics 0.5 }"},
        F{"ambient", &Finish::ambient, item,
          "share of ambient_light that it seems to reflect everywhere"},
        F{"emission", &Finish::emission, item,
          "radiance that it emits, times the pigment: makes it a luminaire"},
        F{"no_luminaire", &Finish::no_luminaire, flag,
          "glows where it is seen, but lights nothing: no shadow rays are sent to it"},
        F{"diffuse", &Finish::diffuse, item,
          "share of the light that it scatters in all directions, times the pigment"},
        maybe(
            F{"diffuse_back", &Finish::diffuse_back, following,
              "how much light from behind is scattered: the transmitted counterpart of `diffuse`"}),
        F{"brilliance", &Finish::brilliance, item,
          "exponent of the cosine of the light's angle in diffuse scattering"},
        F{"phong", &Finish::phong, item, "strength of the Phong highlight"},
        F{"phong_size", &Finish::phong_size, item,
          "exponent of the Phong highlight: greater is smaller"},
        F{"specular", &Finish::specular, item, "strength of the Blinn highlight"},
        F{"roughness", &Finish::roughness, item,
          "width of the Blinn highlight: its exponent is 1/roughness", above(0)},
        F{"metallic", &Finish::metallic, item,
          "tints highlights with the pigment; 1 when no number follows"},
        F{"crand", &Finish::crand, item, "graininess: largest random change of diffuse light"},
        F{"use_alpha", &Finish::use_alpha, flag,
          "reflection, phong and specular fade as the pigment becomes clear (POV-Ray 3.8)"},
        F{"conserve_energy", &Finish::conserve_energy, flag,
          "what is reflected does not also pass through"},
        F{"ior", &Finish::ior, item, "index of refraction, as scenes before version 3.1 have it",
          at_least(0)},
        F{"caustics", &Finish::caustics, item,
          "exponent of bright spots in shadows, instead of the interior's, as old"},
        F{"refraction", &Finish::refraction, item, "share of what is seen through it, as old",
          at_least(0)});
});

}  // namespace candelabra
