// SPDX-License-Identifier: GPL-3.0-or-later
// The light that arrives in a cell, as a picture of few pixels: the luminance seen from there in
// each direction. It is made from rays that are traced when the cell is made. The renderer samples
// directions from it, in proportion to luminance times cosine, and knows their exact pdf.
#pragma once

#include "base/box.h"
#include "base/function_ref.h"
#include "base/ray.h"
#include "lighting/pick.h"

#include <array>

namespace candelabra {

/// First hit of a ray that probes the scene.
struct ProbeHit {
    double distance = 0;
    Vec3 normal = Vec3(0);  ///< unit, outward
    double tolerance = 0;   ///< for rays that start there
    std::optional<LightIndex> light;
    double luminance = 0;
    double passes = 0;  ///< fraction of light from behind that the surface transmits
};
/// Returns the first hit of a ray beyond the tolerance; nothing if there is none.
using LightProbe = FunctionRef<std::optional<ProbeHit>(const Ray&, double tolerance)>;

/// Calls visit(const ProbeHit&, double share) for the ray's hits one after the other, with the
/// fraction of their light that reaches the ray's origin, until visit returns true or no light
/// passes.
template <class Visit>
void look_along(const Ray& ray, double tolerance, const LightProbe& probe, Visit visit) {
    constexpr int max_surfaces = 16;  // what lies behind more is left to chance
    double share = 1;
    for (int i = 0; i < max_surfaces && share > 0; ++i) {
        const auto sight = probe(ray, tolerance);
        if (!sight || visit(*sight, share)) return;
        share *= sight->passes;
        tolerance = sight->distance + sight->tolerance;
    }
}

/// A place in a cell where light may arrive.
struct SurveyPlace {
    Receiver point;
    double tolerance = 0;
};
/// From where most points to be lit are seen; neither: not known.
struct Viewer {
    std::optional<Vec3> eye = {};
    std::optional<Ray> axis = {};  ///< see LightScene

    /// The ray of the camera that leads to a place.
    std::optional<Ray> ray_to(const Vec3& place) const;
};

/// Returns places on the surfaces in a cell or, if none are found, anywhere in it. If the viewer
/// sees some of these places, only those: there may be sunshine on the other side of a wall.
/// Deterministic.
std::vector<SurveyPlace> survey_places_in(const Box& cell, const Viewer&, const LightProbe&);

/// Returns places anywhere in a cell, between surfaces. Deterministic.
std::vector<SurveyPlace> air_places_in(const Box& cell, const Viewer&, const LightProbe&);

/// Returns factors on the light that arrives at several places, for averages over these: none
/// counts much more than the place with the least light. Otherwise light on a few places would
/// attract the rays of all.
std::vector<double> balanced(std::span<const double> arriving);

/// A ball around the luminaires.
struct LightBall {
    Vec3 centre = Vec3(0);
    double radius = 0;
};

/// Centred on the box, and as tight as spheres around the luminaires in it allow.
LightBall ball_around(const Box&, std::span<const Luminaire>);

class LightGuide {
public:
    static constexpr std::size_t rings = 8, sectors = 32, bins = rings * sectors;

    /// The directions of the picture as seen from a point: a cone, which may be the whole sphere.
    /// Rings and sectors divide it into bins of equal solid angle.
    struct Cone {
        Vec3 middle = Vec3(0), x = Vec3(0), y = Vec3(0);
        double widest = 0;  ///< 1 - cosine of its half angle; 0: no cone

        /// Returns the direction at a place in [0, rings) x [0, sectors).
        Vec3 direction(double ring, double sector) const;
        double bin_density() const;  ///< per steradian, in one bin
    };
    /// Light of each bin at a point.
    struct Weights {
        Cone cone;
        std::array<float, bins> weight;
        std::array<double, rings> ring;
        double total = 0;  ///< 0: nothing can be sampled
    };
    struct Drawn {
        Vec3 direction;
        double density;  ///< per steradian
    };

    LightGuide(const Box& cell, const LightBall&, std::span<const SurveyPlace>, const LightProbe&);

    /// Expected variance over squared mean of a ray sampled from the picture, as measured by the
    /// rays.
    double noise() const { return noise_; }

    /// Irradiance by all visible luminaires, averaged over the receivers.
    double irradiance() const { return irradiance_; }
    /// Luminance of luminaires in directions sampled from a surface's scattering: the mean, and the
    /// expected variance over squared mean.
    double mean_luminance() const { return mean_luminance_; }
    double noise_of_scattering() const { return noise_of_scattering_; }

    void weigh(const Receiver&, Weights&) const;
    static Drawn draw(const Weights&, const Vec2& u);
    static double density(const Weights&, const Vec3& direction);

    std::size_t memory_bytes() const { return light_.capacity() * sizeof(float); }

private:
    Cone cone_at(const Vec3& point) const;

    LightBall ball_;
    bool around_ = true;  ///< covers the whole sphere of directions; else those of the ball
    Vec3 pole_ = Vec3(0, 0, 1);
    double noise_ = 0;
    double irradiance_ = 0;
    double mean_luminance_ = 0, noise_of_scattering_ = INFINITY;
    std::vector<float> light_;  ///< bin by bin, ring by ring; empty: not known
};

}  // namespace candelabra
