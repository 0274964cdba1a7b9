// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire of any shape: an estimate of its irradiance, and points on it with their density. The
// light samplers choose among luminaires; the renderer then asks the chosen one for a point.
#pragma once

#include "base/box.h"
#include "base/function_ref.h"
#include "base/rgb.h"
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

/// Directions from which a point receives light.
enum class Horizon : std::uint8_t {
    one_side,    ///< above its plane, weighted by the cosine to the normal
    both_sides,  ///< above and below its plane, weighted in the same way
    none         ///< all directions equally: the point is in the air, and its normal is 0
};

/// A point that receives light.
struct Receiver {
    Vec3 position;
    Vec3 normal;  ///< unit, on the side that is seen; 0 in the air
    Horizon horizon = Horizon::one_side;

    /// Weight of light from a unit direction: 0 to 1; below 0 where it does not count.
    double cosine(const Vec3& direction) const {
        if (horizon == Horizon::none) return 1;
        const double height = dot(direction, normal);
        return horizon == Horizon::both_sides ? std::abs(height) : height;
    }
};

/// A point on a luminaire, or in glowing media, as seen from a shading point.
struct LightPoint {
    Vec3 position;
    Vec3 direction;  ///< unit, from the shading point
    double distance;
    double density;  ///< per steradian, in media also per unit of length; above 0
};

/// A glowing sphere, sampled uniformly in the cone that it fills (from inside, by its area).
struct SphereEmitter {
    Vec3 centre;
    double radius;
};

/// The side of a face of a closed mesh that light does not leave. The outer side is that of
/// triangle_normal().
enum class SealedSide : std::uint8_t { none, inner, outer };

/// A glowing triangle, sampled uniformly in solid angle (Arvo, "Stratified Sampling of Spherical
/// Triangles", 1995).
struct TriangleEmitter {
    Vec3 corner1, corner2, corner3;
    SealedSide sealed = SealedSide::none;
};

/// Its sides are at right angles.
struct RectangleEmitter {
    Vec3 corner, side1, side2;
};

/// Any other shape whose area can be sampled, under any affine map.
struct AreaEmitter {
    AreaEmitter(BuiltShape shape, Handle<Transform> transform,
                SealedSide sealed = SealedSide::none);

    BuiltShape shape;
    Handle<Transform> transform;  ///< null: identity
    double area;                  ///< emitting area, which may take a while to find
    SealedSide sealed;            ///< of a mesh
};

class ProxyMesh;

/// Any other shape, whole or cut by others.
struct CompositeEmitter {
    Handle<Composite> composite;
    std::uint32_t leaf = 0;           ///< index of the glowing part in the composite
    double seen_area = 0;             ///< projected area, averaged over all directions
    Handle<ProxyMesh> proxy = nullptr;  ///< where most of its points are sought; null: all around
    std::optional<double> mean = {};    ///< luminance over the surface, if the proxy mesh knows it
    double unevenness = 1;            ///< mean of the squared luminance over the squared mean
    bool closed = false;              ///< whether no inner side is visible from outside
};

class BodyWeb;
class Brightness;

using Emitter =
    std::variant<SphereEmitter, TriangleEmitter, RectangleEmitter, AreaEmitter, CompositeEmitter>;

/// A luminaire as the samplers see it. Surfaces emit on both sides, as they do in POV-Ray, unless
/// they have another texture on the inner side.
struct Luminaire {
    Emitter emitter;
    /// Maximum radiance anywhere on it, on either side, per channel.
    Rgb radiance;
    bool varying = false;    ///< whether the radiance changes over the surface
    bool two_faced = false;  ///< whether the two sides differ in radiance
    bool one_sided = false;  ///< whether one of the sides emits nothing
    /// Whether light that it emits on its inner side cannot leave it.
    bool keeps_inner_light = false;
    Handle<Brightness> brightness = nullptr;  ///< null: unknown
    /// How its radiance changes with the direction; null: it does not.
    Handle<BodyWeb> web = nullptr;
    std::uint32_t primitive;  ///< index of its primitive in the world
};

/// Has a luminaire fetched from memory, which takes longer than most of what is done with it.
inline void fetch(const Luminaire& luminaire) {
    constexpr std::size_t line = 64;
    const auto* const bytes = reinterpret_cast<const char*>(&luminaire);
    for (std::size_t i = 0; i < sizeof(Luminaire); i += line) __builtin_prefetch(bytes + i);
}

/// Place, directions and amount of the emission of a luminaire or a cluster of them: enough to
/// estimate and to bound its irradiance.
struct LightBounds {
    Box box;
    Vec3 centre = Vec3(0);  ///< of a bounding sphere; for a glowing sphere, of the sphere itself
    double radius = 0;
    /// Unit normal of flat luminaires (of either sign: both sides shine), 0 for others.
    Vec3 axis = Vec3(0);
    /// Luminance times projected area: face-on if flat, else averaged over all directions.
    double intensity = 0;
    double luminance = 0;  ///< of its brightest point
    double evenness = 0;   ///< fraction of its intensity that a flat luminaire of some thickness
                           ///< has in all directions
    /// Main direction in which light escapes from the luminaire's surroundings (a window does not
    /// light its own house). The luminaire has full strength in this direction, and in the opposite
    /// one a fraction smaller by twice the vector's length. Length 0: all directions alike; maximum
    /// 0.5.
    Vec3 bent_normal = Vec3(0);
};

/// Luminance for choosing luminaires: grey(), but above 0 if any channel is.
double luminance(const Rgb& radiance);

LightBounds bounds(const Luminaire&);

/// Estimates the unoccluded irradiance at the point, as luminance; exact for triangles, and for
/// spheres above the horizon. Never 0 if any part of the luminaire is above the point's tangent
/// plane: the paper's Figure 4 shows the consequences otherwise.
double unoccluded(const Luminaire&, const Receiver&);

/// Returns a point of the luminaire that may be visible from the shading point, with its density; u
/// is in [0, 1)^2. Returns nothing if the drawn point cannot be visible (it faces away, or lies on
/// the horizon).
std::optional<LightPoint> sample(const Luminaire&, const Vec3& from, const Vec2& u);

/// The same for a known surface normal: spheres wholly above the horizon are sampled in proportion
/// to the cosine, so that they make no noise on a diffuse surface.
std::optional<LightPoint> sample(const Luminaire&, const Receiver&, const Vec2& u);

/// A direction in which a luminaire may be visible, and its density per steradian.
struct LightDirection {
    Vec3 direction;  ///< unit
    double density;
};

/// A luminaire whose points are found by tracing rays. The density of a point is that of its
/// direction if the luminaire is not met before, so one ray in a drawn direction does all of the
/// work.
class SearchedLuminaire {
public:
    /// Returns nothing if the luminaire is of another kind.
    static std::optional<SearchedLuminaire> of(const Luminaire&);

    /// Returns nothing if no ray can be traced in the drawn direction.
    std::optional<LightDirection> draw(const Vec3& from, const Vec2& u) const;
    double density(const Vec3& from, const Vec3& direction) const;

private:
    explicit SearchedLuminaire(const CompositeEmitter& emitter) : emitter_(&emitter) {}
    const CompositeEmitter* emitter_;
};

/// A point where a ray meets a luminaire.
struct LightHit {
    double distance;
    double density;  ///< per steradian, with which sample() returns this point for the shading
                     ///< point
};
using LightHits = std::vector<LightHit>;

/// Appends the points that sample() may return in this direction from the shading point.
void intersect(const Luminaire&, const Receiver&, const Vec3& direction, LightHits&);

/// A ray that leaves a luminaire or glowing media.
struct EmittedRay {
    Ray ray;          ///< from the surface; its direction is a unit vector
    Vec3 normal;      ///< unit normal of the surface, on the side of the ray; in media, the
                      ///< direction itself
    double density;   ///< joint density of point and direction: the product of these two
    double of_point;  ///< density per area; in media, per volume
    double of_direction() const { return density / of_point; }  ///< per steradian
};

/// Random numbers in [0, 1) for a ray that leaves a luminaire.
struct EmissionDraw {
    Vec2 where, direction;
    double side;  ///< chooses a side, or one of the points where a line meets the surface
};

/// Returns a point of the luminaire and a direction in which it emits, drawn roughly in proportion
/// to the emitted power. The radiance along the ray times the cosine to the normal, over the
/// density, is an unbiased estimate of the power: every point has all directions on both sides.
/// `inner`: fraction of the rays that leave a closed surface on its inner side; it changes their
/// noise only, unless it is 0: then the light of that side is left out. Returns nothing if no point
/// is drawn.
std::optional<EmittedRay> emit(const Luminaire&, double inner, const EmissionDraw&);

/// Area of the emitting surface in world units; 0 if it cannot glow (a degenerate triangle).
double emitting_area(const Emitter&);

/// Number of faces of a map of the brightness. Boxes, discs, triangles and spheres can have a map
/// (a sphere's counts as several faces); 0 for other emitters.
std::size_t face_count(const Emitter&);
/// Returns a map of the brightness of a luminaire (see Brightness), or null for a sphere that glows
/// so evenly that its formula is better. Precondition: face_count() > 0.
Handle<Brightness> brightness_of(const Luminaire&, int cells,
                                 FunctionRef<double(const Vec3&)> luminance);

}  // namespace candelabra
