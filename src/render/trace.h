// SPDX-License-Identifier: GPL-3.0-or-later
// Follows one camera ray through a world: surface, direct light, reflection, refraction.
// POV-Ray 3.7's rules for levels, weights and nested interiors.
#pragma once

#include "render/direct_light.h"

#include "base/function_ref.h"
#include "surface/dispersion.h"

#include <algorithm>
#include <optional>
#include <vector>

/// Through a point of the picture (see Projection::ray) and, with a lens, a point of that: the key
/// chooses.
Ray camera_ray(const World&, double u, double v, const Key&);

/// The same without a lens.
Ray pinhole_ray(const World&, double u, double v);

/// What is asked of a tracer besides radiance.
struct Tracing {
    ShadowRays shadow_rays;      ///< at each hit
    bool counts_lights = false;  ///< one by one
    bool clear_sky = false;      ///< what is behind everything may be clear, as in POV-Ray's +UA
};

/// One for each job: it keeps scratch memory and counts rays.
class Tracer {
public:
    Tracer(const World& world, const Tracing&);

    /// Radiance that comes along a camera ray; an unbiased estimate, a pure function of ray and
    /// key.
    Vec3 radiance(const Ray& ray, const Key& key);

    const RayCounts& rays() const { return rays_; }
    const HitNoise& noise() const { return direct_light_.noise(); }

    /// How much of the last sample is what is behind everything and clear: 0 to 1.
    double clear() const { return std::min(clear_, 1.0); }

    /// The light of each of Provenance::light_statements in all samples since the last call. Lights
    /// must be counted.
    void take_lights(FunctionRef<void(std::size_t statement, const Vec3&)> use);

private:
    using Solids = EnteredSolids;

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
        double plain = ratio;  ///< the same of white light, which tells what is reflected
        Solids behind;
        double dispersion = 1;  ///< the same ratio of dispersions
        int bands = 0;          ///< into which white light is split; 0: it is not
    };

    Vec3 follow(const Path&);
    Vec3 beyond(const Path&);
    Vec3 veiled(const Path&, double distance, const Vec3& seen) const;
    void credit(const Hit&, const Vec3& shown);
    Vec3 surface(const Path&, const Hit&);
    Vec3 layered(const Path&, const Hit&, const Shading&, std::span<const Layer>);
    bool in_the_open(const Path&) const;
    Vec3 faded(const Path&, const Hit&) const;
    Vec3 reflected(const Path&, const Shading&, const Vec3& amount, double share,
                   double exponent = 1);
    Vec3 lit(const Path&, const Hit&, const Shading&, const Vec3& through, bool glowing);
    Vec3 scattered(const Path&, const Shading&, double share, const Vec3& through);
    Vec3 transmitted(const Path&, const Shading&, const Interface&, const Vec3& share);
    Vec3 split(const Path&, const Shading&, const Interface&, const Vec3& share);
    Interface interface_at(const Path&, PrimitiveIndex) const;
    const Interior& interior(const Solids&) const;

    const World& world_;
    DirectLight direct_light_;
    Solids around_camera_;
    RayCounts rays_;
    bool clear_sky_;
    double clear_ = 0;
};
