// SPDX-License-Identifier: GPL-3.0-or-later
// The light that arrives in a cell as a picture of few pixels: how bright what is seen from there
// is, direction by direction. Made of rays that are tried when the cell is made. The renderer draws
// directions from it, in proportion to brightness times cosine, and knows their density exactly.
#pragma once

#include "base/box.h"
#include "base/function_ref.h"
#include "base/ray.h"
#include "lighting/pick.h"

#include <array>

namespace candelabra {

/// What a tried ray meets first.
struct ProbeHit {
    double distance = 0;
    Vec3 normal = Vec3(0);  ///< unit, outward
    double tolerance = 0;   ///< of rays that start there
    std::optional<LightIndex> light;
    double luminance = 0;
    double passes = 0;  ///< share of the light from behind it
};
/// Asks the scene for it: a ray, and from which distance on. Nothing when the ray meets nothing.
using LightProbe = FunctionRef<std::optional<ProbeHit>(const Ray&, double tolerance)>;

/// Calls visit(const ProbeHit&, double share) for what the ray meets one after the other, with
/// the share of its light that gets to the ray's origin, until visit returns true or no light
/// passes.
template <class Visit>
void look_along(const Ray& ray, double tolerance, const LightProbe& probe, Visit visit) {
    constexpr int max_surfaces = 16;  // what is behind more is left to chance
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
/// Places on the surfaces in a cell, or, where none are found, anywhere in it. The same each time.
/// Only those that the eye sees, if it sees some: there may be sunshine on the other side of a
/// wall.
std::vector<SurveyPlace> survey_places_in(const Box& cell, const std::optional<Vec3>& eye,
                                          const LightProbe&);

/// Places anywhere in a cell, between surfaces. The same each time.
std::vector<SurveyPlace> air_places_in(const Box& cell);

/// By what the light that arrives at each of several places is to be multiplied when they are
/// looked at together: none of them counts much more than the one that gets the least. Else the
/// rays of all would go to what shines on some of them.
std::vector<double> balanced(std::span<const double> arriving);

/// Where luminaires are.
struct LightBall {
    Vec3 centre = Vec3(0);
    double radius = 0;
};

/// Around the middle of a box, as tight as spheres around the luminaires in it allow.
LightBall ball_around(const Box&, std::span<const Luminaire>);

class LightGuide {
public:
    static constexpr std::size_t rings = 8, sectors = 32, bins = rings * sectors;

    /// The directions of the picture as a point sees them: a cone, which may be the whole sphere.
    /// Rings and sectors divide it into bins of equal solid angle.
    struct Cone {
        Vec3 middle = Vec3(0), x = Vec3(0), y = Vec3(0);
        double widest = 0;  ///< 1 - cosine of its half angle; 0: there is none

        /// The direction at a place in [0, rings) x [0, sectors).
        Vec3 direction(double ring, double sector) const;
        double bin_density() const;  ///< per steradian, in one bin
    };
    /// What comes from each bin to a point.
    struct Weights {
        Cone cone;
        std::array<float, bins> weight;
        std::array<double, rings> ring;
        double total = 0;  ///< 0: nothing can be drawn
    };
    struct Drawn {
        Vec3 direction;
        double density;  ///< per steradian
    };

    LightGuide(const Box& cell, const LightBall&, std::span<const SurveyPlace>, const LightProbe&);

    /// Expected variance over squared mean of a ray that is drawn from it, as far as the rays that
    /// were tried tell.
    double noise() const { return noise_; }

    /// By all luminaires that are seen; mean over the receivers.
    double irradiance() const { return irradiance_; }
    /// What a surface sees of luminaires when it asks in directions as it scatters them: the mean
    /// luminance, and the expected variance over squared mean.
    double mean_luminance() const { return mean_luminance_; }
    double noise_of_scattering() const { return noise_of_scattering_; }

    void weigh(const Receiver&, Weights&) const;
    static Drawn draw(const Weights&, const Vec2& u);
    static double density(const Weights&, const Vec3& direction);

    std::size_t memory_bytes() const { return light_.capacity() * sizeof(float); }

private:
    Cone cone_at(const Vec3& point) const;

    LightBall ball_;
    bool around_ = true;  ///< the whole sphere of directions; else those of the ball
    Vec3 pole_ = Vec3(0, 0, 1);
    double noise_ = 0;
    double irradiance_ = 0;
    double mean_luminance_ = 0, noise_of_scattering_ = INFINITY;
    std::vector<float> light_;  ///< bin by bin, ring by ring; empty: nothing is known
};

}  // namespace candelabra
