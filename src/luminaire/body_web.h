// SPDX-License-Identifier: GPL-3.0-or-later
// How the radiance of a glowing body depends on the direction if a photometric web gives its
// intensity. The intensity is spread evenly over the surface that faces each direction, so that the
// body has exactly that intensity from afar.
#pragma once

#include "photometry/aimed_web.h"

#include <utility>
#include <vector>

namespace candelabra {

/// A part of a surface that shines on the side of its normal.
struct Facet {
    Vec3 normal;  ///< unit
    double area;
};

/// The surface of a body for a web, in the frame of the web.
struct FacetedBody {
    std::vector<Facet> facets;
    double round = 0;  ///< area of parts that are alike from all sides, such as balls
};

/// What a body makes of a web, in the web's own frame: copies of a lamp share it, however they are
/// turned.
class WebbedBody {
public:
    WebbedBody(Handle<PhotometricWeb>, const FacetedBody&);

    /// Candela over the area that faces the direction, a unit vector away from the body. Flat
    /// bodies show no area at their edges; there the area counts as least_area of the greatest.
    double factor(const Vec3& direction) const;
    /// The greatest factor, with some room.
    double greatest() const { return greatest_; }
    /// Mean of the factor over all directions, as a share of the greatest.
    double mean_share() const { return mean_share_; }

    static constexpr double least_area = 0.02;

private:
    double facing(const Vec3& direction) const;

    Handle<PhotometricWeb> web_;
    std::vector<Facet> facets_;   ///< of bodies with few different normals
    std::vector<double> facing_;  ///< of others: area by direction, in rows from pole to pole
    double round_ = 0;            ///< area from all sides of parts that are alike
    double least_ = 0;            ///< least area that counts
    double greatest_ = 0, mean_share_ = 1;
};

class BodyWeb {
public:
    BodyWeb(const AimedWeb& web, Handle<WebbedBody> body) : web_(web), body_(std::move(body)) {}
    /// The facets of the whole body, in the space of the scene.
    BodyWeb(const AimedWeb&, const std::vector<Facet>&);

    /// See WebbedBody; the direction is that in the scene.
    double factor(const Vec3& direction) const { return body_->factor(web_.own(direction)); }
    double greatest() const { return body_->greatest(); }
    double mean_share() const { return body_->mean_share(); }
    const AimedWeb& web() const { return web_; }

private:
    AimedWeb web_;
    Handle<WebbedBody> body_;
};

/// The facets in the frame of a web.
std::vector<Facet> in_frame(const AimedWeb&, std::vector<Facet>);

}  // namespace candelabra
