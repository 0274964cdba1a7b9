// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/subsurface.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <cmath>
#include <numbers>

namespace candelabra {

const ItemInfo Subsurface::vocabulary = described<Subsurface>([] {
    return schema<Subsurface>(
        "subsurface",
        {"Light that goes in at one point of the surface and comes out at others.",
         "finish { diffuse 0.9 subsurface { translucency 3 } }"},
        Field<Subsurface>{
            "translucency", &Subsurface::translucency, item,
            "how far light gets between two scatterings, in millimetres; see mm_per_unit"});
});

const ItemInfo SubsurfaceSettings::vocabulary = described<SubsurfaceSettings>([] {
    using F = Field<SubsurfaceSettings>;
    return schema<SubsurfaceSettings>(
        "subsurface",
        {"Has finishes with subsurface scatter light inside of their objects.",
         "global_settings { subsurface { samples 50, 50 } }"},
        F{"samples", &SubsurfaceSettings::samples, item,
          "points of the surface where light may go in, for each point that is seen",
          between(0, 1e6)},
        maybe(F{"single_samples", &SubsurfaceSettings::single_samples, following,
                "places below that point where light may be scattered once", between(0, 1e6)}));
});

namespace {

/// Internal diffuse reflectance of the surface, by POV-Ray's fit.
double inner_reflectance(double ior) {
    const double x = 1 - 1 / ior;
    return (x + 3 * math::pow(x, 4.5)) / 4;
}

/// Diffuse reflectance of a half space of this reduced albedo.
double given_back(double albedo, double boundary) {
    const double root = std::sqrt(3 * (1 - albedo));
    return 0.5 * albedo * (1 + math::exp(-4.0 / 3.0 * boundary * root)) * math::exp(-root);
}

/// Reduced albedo of a half space with this diffuse reflectance, which grows with it.
double reduced_albedo(double wanted, double boundary) {
    double low = 0, high = 1;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        (given_back(middle, boundary) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

Dipole::Dipole(const Rgb& albedo, const Rgb& free_path, double ior) {
    const double inner = inner_reflectance(std::fmax(ior, 1));
    const double boundary = (1 + inner) / (1 - inner);
    for (int channel = 0; channel < 3; ++channel) {
        const double wanted = std::clamp(albedo[channel], 1e-6, 1 - 1e-6);
        albedo_[channel] = reduced_albedo(wanted, boundary);
    }
    scattering_ = Rgb(1) / free_path;
    extinction_ = scattering_ / albedo_;
    falloff_ = sqrt(3.0 * (extinction_ - scattering_) * extinction_);
    real_ = Rgb(1) / extinction_;
    virtual_ = real_ * (1 + 4.0 / 3.0 * boundary);
}

Rgb Dipole::spread(double distance2) const {
    const auto source = [&](const Rgb& height) {
        const Rgb way2 = height * height + Rgb(distance2), way = sqrt(way2);
        return height * (Rgb(1) + falloff_ * way) * math::exp(-falloff_ * way) / (way2 * way);
    };
    return albedo_ / (4 * std::numbers::pi) * (source(real_) + source(virtual_));
}

}  // namespace candelabra
