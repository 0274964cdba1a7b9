// SPDX-License-Identifier: GPL-3.0-or-later
// Scattering of light in lenses and eyes, as a convolution of the picture. Energy is conserved:
// light that leaves a pixel arrives in others or leaves the picture.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"

#include <vector>

namespace candelabra {

/// The point spread function of a pixel in a picture of a given size: the fraction of its light
/// that arrives at each offset, per channel, including that of the pixel itself.
///
/// veil: the parts of the eye's point spread function that fall with the third and the second power
/// of the angle, in the proportion of G. Spencer et al., "Physically-based glare effects for
/// digital images" (1995).
/// halo: the ring of the lens's fibres, from the same source; its radius is proportional to the
/// wavelength.
/// star: far from a light, straight edges diffract light perpendicularly to them, with the inverse
/// square of the angle, times the wavelength (Fraunhofer).
class GlareKernel {
public:
    GlareKernel(const Glare&, int width, int height, int threads = 1);

    /// Returns the fraction that arrives at an offset to the right and down, in pixels; they sum to
    /// 1.
    Rgb at(int dx, int dy) const;
    /// Returns the fraction of all light that is scattered.
    double scattered() const { return glare_.share(); }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    /// Unnormalised parts of the kernel.
    struct Parts {
        double veil = 0;
        Rgb halo = Rgb(0), star = Rgb(0);

        Parts& operator+=(const Parts&);
    };
    Parts parts_at(int dx, int dy) const;
    void add_point(double dx, double dy, Parts&) const;
    void add_star(double dx, double dy, double angle, Parts&) const;

    Glare glare_;
    int width_, height_;
    double plane_;            ///< distance of the eye from the picture, in pixels
    std::vector<Vec2> rays_;  ///< directions of the star
    Parts scales_;            ///< normalisation factors of the parts
};

/// Convolves a picture with a kernel of its size. No light comes from outside the picture, nor from
/// pixels that are not finite. The result does not depend on the number of threads.
Image spread(const Image&, const GlareKernel&, int threads);

}  // namespace candelabra
