// SPDX-License-Identifier: GPL-3.0-or-later
// Follows one camera ray through a world: surface, direct light, reflection, refraction.
// POV-Ray 3.7's rules for levels, weights and nested interiors.
#pragma once

#include "render/direct_light.h"

#include "surface/dispersion.h"

#include <optional>
#include <vector>

/// Through a point of the picture (see Projection::ray) and, with a lens, a point of that: the key
/// chooses.
Ray camera_ray(const World&, double u, double v, const Key&);

/// One for each job: it keeps scratch memory and counts rays.
class Tracer {
public:
    /// Lights are counted one by one when that is asked for.
    Tracer(const World& world, int shadow_rays, bool counts_lights = false);

    /// Radiance that comes along a camera ray; an unbiased estimate, a pure function of ray and
    /// key.
    Vec3 radiance(const Ray& ray, const Key& key);

    const RayCounts& rays() const { return rays_; }

private:
    /// What a ray is inside of, in the order of entering.
    using Solids = std::vector<PrimitiveIndex>;

    struct Path {
        Ray ray;
        double tolerance = 0;
        int level = 0;   ///< reflections and refractions so far
        int passed = 0;  ///< surfaces passed without a change of direction, which are not levels
        double weight =
            1;  ///< greatest change of the pixel that this ray can make, relative to its radiance
        RayKind kind = RayKind::camera;
        Key key;
        Solids solids;
        std::optional<SpectralBand> band;  ///< when it is one colour of split white light
        bool counted = false;  ///< the light of luminaires that it meets has been counted already
    };
    struct Interface {
        double ratio;  ///< index of refraction in front of the surface over the one behind it
        Solids behind;
        double dispersion = 1;  ///< the same ratio of dispersions
        int bands = 0;          ///< into which white light is split; 0: it is not
    };

    Vec3 follow(const Path&);
    Vec3 surface(const Path&, const Hit&);
    Vec3 layered(const Path&, const Hit&, const Shading&, std::span<const Layer>);
    bool in_the_open(const Path&) const;
    Vec3 faded(const Path&, const Hit&) const;
    Vec3 reflected(const Path&, const Shading&, const Vec3& amount, double share);
    Vec3 scattered(const Path&, const Shading&, double share);
    Vec3 transmitted(const Path&, const Shading&, const Interface&, const Vec3& share);
    Vec3 split(const Path&, const Shading&, const Interface&, const Vec3& share);
    Interface interface_at(const Path&, PrimitiveIndex) const;
    const Interior& interior(const Solids&) const;

    const World& world_;
    DirectLight direct_light_;
    Solids around_camera_;
    RayCounts rays_;
};
