// SPDX-License-Identifier: GPL-3.0-or-later
// Directions as a surface scatters light: by its diffuse part and by its highlights. What is drawn
// where the surface, and not the light, should say where to look.
#pragma once

#include "lighting/light_cut.h"
#include "render/shade.h"

#include <array>
#include <optional>
#include <span>

/// Of one layer of the surface at a hit. Refers to the shading.
class Scattering {
public:
    explicit Scattering(const Shading&);

    /// Share of the directions that are drawn from highlights: about that of the light which they
    /// send on when it comes from everywhere. 0 of dull surfaces.
    double gloss() const { return gloss_; }

    /// What highlights send to the viewer of light of colour 1 that comes from everywhere, roughly.
    double highlights() const { return highlights_; }

    /// The same as the choice of luminaires knows it.
    Gloss answers() const;

    /// A unit direction; u is in [0, 1)^2. Nothing where a highlight leads below the surface.
    std::optional<Vec3> draw(Vec2 u) const;

    /// Probability per steradian of that direction.
    double density(const Vec3& direction) const;

private:
    /// A highlight.
    struct Lobe {
        enum Kind {
            about_mirrored,  ///< a power of the cosine to the mirrored view
            about_normal,    ///< of the cosine of the half vector to the normal
            facets
        };
        Kind kind = facets;
        double extent = 0;  ///< the exponent; of facets their width
        double share = 0;   ///< of all directions
    };

    void add(Lobe::Kind, double extent, double light);
    std::span<const Lobe> lobes() const { return {lobes_.data(), count_}; }
    Vec3 draw_diffuse(Vec2 u) const;
    std::optional<Vec3> draw(const Lobe&, Vec2 u) const;
    double density(const Lobe&, const Vec3& direction) const;

    const Shading& s_;
    double gloss_ = 0, highlights_ = 0, dull_ = 0;
    std::array<Lobe, 2> lobes_;
    std::size_t count_ = 0;
};
