// SPDX-License-Identifier: GPL-3.0-or-later
// Where a luminaire whose glow varies is bright: a map of cells for each of its faces, as a
// television screen has. The luminaire draws most of its points from it, and the others as if it
// glowed evenly, so that what the map misses keeps its chance.
#pragma once

#include "luminaire/bright_cells.h"

#include "base/short_list.h"

#include <cmath>
#include <span>
#include <variant>

namespace candelabra {

/// A flat face: a parallelogram, or what its outline leaves of one.
struct BrightFace {
    enum Outline {
        whole,
        triangle,  ///< the half at the corner
        disc       ///< the ellipse that touches all sides, with a hole
    };
    Vec3 corner, side1, side2;
    Outline outline = whole;
    double hole = 0;  ///< of discs: radius as a share of the disc's
};

class Brightness {
    struct Face;

public:
    /// From this unevenness on a map is better for curved surfaces than their formula.
    static constexpr double uneven = 3;
    /// Cells of a face in each direction are at most this many; each is asked at four points.
    static constexpr int max_cells = 128;

    /// Of a solid, the cross product of the sides points outwards, and only faces that are turned
    /// to a point shine there. `luminance` is asked at points of the faces; 0 everywhere makes a
    /// map that is never drawn from.
    Brightness(const std::vector<BrightFace>&, bool solid, int cells,
               FunctionRef<double(const Vec3&)> luminance);

    /// Of a sphere, with as many cells around it and from pole to pole.
    Brightness(const Vec3& centre, double radius, int cells,
               FunctionRef<double(const Vec3&)> luminance);

    /// Mean luminance over the area of all faces.
    double mean() const { return mean_; }
    /// The mean of the square of the luminance over the square of its mean; 1 where it is dark.
    double unevenness() const { return mean_ > 0 ? mean_square_ / (mean_ * mean_) : 1; }

    /// How points are drawn as seen from somewhere.
    class View {
    public:
        View(const Brightness&, const Vec3& from);
        /// False where no face is turned to, or all are dark: nothing can be drawn.
        bool any() const { return !weights_.empty() && weights_.back() > 0; }
        struct Drawn {
            Vec3 position;   ///< it may lie beyond the outline of its face
            double density;  ///< per steradian; 0 where the face is seen from the side or behind
        };
        /// Precondition: any().
        Drawn draw(const Vec2& u) const;
        /// Density per steradian of a point of the surface.
        double density(const Vec3& position) const;

    private:
        double weight(const Face&) const;
        std::span<const double> weights() const { return {weights_.data(), weights_.size()}; }
        double density(std::size_t face, const Vec3& position, double of_face) const;
        std::size_t face_at(const Vec3& position) const;
        /// A height, or the like, above 0 where the side is seen that shines here.
        double seen(double height) const {
            return sides_ == 0 ? std::abs(height) : sides_ * height;
        }

        const Brightness& map_;
        Vec3 from_;
        int sides_;  ///< that are seen: outer ones, inner ones (-1), or both (0)
        ShortList<double, 72> weights_;  ///< sums: of each face and all before it
    };

private:
    struct Flat {
        Vec3 corner, side1, side2;
        Vec3 normal;  ///< unit
        /// Their products with an offset from the corner say where it leads along the sides.
        Vec3 across1, across2;

        Vec3 middle() const { return corner + 0.5 * (side1 + side2); }
        Vec3 normal_at(const Vec3&) const { return normal; }
        /// How far a point is in front of it.
        double height(const Vec3& point) const { return dot(point - corner, normal); }
        Vec3 at(const Vec2& place) const;
        Vec2 place_of(const Vec3& position) const;
    };
    /// Part of a sphere between two heights and two turns around the y axis. Equal parts of these
    /// have equal areas.
    struct Patch {
        Vec3 centre;
        double radius;
        double low, rise;                 ///< of a sphere of radius 1, from -1 to 1
        double start, turn;               ///< shares of a whole turn
        Vec3 outwards;                    ///< unit, from the centre to the patch's middle
        double reach_cosine, reach_sine;  ///< of the angle from there to the farthest corner

        Vec3 middle() const { return centre + radius * outwards; }
        Vec3 normal_at(const Vec3& position) const { return unit(position - centre); }
        /// How far a point is in front of it: more than 0 if of any of it.
        double height(const Vec3& point) const;
        Vec3 at(const Vec2& place) const;
        Vec2 place_of(const Vec3& position) const;
    };
    struct Face {
        std::variant<Flat, Patch> shape;
        double area;  ///< also of what the outline leaves out
        BrightCells cells;
    };
    void take_means();

    std::vector<Face> faces_;
    bool solid_;
    double mean_ = 0, mean_square_ = 0;
};

}  // namespace candelabra
