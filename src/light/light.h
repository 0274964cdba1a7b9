// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's own lights: points, beams and grids of points. (Objects that emit are luminaires and
// need nothing from here.)
#pragma once

#include "vocabulary/kinds.h"

#include <optional>

namespace candelabra {

class Transform;

/// How light leaves a source.
enum Beam : int {
    all_around,
    cone,          ///< from the location towards point_at
    parallel_beam  ///< a cylinder around the axis from the location to point_at
};

/// A surface that it lights straight on answers as its finish says to the colour, at any distance
/// unless it fades: a perpendicular irradiance of pi times the colour.
struct PointLight {
    Vec3 location = Vec3(0);
    Vec3 colour = Vec3(0);
    int beam = all_around;
    bool parallel = false;  ///< all light comes along the axis
    Vec3 point_at = Vec3(0, 0, 1);
    std::optional<double> radius;  ///< of the bright middle: degrees of a cone, or a length
    std::optional<double> falloff;
    double tightness = 0;
    double fade_distance = 0;
    double fade_power = 0;
    bool shadowless = false;
    bool media_attenuation = false;  ///< fog takes of its light on the way to a surface
    bool media_interaction = true;   ///< otherwise fog does not whatever media_attenuation says
    Vec3 area1 = Vec3(0);            ///< sides of a grid of lights around the location
    Vec3 area2 = Vec3(0);
    int size1 = 0;  ///< how many lights the grid has along its sides; 0: there is no grid
    int size2 = 0;
    std::optional<double> adaptive;  ///< how often a quarter is divided in any case; unset: always
    bool jitter = false;
    bool circular = false;
    bool orient = false;
    bool area_illumination = false;

    static const ItemInfo vocabulary;

    bool is_area() const { return size1 * size2 > 1; }
    /// All of its light comes along the axis.
    bool along_axis() const { return parallel || beam == parallel_beam; }
    /// What its light keeps to. A shadowless light knows no cone and no cylinder, as POV-Ray's.
    int kept_to() const { return shadowless ? all_around : beam; }
};

/// Every kind of light source.
using Light = std::variant<PointLight>;

/// What is wrong with the light as a whole, as a sentence; empty when nothing is.
std::string problem(const PointLight&);
/// What is said of the light without effect, as a sentence; empty when nothing is.
std::string ignored(const PointLight&);

/// The light as it stands in a scene, after a transformation.
PointLight transformed(PointLight, const Transform&);

/// Light that reaches a point if nothing is between.
struct Incidence {
    Vec3 direction;       ///< unit, from the point towards the light
    double distance = 0;  ///< not above 0: nothing can be between
    Vec3 colour = Vec3(0);
};

/// From one of the light's points: `from` is the location, or another of its grid.
Incidence incidence(const PointLight&, const Vec3& from, const Vec3& point);

/// A place in the light's grid: whole numbers from 0 to size - 1 are its lights. `direction` is the
/// unit direction from the lit point to the location.
Vec3 grid_point(const PointLight&, double place1, double place2, const Vec3& direction);

}  // namespace candelabra
