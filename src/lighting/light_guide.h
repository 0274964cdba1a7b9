// SPDX-License-Identifier: GPL-3.0-or-later
// The light that arrives in a cell, as a picture of few pixels: the luminance seen from there in
// each direction. It is made from rays that are traced when the cell is made. The renderer samples
// directions from it, in proportion to luminance times cosine, and knows their exact pdf.
#pragma once

#include "lighting/light_ball.h"
#include "lighting/sky_survey.h"
#include "lighting/survey_places.h"

#include <array>

namespace candelabra {

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

    /// The sky, and the rays of the survey that lead to it, which are added.
    struct SkySeen {
        const ChoosableSky& sky;
        std::vector<SkyRay> rays = {};
    };
    /// `sky`: null: there is none.
    LightGuide(const Box& cell, const LightBall&, std::span<const SurveyPlace>, const LightProbe&,
               SkySeen* sky);

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
