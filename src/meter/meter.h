// SPDX-License-Identifier: GPL-3.0-or-later
// Meters: what is measured in a scene, and where, as a luxmeter or an observer would. They change
// no picture.
#pragma once

#include "base/handle.h"
#include "meter/road_table.h"
#include "vocabulary/item_info.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// What a meter measures. The numbers are those of Meter::quantity.
enum class Quantity : std::uint8_t {
    illuminance,          ///< lux, of a plane that faces the direction
    cylindrical,          ///< lux, mean over the sides of a small upright cylinder
    semi_cylindrical,     ///< lux, mean over the half of it that faces the direction
    hemispherical,        ///< lux, mean over the upper half of a small ball
    spherical,            ///< lux, mean over a small ball
    luminance,            ///< cd/m2, as an observer sees it
    ugr,                  ///< unified glare rating of an observer (CIE 117)
    threshold_increment,  ///< per cent, of a driver (EN 13201-3)
    daylight_factor       ///< per cent of the illuminance by the free sky
};

/// Rules of standards for the number of points of a grid.
enum class GridRule : std::uint8_t { none, en_12464, en_13201 };

struct Meter {
    std::string name;
    int quantity = 0;               ///< a Quantity
    Vec3 corner = Vec3(0);          ///< of the grid
    Vec3 along = Vec3(0);           ///< first side of the grid; 0: there is no grid
    Vec3 across = Vec3(0);          ///< second side; 0: the grid is a line
    std::optional<Vec2> counts;     ///< points along and across; unset: by the rule
    int rule = 0;                   ///< a GridRule
    int lanes = 1;                  ///< of the road that the grid covers, for luminance
    std::vector<Vec3> points;       ///< in the place of a grid
    std::optional<Vec3> direction;  ///< where it faces; unset: as the grid, upward
    std::optional<Vec3> eye;  ///< of an observer who looks at each point; unset: at the points
    Vec3 up = Vec3(0, 1, 0);
    double cone = 0;         ///< half of the angle that an observer averages, in degrees
    double maintenance = 1;  ///< factor on all results
    std::string road;        ///< meter whose mean luminance is that of the road
    std::string road_table;  ///< file with the road's reflection, for luminance
    Handle<RoadTable> surface = {};  ///< of that file; null: the road's own material is seen

    static const ItemInfo vocabulary;
    friend bool operator==(const Meter&, const Meter&) = default;

    Quantity measures() const { return static_cast<Quantity>(quantity); }
    bool has_grid() const { return along != Vec3(0); }
};

/// Unit of a quantity, in ASCII: "lx", "cd/m2", "%"; empty for a rating.
std::string_view unit_of(Quantity);
/// Its name, which is its word in the language.
std::string_view name_of(Quantity);

/// Returns a sentence about an error in the meter as a whole; empty if there is none.
std::string problem(const Meter&);

}  // namespace candelabra
