// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/bicubic_patch.h"

#include "shape/triangle.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo BicubicPatch::vocabulary = described<BicubicPatch>([] {
    using F = Field<BicubicPatch>;
    return schema<BicubicPatch>(
        "bicubic_patch",
        {"A curved sheet between 16 points.",
         "bicubic_patch { type 1 flatness 0.01 u_steps 4 v_steps 4 accuracy 0.01 <-1.2, 0.2, -1>, "
         "<-0.4, 0.9, -1>, <0.4, 0.9, -1>, <1.2, 0.2, -1>, <-1.2, 0.6, -0.3>, <-0.4, 2, -0.3>, "
         "<0.4, 2, -0.3>, <1.2, 0.6, -0.3>, <-1.2, 0.6, 0.3>, <-0.4, 2, 0.3>, <0.4, 2, 0.3>, <1.2, "
         "0.6, 0.3>, <-1.2, 0.2, 1>, <-0.4, 0.9, 1>, <0.4, 0.9, 1>, <1.2, 0.2, 1> }"},
        always(16, F{"points", &BicubicPatch::points, counted, "the points, row by row"}),
        F{"type", &BicubicPatch::type, item, "0 or 1, without effect"},
        F{"flatness", &BicubicPatch::flatness, item, "how far pieces may be from flat",
          at_least(0)},
        F{"u_steps", &BicubicPatch::u_steps, item, "halvings at most across the rows",
          between(0, 10)},
        F{"v_steps", &BicubicPatch::v_steps, item, "halvings at most along the rows",
          between(0, 10)},
        F{"accuracy", &BicubicPatch::accuracy, item, "accepted, and not needed"},
        F{"uv_vectors", &BicubicPatch::uv1, item, "u and v of the four corners"},
        F{"uv 2", &BicubicPatch::uv2, following, "the second corner's"},
        F{"uv 3", &BicubicPatch::uv3, following, "the third corner's"},
        F{"uv 4", &BicubicPatch::uv4, following, "the fourth corner's"});
});

namespace {

/// Number of facets, adjacent in the patch's subdivision, that the index treats as one part:
/// sorting single facets takes longer than rendering a small picture.
constexpr std::uint32_t facets_of_part = 8;

/// points[row][column].
using Points = std::array<std::array<Vec3, 4>, 4>;

/// Splits a Bezier curve in the middle (de Casteljau).
void halve(const std::array<Vec3, 4>& p, std::array<Vec3, 4>& first, std::array<Vec3, 4>& last) {
    const Vec3 a = 0.5 * (p[0] + p[1]), b = 0.5 * (p[1] + p[2]), c = 0.5 * (p[2] + p[3]);
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), middle = 0.5 * (ab + bc);
    first = {p[0], a, ab, middle};
    last = {middle, bc, c, p[3]};
}

Points transposed(const Points& p) {
    Points result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) result[i][j] = p[j][i];
    return result;
}

/// Both halves along the rows.
std::pair<Points, Points> halves(const Points& p) {
    std::pair<Points, Points> result;
    for (std::size_t row = 0; row < 4; ++row) halve(p[row], result.first[row], result.second[row]);
    return result;
}

/// Maximum distance of a point from the plane through the first three corners that are not
/// collinear, as in POV-Ray.
double farthest_from_plane(const Points& p) {
    Vec3 normal = triangle_normal(p[0][0], p[0][3], p[3][0]);
    if (normal == Vec3(0)) normal = triangle_normal(p[0][0], p[0][3], p[3][3]);
    if (normal == Vec3(0)) normal = triangle_normal(p[0][0], p[3][0], p[3][3]);
    double most = 0;
    for (const auto& row : p)
        for (const Vec3& point : row)
            most = std::fmax(most, normal == Vec3(0) ? length(point - p[0][0])
                                                     : std::abs(dot(normal, point - p[0][0])));
    return most;
}

/// The normal at a corner, from the first points along its row and its column that differ from it.
Vec3 corner_normal(const Points& p, std::size_t row, std::size_t column) {
    const Vec3& corner = p[row][column];
    Vec3 along(0), across(0);
    for (std::size_t i = 1; i < 4 && along == Vec3(0); ++i)
        along = p[row][column == 0 ? i : 3 - i] - corner;
    for (std::size_t i = 1; i < 4 && across == Vec3(0); ++i)
        across = p[row == 0 ? i : 3 - i][column] - corner;
    const Vec3 normal = unit(cross(across, along));
    return (row == 0) == (column == 0) ? normal : -normal;
}

class Divider {
public:
    explicit Divider(const BicubicPatch& patch, BuiltBicubicPatch& result)
        : patch_(patch), result_(result) {}

    /// A part of the patch, with u and v of its first and its last corner.
    struct Piece {
        Points points;
        Vec2 low = Vec2(0), high = Vec2(1);
    };

    void divide(const Piece& piece, int u_step, int v_step) {
        const bool flat = farthest_from_plane(piece.points) < patch_.flatness;
        if (!flat && v_step < patch_.v_steps) {
            const auto [first, last] = halves(piece.points);
            const double middle = (piece.low.y + piece.high.y) / 2;
            across({first, piece.low, {piece.high.x, middle}}, u_step, v_step + 1);
            across({last, {piece.low.x, middle}, piece.high}, u_step, v_step + 1);
        } else if (!flat && u_step < patch_.u_steps) {
            across(piece, u_step, v_step);
        } else {
            add(piece);
        }
    }

private:
    void across(const Piece& piece, int u_step, int v_step) {
        if (u_step >= patch_.u_steps) return divide(piece, u_step, v_step);
        const auto [first, last] = halves(transposed(piece.points));
        const double middle = (piece.low.x + piece.high.x) / 2;
        divide({transposed(first), piece.low, {middle, piece.high.y}}, u_step + 1, v_step);
        divide({transposed(last), {middle, piece.low.y}, piece.high}, u_step + 1, v_step);
    }

    /// Interpolates u and v of the corners.
    Vec2 uv(double across_rows, double along_row) const {
        const Vec2 first = patch_.uv1 + along_row * (patch_.uv2 - patch_.uv1);
        const Vec2 last = patch_.uv4 + along_row * (patch_.uv3 - patch_.uv4);
        return first + across_rows * (last - first);
    }

    void add(const Piece& piece) {
        const Points& p = piece.points;
        const Vec3 n00 = corner_normal(p, 0, 0), n03 = corner_normal(p, 0, 3),
                   n33 = corner_normal(p, 3, 3), n30 = corner_normal(p, 3, 0);
        const Vec2 uv00 = uv(piece.low.x, piece.low.y), uv03 = uv(piece.low.x, piece.high.y),
                   uv33 = uv(piece.high.x, piece.high.y), uv30 = uv(piece.high.x, piece.low.y);
        add({{p[0][0], p[0][3], p[3][3]}, {n00, n03, n33}, {uv00, uv03, uv33}});
        add({{p[0][0], p[3][3], p[3][0]}, {n00, n33, n30}, {uv00, uv33, uv30}});
    }

    void add(BuiltBicubicPatch::Facet facet) {
        const auto& c = facet.corners;
        const Vec3 own = triangle_normal(c[0], c[2], c[1]);
        if (own == Vec3(0)) return;
        for (Vec3& normal : facet.normals)
            if (normal == Vec3(0)) normal = own;
        result_.facets.push_back(facet);
    }

    const BicubicPatch& patch_;
    BuiltBicubicPatch& result_;
};

}  // namespace

std::string problem(const BicubicPatch& patch) {
    if (patch.type < 0) return "a `bicubic_patch` needs a `type`, 0 or 1";
    return patch.points.size() == 16 ? "" : "a `bicubic_patch` needs 16 points";
}

BuiltBicubicPatch build(const BicubicPatch& patch, const RayIndex& index) {
    Points points;
    for (std::size_t i = 0; i < 16; ++i) points[i / 4][i % 4] = patch.points[i];
    BuiltBicubicPatch result;
    Divider(patch, result).divide({points}, 0, 0);
    std::vector<Box> boxes((result.facets.size() + facets_of_part - 1) / facets_of_part);
    for (std::size_t i = 0; i < result.facets.size(); ++i)
        for (const Vec3& corner : result.facets[i].corners) {
            Box& box = boxes[i / facets_of_part];
            box = join(box, corner);
        }
    result.index = PartIndex(std::move(boxes), index);
    return result;
}

Box bounds(const BuiltBicubicPatch& patch) { return patch.index.bounds(); }

void crossings(const BuiltBicubicPatch& patch, const Ray& ray, Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const ShearedRay sheared(ray);
    const auto meet = [&](std::uint32_t i) {
        const auto& [corners, normals, uvs] = patch.facets[i];
        const TriangleHit hit = sheared.meet(corners[0], corners[1], corners[2], whole_line);
        if (!(hit.t < whole_line.max)) return;
        const Vec3 normal = unit((1 - hit.weight2 - hit.weight3) * normals[0] +
                                 hit.weight2 * normals[1] + hit.weight3 * normals[2]);
        if (normal != Vec3(0)) found.add({hit.t, normal, dot(ray.direction, normal) < 0, i});
    };
    const auto count = static_cast<std::uint32_t>(patch.facets.size());
    patch.index.along(ray, whole_line, [&](std::uint32_t part) {
        const std::uint32_t first = part * facets_of_part;
        for (std::uint32_t i = first; i < std::min(first + facets_of_part, count); ++i) meet(i);
    });
}

bool inside(const BuiltBicubicPatch&, const Vec3&) { return false; }

}  // namespace candelabra
