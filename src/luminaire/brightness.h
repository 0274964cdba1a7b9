// SPDX-License-Identifier: GPL-3.0-or-later
// Where a luminaire whose glow varies is bright: a map of cells for each of its flat faces, as a
// television screen has. The luminaire draws most of its points from it, and the others as if it
// glowed evenly, so that what the map misses keeps its chance.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <optional>
#include <vector>

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
public:
    /// Cells of a face in each direction are at most this many; each is asked at four points.
    static constexpr int most_cells = 128;

    /// Of a solid, the cross product of the sides points outwards, and only faces that are turned
    /// to a point shine there. `luminance` is asked at points of the faces; 0 everywhere makes a
    /// map that is never drawn from.
    Brightness(const std::vector<BrightFace>&, bool solid, int cells,
               FunctionRef<double(const Vec3&)> luminance);

    /// Mean luminance over the area of all faces.
    double mean() const { return mean_; }

    /// How points are drawn as seen from somewhere.
    class View {
    public:
        View(const Brightness&, const Vec3& from);
        /// False where no face is turned to, or all are dark: nothing can be drawn.
        bool any() const { return total_ > 0; }
        struct Drawn {
            Vec3 position;   ///< it may lie beyond the outline of its face
            double density;  ///< per steradian; 0 where the face is seen from the side
        };
        /// Precondition: any().
        Drawn draw(Vec2 u) const;
        /// Density per steradian of a point of the surface.
        double density(const Vec3& position) const;

    private:
        double weight(std::size_t face) const;
        double density(std::size_t face, const Vec3& position, double share_of_cell) const;

        const Brightness& map_;
        Vec3 from_;
        double total_ = 0;
    };

private:
    struct Face {
        Vec3 corner, side1, side2;
        Vec3 normal = Vec3(0);  ///< unit
        /// Their products with an offset from the corner say where it leads along the sides.
        Vec3 across1 = Vec3(0), across2 = Vec3(0);
        double area = 0;   ///< of the parallelogram
        double power = 0;  ///< luminance times area
        std::size_t row_count = 0, column_count = 0;
        std::vector<double> rows = {},
                            columns = {};  ///< sums of shares: up to each row, and within each
    };

    static double ask(const BrightFace&, Face&, FunctionRef<double(const Vec3&)> luminance);

    std::vector<Face> faces_;
    bool solid_;
    double mean_ = 0;
};
