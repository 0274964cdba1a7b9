// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/falloff.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Boxed::vocabulary = described<Boxed>([] {
    return schema<Boxed>("boxed", {"1 at the origin, 0 from the faces of a cube of side 2 on.",
                                   "pigment { boxed scale 0.8 }"});
});

const ItemInfo PlanarPattern::vocabulary = described<PlanarPattern>([] {
    return schema<PlanarPattern>(
        "planar", {"1 on the plane y = 0, 0 at distance 1 and beyond.", "pigment { planar }"});
});

const ItemInfo CylindricalPattern::vocabulary = described<CylindricalPattern>([] {
    return schema<CylindricalPattern>(
        "cylindrical",
        {"1 on the y axis, 0 at distance 1 and beyond.", "pigment { cylindrical rotate 90*x }"});
});

const ItemInfo SphericalPattern::vocabulary = described<SphericalPattern>([] {
    return schema<SphericalPattern>(
        "spherical", {"1 at the origin, 0 at distance 1 and beyond.", "pigment { spherical }"});
});

namespace {

double fallen(double distance) { return std::fmax(0, 1 - distance); }

}  // namespace

double evaluate(const Boxed&, const Vec3& point) { return fallen(max_abs_component(point)); }

double evaluate(const PlanarPattern&, const Vec3& point) { return fallen(std::abs(point.y)); }

double evaluate(const CylindricalPattern&, const Vec3& point) {
    return fallen(std::sqrt(point.x * point.x + point.z * point.z));
}

double evaluate(const SphericalPattern&, const Vec3& point) { return fallen(length(point)); }

}  // namespace candelabra
