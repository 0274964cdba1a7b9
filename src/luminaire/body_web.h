// SPDX-License-Identifier: GPL-3.0-or-later
// How the radiance of a glowing body depends on the direction if a photometric web gives its
// intensity. The intensity is spread evenly over the surface that faces each direction, so that the
// body has exactly that intensity from afar.
#pragma once

#include "photometry/aimed_web.h"

#include <vector>

namespace candelabra {

/// A part of a surface that shines on the side of its normal.
struct Facet {
    Vec3 normal;  ///< unit
    double area;
};

class BodyWeb {
public:
    /// The facets of the whole body.
    BodyWeb(const AimedWeb&, const std::vector<Facet>&);

    /// Candela over the area that faces the direction, a unit vector away from the body. Flat
    /// bodies show no area at their edges; there the area counts as least_area of the greatest.
    double factor(const Vec3& direction) const;
    /// The greatest factor, with some room.
    double greatest() const { return greatest_; }
    /// Mean of the factor over all directions, as a share of the greatest.
    double mean_share() const { return mean_share_; }
    const AimedWeb& web() const { return web_; }

    static constexpr double least_area = 0.02;

private:
    double facing(const Vec3& direction) const;

    AimedWeb web_;
    std::vector<Facet> facets_;   ///< of bodies with few different normals
    std::vector<double> facing_;  ///< of others: area by direction, in rows from pole to pole
    double same_ = 0;             ///< of those alike from all sides: the area; 0: of no such body
    double least_ = 0;            ///< least area that counts
    double greatest_ = 0, mean_share_ = 1;
};

}  // namespace candelabra
