// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the light of each lamp under other powers and colours.
#pragma once

#include "base/image.h"
#include "relight/light_records.h"

#include <array>
#include <span>
#include <vector>

namespace candelabra {

/// Red, green and blue of a picture, each row by row.
using PicturePlanes = std::array<std::vector<float>, 3>;

class Relighting {
public:
    /// `smooth`: how far around a pixel, in pixels, the light of crowds of lamps is compared with
    /// what it was, so that it has less noise. 0: not at all; each pixel has the right expected
    /// value then. The records must outlive it.
    Relighting(const LightRecords&, int smooth, int threads);

    /// Returns the picture with these factors on the lamps, by their places in the list; 1 is a
    /// lamp as it was rendered.
    Image picture(std::span<const Vec3> factors) const;

private:
    /// Light of lamps that have records of their own, and of lamps that have not.
    struct Split {
        PicturePlanes sharp, crowd;
    };
    Split planes_of(std::span<const Vec3> factors) const;

    const LightRecords& records_;
    int smooth_, threads_;
    PicturePlanes crowd_, blurred_;  ///< as rendered; only if it is smooth
};

/// Returns a picture whose pixels have the right expected values.
Image relit(const LightRecords&, std::span<const Vec3> factors, int threads);

}  // namespace candelabra
