// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's own lights: points, beams and grids of points. (Emitting objects are luminaires and do
// not use this module.)
#pragma once

#include "base/rgb.h"
#include "photometry/aimed_web.h"
#include "vocabulary/kinds.h"

#include <optional>
#include <string>

namespace candelabra {

class Transform;

/// Shape of the light that leaves a source.
enum Beam : int {
    all_around,
    cone,          ///< from the location towards point_at
    parallel_beam  ///< a cylinder around the axis from the location to point_at
};

/// The geometry of a cone of light, by which it is evaluated.
struct LightConeShape {
    Vec3 axis;  ///< unit
    double bright,
        dark;  ///< cosines to the axis: light is even up to the one, none beyond the other
};

/// A light source. It lights a perpendicular surface with an irradiance of pi times its colour, so
/// that the surface shows the colour as its finish says. Without fading, the distance does not
/// matter.
struct PointLight : WebPlace {
    Vec3 location = Vec3(0);
    Rgb colour = Rgb(0);
    int beam = all_around;
    bool parallel = false;  ///< all light comes along the axis
    Vec3 point_at = Vec3(0, 0, 1);
    std::optional<double> radius;  ///< of the bright middle: in degrees for a cone, a length for a
                                   ///< beam
    std::optional<double> falloff;
    double tightness = 0;
    double fade_distance = 0;
    double fade_power = 0;
    /// In units of LightUnits: the light falls with the square of the distance then, and the colour
    /// as given is only a hue. See measure().
    std::optional<double> intensity;
    std::optional<double> flux;
    bool shadowless = false;
    bool media_attenuation = false;  ///< fog attenuates its light on the way to a surface
    bool media_interaction = true;   ///< if false, fog does not attenuate it in any case
    Vec3 area1 = Vec3(0);            ///< side of a grid of lights around the location
    Vec3 area2 = Vec3(0);
    int size1 = 0;  ///< number of lights along the sides of the grid; 0: no grid
    int size2 = 0;
    std::optional<double> adaptive;  ///< levels of subdivision in any case; unset: all levels
    bool jitter = false;
    bool circular = false;
    bool orient = false;
    bool area_illumination = false;
    /// Without a fade_distance, it fades with the distance to the power of -fade_power. If false,
    /// it does not fade then.
    bool fades_from_source = false;
    /// Of parallel light: the cosine of half of the angle around its axis from which it comes, as
    /// that of the sun does; 1: it comes along the axis only.
    double disc_edge = 1;
    std::optional<LightConeShape> shape = {};  ///< set by settle(); unset: derived at each use
    Handle<AimedWeb> aimed = {};               ///< set by settle() if there is a web

    static const ItemInfo vocabulary;

    bool is_measured() const { return intensity || flux || web; }
    bool is_area() const { return size1 * size2 > 1; }
    /// Whether all of its light is parallel to the axis.
    bool along_axis() const { return parallel || beam == parallel_beam; }
    /// The shape that limits its light. As in POV-Ray, a shadowless light has no cone and no
    /// cylinder.
    int kept_to() const { return shadowless ? all_around : beam; }
};

/// Returns the unit direction of a cone, a beam or parallel light.
Vec3 axis_of(const PointLight&);

/// Gives a light with a stated intensity or flux the colour and the fading that follow. Other
/// lights stay. A black light becomes white, as it has no colour. Returns an error as a sentence,
/// or an empty string.
std::string measure(PointLight&);

/// Prepares a light that does not change any more, so that it is evaluated faster.
void settle(PointLight&);

/// Whether the light has an axis, but no direction of it. Such a light lights nothing.
bool is_aimless(const PointLight&);
/// Returns a sentence about parameters without effect; empty if there are none.
std::string ignored(const PointLight&);

/// Returns the light transformed to world space.
PointLight transformed(PointLight, const Transform&);

/// Light that arrives at a point if it is not occluded.
struct Incidence {
    Vec3 direction;       ///< unit, from the point towards the light
    double distance = 0;  ///< not above 0: nothing can occlude the light
    Rgb colour = Rgb(0);
};

/// Light from one of the light's points: `from` is the location, or another point of its grid.
Incidence incidence(const PointLight&, const Vec3& from, const Vec3& point);

/// Whether the point is outside the light's cone, as far as that is certain without a square root.
/// True: incidence() has no colour there.
bool is_beside_cone(const PointLight&, const Vec3& point);

/// Returns a place in the light's grid: whole numbers from 0 to size - 1 are its lights.
/// `direction` is the unit direction from the lit point to the location.
Vec3 grid_point(const PointLight&, double place1, double place2, const Vec3& direction);
/// Returns the place of one of its lights, each of which is as likely; u is in [0, 1)^2.
Vec3 drawn_grid_point(const PointLight&, const Vec2& u, const Vec3& direction);

}  // namespace candelabra
