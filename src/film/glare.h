// SPDX-License-Identifier: GPL-3.0-or-later
// Light that lenses and eyes scatter, as a convolution of the picture. The light is kept: what
// leaves a pixel arrives in others, or leaves the picture.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"

#include <vector>

namespace candelabra {

/// Where the light of one pixel arrives: shares of it for each place of a picture of that size and
/// each channel, the pixel's own among them.
///
/// veil: the parts of the eye's point spread function that fall with the third and the second power
/// of the angle, in the proportion of G. Spencer et al., "Physically-based glare effects for
/// digital images" (1995).
/// halo: the ring of the lens's fibres, of the same source, whose radius is in proportion to the
/// wavelength.
/// star: far from a light, straight edges diffract light across them with the inverse square of the
/// angle, times the wavelength (Fraunhofer).
class GlareKernel {
public:
    GlareKernel(const Glare&, int width, int height, int threads = 1);

    /// The share that arrives so many pixels to the right and below; 1 of all together.
    Vec3 at(int dx, int dy) const;
    /// The share of all light that does not simply stay.
    double scattered() const { return glare_.share(); }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    /// Shares in proportion to each other.
    struct Parts {
        double veil = 0;
        Vec3 halo = Vec3(0), star = Vec3(0);

        Parts& operator+=(const Parts&);
    };
    Parts parts_at(int dx, int dy) const;
    void add_point(double dx, double dy, Parts&) const;
    void add_star(double dx, double dy, double angle, Parts&) const;

    Glare glare_;
    int width_, height_;
    double plane_;            ///< pixels from the eye to the picture
    std::vector<Vec2> rays_;  ///< directions of the star
    Parts scales_;            ///< by which parts become shares
};

/// The picture's light after scattering by a kernel of its size; from outside comes none. Pixels
/// that are no finite numbers give none. The result does not depend on the number of threads.
Image spread(const Image&, const GlareKernel&, int threads);

}  // namespace candelabra
