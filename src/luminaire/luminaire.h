// SPDX-License-Identifier: GPL-3.0-or-later
// One thing that emits light, whatever its shape: how bright it may look from afar, and points on
// it with their density. The light samplers choose among luminaires; the renderer then asks the
// chosen one for a point.
#pragma once

#include "base/box.h"
#include "base/function_ref.h"
#include "base/transform.h"
#include "base/vector.h"
#include "luminaire/falloff.h"
#include "shape/built_shape.h"
#include "shape/composite.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace candelabra {

/// From where light counts at a point.
enum class Horizon : std::uint8_t {
    one_side,    ///< above its plane, by the cosine to the normal
    both_sides,  ///< above and below the plane, by the same
    none         ///< from everywhere alike: the point is in the air, and its normal is 0
};

/// A point to be lit.
struct Receiver {
    Vec3 position;
    Vec3 normal;  ///< unit, on the side that is seen; 0 in the air
    Horizon horizon = Horizon::one_side;

    /// How much light from a unit direction counts: 0 to 1, and below 0 where none does.
    double cosine(const Vec3& direction) const {
        if (horizon == Horizon::none) return 1;
        const double height = dot(direction, normal);
        return horizon == Horizon::both_sides ? std::abs(height) : height;
    }
};

/// A point on a luminaire as seen from a shading point.
struct LightPoint {
    Vec3 position;
    Vec3 direction;  ///< unit, from the shading point
    double distance;
    double density;  ///< probability per steradian, of volumes also per length; above 0
};

/// A glowing sphere, sampled uniformly in the cone that it fills (by its area from inside).
struct SphereEmitter {
    Vec3 centre;
    double radius;
};

/// A glowing triangle, sampled uniformly in solid angle (Arvo, "Stratified Sampling of Spherical
/// Triangles", 1995).
struct TriangleEmitter {
    Vec3 corner1, corner2, corner3;
};

/// Any other shape whose area can be sampled, under any affine map.
struct AreaEmitter {
    BuiltShape shape;
    Handle<Transform> transform;  ///< null: none
};

class Guide;

/// Any other shape, whole or cut by others.
struct CompositeEmitter {
    Handle<Composite> composite;
    std::uint32_t leaf = 0;           ///< of the composite: the part that glows
    double seen_area = 0;             ///< the area of its shadow, on average over all directions
    Handle<Guide> guide = nullptr;    ///< where most of its points are looked for; null: all around
    std::optional<double> mean = {};  ///< luminance over the surface, if the guide knows it
    double unevenness = 1;  ///< of luminance: the mean of its square over the square of its mean
};

/// A light source of POV-Ray's, which has no size: all its light comes through a ball, of whose
/// middle there is one point. The renderer asks the source itself for the light that arrives.
struct SourceEmitter {
    Vec3 centre;
    double radius = 0;
    Falloff falloff;
};

class EmissionGrid;

/// A box, or a part of one, that is filled with what glows: see volume.h.
struct VolumeEmitter {
    Box box;
    Handle<EmissionGrid> grid;
};

class Brightness;

using Emitter = std::variant<SphereEmitter, TriangleEmitter, AreaEmitter, CompositeEmitter,
                             SourceEmitter, VolumeEmitter>;

/// A luminaire as the samplers see it. Surfaces emit on both sides, as they look in POV-Ray.
struct Luminaire {
    Emitter emitter;
    /// Greatest radiance anywhere on it, per channel; a source's colour; of a volume all that may
    /// be emitted along a line through it.
    Vec3 radiance;
    bool varying = false;                     ///< whether the radiance changes over the surface
    Handle<Brightness> brightness = nullptr;  ///< where it is bright; null: not known
    std::uint32_t primitive;  ///< the world's primitive that it is; of sources: its light; of
                              ///< volumes: one of the solid that it is in
    /// Where its light gets out of what it is set into (a window's not into its own house):
    /// towards this, with all its strength, and the other way by twice its length less. Length 0:
    /// all around. At most half.
    Vec3 bent_normal = Vec3(0);

    /// Whether its points lie between surfaces, and not on one.
    bool is_volume() const { return std::holds_alternative<VolumeEmitter>(emitter); }
};

/// Where a luminaire (or a cluster of them) is, where it shines, and how much: enough to estimate
/// and to bound what it gives.
struct LightBounds {
    Box box;
    Vec3 centre = Vec3(0);  ///< of a sphere around it, for a glowing sphere the sphere itself
    double radius = 0;
    /// Unit normal when it is flat (either sign: both sides shine), 0 when it is not.
    Vec3 axis = Vec3(0);
    /// Luminance times the area seen: face on when flat, else the mean over all directions.
    double intensity = 0;
    double luminance = 0;  ///< of its brightest point
    double evenness = 0;   ///< what a flat one with some thickness shows in all directions, as a
                           ///< share of its intensity
    Vec3 bent_normal = Vec3(0);  ///< see Luminaire
};

/// Luminance that steers the choice of luminaires: grey(), but never 0 where any channel is above
/// 0.
double luminance(const Vec3& radiance);

LightBounds bounds(const Luminaire&);

/// An estimate of the irradiance (times luminance) at the point as if nothing were between; exact
/// for triangles and for spheres above the horizon. Never 0 when any part of the luminaire is above
/// the point's tangent plane: the paper's Figure 4 shows what happens otherwise.
double unoccluded(const Luminaire&, const Receiver&);

/// A point of the luminaire that may be seen from the shading point, with its density; u in
/// [0,1)^2. Nothing when the drawn point cannot be seen (it faces away, or lies on the horizon).
std::optional<LightPoint> sample(const Luminaire&, const Vec3& from, const Vec2& u);

/// The same where the surface's normal is known: spheres that are wholly above the horizon are
/// sampled in proportion to the cosine, so that a diffuse surface sees no noise of it at all.
std::optional<LightPoint> sample(const Luminaire&, const Receiver&, const Vec2& u);

/// A direction in which a luminaire may be seen; and the density with which it is drawn, per
/// steradian.
struct LightDirection {
    Vec3 direction;  ///< unit
    double density;
};

/// Luminaires that are found by looking: the density of a point of theirs is that of its direction,
/// if nothing else of them is met before. A ray in a drawn direction does all of the work.
class SearchedLuminaire {
public:
    /// Nothing when the luminaire is of another kind.
    static std::optional<SearchedLuminaire> of(const Luminaire&);

    /// Nothing when the drawn direction cannot be followed.
    std::optional<LightDirection> draw(const Vec3& from, const Vec2& u) const;
    double density(const Vec3& from, const Vec3& direction) const;

private:
    explicit SearchedLuminaire(const CompositeEmitter& emitter) : emitter_(&emitter) {}
    const CompositeEmitter* emitter_;
};

/// Where a direction meets a luminaire.
struct LightHit {
    double distance;
    double density;  ///< with which sample() gives this point for the shading point, per steradian
};
using LightHits = std::vector<LightHit>;

/// Appends the points that sample() may give in this direction from the shading point.
void intersect(const Luminaire&, const Receiver&, const Vec3& direction, LightHits&);

/// A ray that leaves a luminaire.
struct EmittedRay {
    Ray ray;      ///< from its surface; the direction is a unit vector
    Vec3 normal;  ///< unit, of the surface there, on the side of the ray; 0 of sources, and the
                  ///< direction itself where there is no surface
    /// Of point and direction together, per area (of volumes per volume) and steradian; of sources,
    /// which have no area, per steradian.
    double density;
};

/// A point of the luminaire and a direction that leaves it there, about in proportion to the power
/// that goes there; points of `where` and `direction` are in [0, 1)^2. The radiance along the ray
/// times the cosine to the normal, over the density, is an unbiased estimate of the power. Nothing
/// when nothing leaves the drawn point. All sides of a surface emit.
std::optional<EmittedRay> emit(const Luminaire&, const Vec2& where, const Vec2& direction);

/// Area of the emitting surface in world units; 0 when it cannot glow (a degenerate triangle).
double emitting_area(const Emitter&);

/// How many faces a map of the brightness has, which boxes, discs, triangles and spheres can have
/// (a sphere's counts as many); 0 for other emitters.
std::size_t face_count(const Emitter&);
/// A map of the brightness of a luminaire that has such faces: see there. Null for a sphere that
/// glows so evenly that its formula is better. Precondition: face_count() > 0.
Handle<Brightness> brightness_of(const Luminaire&, int cells,
                                 FunctionRef<double(const Vec3&)> luminance);

}  // namespace candelabra
