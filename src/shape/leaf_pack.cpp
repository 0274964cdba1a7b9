// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/leaf_pack.h"

#include "base/lanes.h"
#include "base/round_outward.h"
#include "base/target_clones.h"

#include <cstring>

namespace candelabra {

namespace {

// Relative bounds of rounding errors. They are generous: a false candidate costs an exact test, a
// missed one leaves a hole.
constexpr double float_error = 0x1p-19;
// The entry point of a leaf is known in single precision, so its distance from the leaf may exceed
// the leaf's size.
constexpr double double_error = 0x1p-43;
/// Products below this lose their digits.
constexpr float tiny = 1e-36f;

/// Mask of the first `count` bits.
std::uint32_t bits(std::uint32_t count) { return (1u << count) - 1; }

/// Numbers of the items of each kind in a leaf.
struct Counts {
    std::uint32_t spheres, triangles, others;

    Counts(const PackedKinds& kinds, std::span<const std::uint32_t> items) {
        const auto below = [&](std::uint32_t end) {
            const auto last = std::ranges::lower_bound(items, end);
            return static_cast<std::uint32_t>(last - items.begin());
        };
        spheres = below(kinds.triangles_begin);
        triangles = below(kinds.others_begin) - spheres;
        others = static_cast<std::uint32_t>(items.size()) - spheres - triangles;
    }
};

void put(std::uint32_t& word, double x) {
    word = std::bit_cast<std::uint32_t>(static_cast<float>(x));
}

void fill_pack(const PackedKinds& kinds, std::span<const std::uint32_t> items, const Box& around,
               std::span<std::uint32_t> words) {
    const Vec3 middle = around.centre();
    const auto [spheres, triangles, others] = Counts(kinds, items);
    for (int axis = 0; axis < 3; ++axis) put(words[static_cast<std::size_t>(axis)], middle[axis]);
    const Vec3 from(static_cast<float>(middle.x), static_cast<float>(middle.y),
                    static_cast<float>(middle.z));
    const double size = length(around.size());
    double reach = size + max_abs_component(middle - from);

    std::uint32_t* row = words.data() + pack_head;
    for (std::uint32_t i = 0; i < spheres; ++i) {
        const auto [centre, radius] = kinds.sphere(items[i]);
        for (int axis = 0; axis < 3; ++axis)
            put(row[axis * spheres + i], centre[axis] - from[axis]);
        put(row[3 * spheres + i], rounded_up(radius + float_error * (radius + reach)));
    }
    row += 4 * std::size_t{spheres};
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const auto corners = kinds.corners(items[spheres + i]);
        for (std::size_t k = 0; k < 9; ++k) {
            const int axis = static_cast<int>(k % 3);
            const double x = corners[k / 3][axis] - from[axis];
            reach = std::fmax(reach, std::abs(x));
            put(row[k * triangles + i], x);
        }
    }
    row += 9 * std::size_t{triangles};
    for (std::uint32_t i = 0; i < others; ++i) {
        const Box box = kinds.box(items[spheres + triangles + i]);
        for (int axis = 0; axis < 3; ++axis) {
            put(row[axis * others + i], box.low[axis] - from[axis]);
            put(row[(3 + axis) * others + i], box.high[axis] - from[axis]);
        }
    }
    put(words[3], rounded_up(2 * reach));
    words[4] = spheres;
    words[5] = triangles;
}

}  // namespace

LeafPacks leaf_packs(PackedKinds kinds) {
    const auto size = [kinds](std::span<const std::uint32_t> items) {
        const Counts count(kinds, items);
        return pack_head + 4 * std::size_t{count.spheres} + 9 * std::size_t{count.triangles} +
               6 * std::size_t{count.others};
    };
    const auto fill = [kinds](std::span<const std::uint32_t> items, const Box& around,
                              std::span<std::uint32_t> words) {
        fill_pack(kinds, items, around, words);
    };
    return {size, fill};
}

void PackRay::prepare() {
    const Vec3 &origin = ray_.origin, &direction = ray_.direction;
    const double length2 = dot(direction, direction);
    origin_size_ = std::abs(origin.x) + std::abs(origin.y) + std::abs(origin.z);
    // Nearly all directions have this length, and need not wait for a square root.
    constexpr double nearly = 0x1p-30;
    length_ = 1;
    double shorter = 1;
    if (!(std::abs(length2 - 1) < nearly)) {
        length_ = std::sqrt(length2);
        // Directions without a finite length rule out nothing: comparisons with NaN fail.
        if (!(length_ > 1e-150 && length_ < 1e150))
            length_ = std::numeric_limits<double>::quiet_NaN();
        shorter = 1 / length_;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        along_[axis] = static_cast<float>(direction[static_cast<int>(axis)] * shorter);
}

void PackRay::prepare_for_triangles() {
    sheared_ = true;
    const Vec3& direction = ray_.direction;
    const Vec3 size = glm::abs(direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (x_ + 1) % 3;
    const double upright = 1 / direction[static_cast<int>(z_)];
    shear_ = {static_cast<float>(direction[static_cast<int>(x_)] * upright),
              static_cast<float>(direction[static_cast<int>(y_)] * upright)};
}

/// A ray at one leaf, in units of length.
struct PackRay::Here {
    using Four [[gnu::vector_size(4 * sizeof(float))]] = float;

    Four point;         ///< entry point into the leaf
    float least, most;  ///< the range, relative to the entry point
    float slack;        ///< rounding error of points along the ray in doubles
    float reach;        ///< largest coordinate in the leaf

    [[gnu::always_inline]] Here(const PackRay& ray, const TreeLeaf& leaf, const Interval& range) {
        using FourDoubles [[gnu::vector_size(4 * sizeof(double))]] = double;
        Four anchor;  // and the reach
        std::memcpy(&anchor, leaf.pack, sizeof anchor);
        const Vec3 &o = ray.ray_.origin, &d = ray.ray_.direction;
        const FourDoubles origin{o.x, o.y, o.z, 0}, direction{d.x, d.y, d.z, 0};
        point = __builtin_convertvector(
            origin - __builtin_convertvector(anchor, FourDoubles) + leaf.entry * direction, Four);
        reach = anchor[3];
        const double before = leaf.entry * ray.length_;
        slack = static_cast<float>(double_error * (std::abs(before) + ray.origin_size_));
        least = static_cast<float>(range.min * ray.length_ - before);
        most = static_cast<float>(range.max * ray.length_ - before);
    }
};

/// Tests the distance of the closest approach, and the points where the ray enters and leaves the
/// sphere, half a chord before and behind it. Distances are compared with half a chord by squares.
template <bool sure>
[[gnu::always_inline]] inline PackRay::Answer PackRay::look_at_spheres(const Here& here,
                                                                       const std::uint32_t* rows,
                                                                       std::uint32_t count) const {
    Lanes x = load_lanes(rows) - here.point[0];
    Lanes y = load_lanes(rows + count) - here.point[1];
    Lanes z = load_lanes(rows + 2 * count) - here.point[2];
    const Lanes radius = load_lanes(rows + 3 * count) + here.slack;
    const Lanes along = x * along_[0] + y * along_[1] + z * along_[2];
    x = x - along * along_[0];
    y = y - along * along_[1];
    z = z - along * along_[2];
    const Lanes off2 = x * x + y * y + z * z;
    const Lanes half2 = radius * radius + tiny - off2;
    const Lanes pad = static_cast<float>(float_error) * (radius + here.reach) + here.slack;
    const auto shorter_than = [&](const Lanes& way) __attribute__((always_inline)) {
        return (way > 0) & (half2 < way * way);
    };
    const std::uint32_t near =
        bits(count) & marked(~((half2 < 0) | shorter_than(along - here.most - pad) |
                               shorter_than(here.least - pad - along)));
    if (!sure || near == 0) return {near, 0};
    // Shrinks the radius by as much as it was enlarged. A hit stays in doubt if the range begins
    // behind the middle of the chord or ends before it.
    const Lanes inner = radius - 4 * pad;
    const Marks from = along > here.least + pad, to = along < here.most - pad;
    const Marks enters = to & shorter_than(along - here.least - pad);
    const Marks leaves = from & shorter_than(here.most - pad - along);
    return {near, near & marked((inner > 0) & (off2 < inner * inner) & (enters | leaves))};
}

/// Same method as ShearedRay.
[[gnu::always_inline]] inline PackRay::Answer PackRay::look_at_triangles(
    const Here& here, const std::uint32_t* rows, std::uint32_t count) const {
    const float margin =
        here.reach * (static_cast<float>(float_error) * here.reach + 16 * here.slack) + tiny;
    std::array<float, 4> point;
    std::memcpy(&point, &here.point, sizeof point);
    std::array<Lanes, 3> x, y, z;
    // Unrolled, so that they stay in registers.
#pragma GCC unroll 3
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t* const first = rows + 3 * corner * count;
        z[corner] = load_lanes(first + z_ * count) - point[z_];
        x[corner] = load_lanes(first + x_ * count) - point[x_] - shear_[0] * z[corner];
        y[corner] = load_lanes(first + y_ * count) - point[y_] - shear_[1] * z[corner];
    }
    const Lanes u = x[2] * y[1] - y[2] * x[1];
    const Lanes v = x[0] * y[2] - y[0] * x[2];
    const Lanes w = x[1] * y[0] - y[1] * x[0];
    const Lanes least = min_of(min_of(u, v), w), most = greatest_of(greatest_of(u, v), w);
    const std::uint32_t near = bits(count) & marked(~((least < -margin) & (most > margin)));
    if (near == 0) return {0, 0};
    const Marks within = (least > margin) | (most < -margin);
    // The hit is the average of the corners, weighted by the edges' values. Errors of the weights
    // move it the more, the more the triangle is seen edge-on.
    const Lanes sum = u + v + w;
    const Lanes along = (u * z[0] + v * z[1] + w * z[2]) / (sum * along_[z_]);
    const Lanes rise = z[1] - z[0], fall = z[2] - z[1];
    const Lanes depth = (rise < 0 ? -rise : rise) + (fall < 0 ? -fall : fall);
    const Lanes pad = 8 * margin * depth / (sum < 0 ? -sum : sum) +
                      8 * (static_cast<float>(float_error) * here.reach + here.slack);
    const Marks outside = (along > here.most + pad) | (along < here.least - pad);
    return {near & marked(~(within & outside)),
            near & marked(within & (along > here.least + pad) & (along < here.most - pad))};
}

/// Tests where the ray enters and leaves the slabs between opposite faces. For a ray parallel to a
/// face these parameters are infinite or NaN, and rule out nothing.
[[gnu::always_inline]] inline std::uint32_t PackRay::look_at_boxes(const Here& here,
                                                                   const std::uint32_t* rows,
                                                                   std::uint32_t count) const {
    if (count <= few_boxes) return bits(count);
    const float rounding = static_cast<float>(float_error) * here.reach + 4 * here.slack;
    const float pad = 4 * rounding;
    Lanes near = lanes_of(here.least - pad), far = lanes_of(here.most + pad);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float step = 1 / along_[axis];
        const bool backward = std::signbit(step);
        const float wider = backward ? -rounding : rounding;
        const std::uint32_t* const low = rows + axis * count;
        const std::uint32_t* const high = rows + (3 + axis) * count;
        const Lanes in =
            load_lanes(backward ? high : low) - (here.point[static_cast<int>(axis)] + wider);
        const Lanes out =
            load_lanes(backward ? low : high) - (here.point[static_cast<int>(axis)] - wider);
        near = greatest_of(in * step, near);
        far = min_of(out * step, far);
    }
    return bits(count) & marked(~(near > far + pad));
}

template <bool sure>
[[gnu::always_inline]] inline PackRay::Answer PackRay::look_at(const TreeLeaf& leaf,
                                                               const Interval& range) const {
    const Here here(*this, leaf, range);
    const std::uint32_t spheres = leaf.pack[4], triangles = leaf.pack[5];
    const std::uint32_t first_other = spheres + triangles;
    const auto others = static_cast<std::uint32_t>(leaf.items.size()) - first_other;
    const std::uint32_t* rows = leaf.pack + pack_head;
    Answer answer{0, 0};
    if (spheres > 0) answer = look_at_spheres<sure>(here, rows, spheres);
    rows += 4 * std::size_t{spheres};
    if (triangles > 0) {
        const Answer more = look_at_triangles(here, rows, triangles);
        answer = {answer.near | more.near << spheres, answer.sure | more.sure};
    }
    rows += 9 * std::size_t{triangles};
    if (others > 0) answer.near |= look_at_boxes(here, rows, others) << first_other;
    return answer;
}

CANDELABRA_TARGET_CLONES std::uint32_t PackRay::near(const TreeLeaf& leaf,
                                                     const Interval& range) const {
    return look_at<false>(leaf, range).near;
}

CANDELABRA_TARGET_CLONES PackRay::Answer PackRay::near_or_sure(const TreeLeaf& leaf,
                                                               const Interval& range) const {
    return look_at<true>(leaf, range);
}

}  // namespace candelabra
