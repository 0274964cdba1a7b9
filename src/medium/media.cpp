// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/media.h"

#include "base/work_watch.h"
#include "surface/pigment_map.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

const ItemInfo Scattering::vocabulary = described<Scattering>([] {
    using F = Field<Scattering>;
    return schema<Scattering>(
        "scattering",
        {"How much light a medium scatters, and where to.", "media { scattering { 1, 0.05 } }",
         "media { scattering { 5, 0.05 eccentricity 0.6 extinction 0.5 } }",
         "media { scattering { 1, 0.05 multiple } }"},
        F{"type", &Scattering::type, positional,
          "1: to all sides, 2: haze, 3: murky air, 4: as the sky does (Rayleigh), 5: by its "
          "eccentricity (Henyey and Greenstein)",
          between(1, 5)},
        F{"colour", &Scattering::colour, positional,
          "light that is scattered along one unit of length"},
        F{"extinction", &Scattering::extinction, item,
          "how much of what is scattered is missing behind; 0: nothing"},
        F{"eccentricity", &Scattering::eccentricity, item,
          "of type 5: above 0 forward, below 0 back, 0 to all sides", between(-1, 1)},
        F{"multiple", &Scattering::multiple, flag,
          "where paths are traced, what is scattered is scattered again"});
});

const ItemInfo Media::vocabulary = described<Media>([] {
    using F = Field<Media>;
    return schema<Media>(
        "media",
        {"What absorbs, emits and scatters light between surfaces.", "media { absorption 0.1 }",
         "media { emission 0.05 density { bozo scale 2 } }",
         "media { scattering { 1, 0.05 } method 3 intervals 1 samples 2, 6 jitter 0.5 }",
         "media { emission 0.05 method 3 aa_level 3 aa_threshold 0.1 confidence 0.9 variance 1/128 "
         "ratio 0.9 }",
         "media { scattering { 1, 0.05 } collect on }"},
        F{"absorption", &Media::absorption, item, "light that is lost along one unit of length"},
        F{"emission", &Media::emission, item, "light that is added along one unit of length"},
        F{"method", &Media::method, item, "POV-Ray's way of sampling; without effect",
          between(1, 3)},
        F{"intervals", &Media::intervals, item, "effort: as POV-Ray divides a ray", at_least(1)},
        F{"samples", &Media::samples, item, "effort: points along a ray for each interval",
          at_least(1)},
        maybe(F{"max_samples", &Media::max_samples, following, "effort: at most so many",
                at_least(0)}),
        F{"aa_level", &Media::aa_level, item, "of POV-Ray's sampling; without effect", at_least(1)},
        F{"aa_threshold", &Media::aa_threshold, item, "of POV-Ray's sampling; without effect",
          above(0)},
        F{"confidence", &Media::confidence, item, "of POV-Ray's sampling; without effect",
          between(0, 1)},
        F{"variance", &Media::variance, item, "of POV-Ray's sampling; without effect", at_least(0)},
        F{"ratio", &Media::ratio, item, "of POV-Ray's sampling; without effect", at_least(0)},
        F{"jitter", &Media::jitter, item, "of POV-Ray's sampling; without effect"},
        F{"collect", &Media::collect, flag,
          "shows light that photons bring, not what comes straight through targets"});
});

namespace {

double powered(double base, int squarings) {
    for (int i = 0; i < squarings; ++i) base *= base;
    return base;
}

}  // namespace

double phase(const Scattering& scattering, double cosine) {
    const double forward = (1 + cosine) / 2;
    switch (static_cast<PhaseKind>(scattering.type)) {
        case PhaseKind::mie_haze:
            return 0.576655 * (1 + 9 * powered(forward, 3));
        case PhaseKind::mie_murky:
            return 0.495715 * (1 + 50 * powered(forward, 5));
        case PhaseKind::rayleigh:
            return 0.799372 * (1 + cosine * cosine);
        case PhaseKind::henyey_greenstein: {
            const double g = scattering.eccentricity;
            const double below = 1 + g * g - 2 * g * cosine;
            return below > 0 ? (1 - g * g) / (below * std::sqrt(below)) : 0;
        }
        case PhaseKind::isotropic:
            break;
    }
    return 1;
}

double mean_phase(const Scattering& s) {
    switch (static_cast<PhaseKind>(s.type)) {
        case PhaseKind::mie_haze:
            return 0.576655 * 2;
        case PhaseKind::mie_murky:
            return 0.495715 * (1 + 50.0 / 33);
        case PhaseKind::rayleigh:
            return 0.799372 * 4 / 3;
        case PhaseKind::henyey_greenstein:
            return std::abs(s.eccentricity) < 1 ? 1 : 0;
        case PhaseKind::isotropic:
            break;
    }
    return 1;
}

double unit_of_light(const Scattering& scattering) {
    if (!scattering.physical) return 1;
    const double mean = mean_phase(scattering);
    return mean > 0 ? 0.25 / mean : 0;
}

bool Media::homogeneous() const {
    return std::ranges::none_of(densities, [](const Pigment& d) { return d.pattern != nullptr; });
}

Media transformed(Media media, const Transform& transform) {
    for (Pigment& each : media.densities) each.transform = each.transform.then(transform);
    return media;
}

Rgb density(const Media& media, const Vec3& point, const PatternScene& scene) {
    Rgb product(1);
    count_work(1);
    for (const Pigment& each : media.densities) product *= evaluate(each, point, scene).rgb;
    return product;
}

Rgb max_density(const Media& media) {
    Rgb product(1);
    for (const Pigment& each : media.densities) product *= max(brightest(each), Rgb(0));
    return product;
}

MediumPoint coefficients(MediaView media, const Vec3& point, const PatternScene& scene,
                         LightInAir light) {
    MediumPoint sum;
    for (const Media* each : media) {
        const Rgb here = density(*each, point, scene);
        sum.extinction += here * each->extinction();
        (each->luminaire ? sum.luminaires : sum.emission) += here * each->emission;
        if (each->scatters(light)) sum.scattering += here * each->scattering.colour;
    }
    return sum;
}

Rgb scattered(MediaView media, const Vec3& point, const PatternScene& scene, double cosine) {
    Rgb sum(0);
    for (const Media* each : media)
        if (each->scatters())
            sum += density(*each, point, scene) * each->scattering.colour *
                   (phase(each->scattering, cosine) * unit_of_light(each->scattering));
    return sum;
}

}  // namespace candelabra
