// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/leaf_pack.h"

#include "base/every_machine.h"

#include <cstring>

namespace {

using Floats [[gnu::vector_size(sizeof(float) * pack_lanes)]] = float;
using Marks [[gnu::vector_size(sizeof(float) * pack_lanes)]] = std::int32_t;

// Bounds of rounding errors, as shares of the numbers that they come from. They are generous: a
// lane too many costs an exact test, one too few a hole.
constexpr double float_error = 0x1p-19;
constexpr double double_error = 0x1p-46;
/// Below this, products lose their digits.
constexpr float tiny = 1e-36f;

float rounded_up(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest < x ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

[[gnu::always_inline]] inline void load(Floats& lanes, const float* row) {
    std::memcpy(&lanes, row, sizeof lanes);
}

/// A bit for each marked lane.
[[gnu::always_inline]] inline std::uint32_t lanes_of(const Marks& marks) {
#ifdef __x86_64__
    // What every such machine has; through the memory it takes twice as long.
    using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
    const auto low = std::bit_cast<Four>(__builtin_shufflevector(marks, marks, 0, 1, 2, 3));
    const auto high = std::bit_cast<Four>(__builtin_shufflevector(marks, marks, 4, 5, 6, 7));
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(low) | __builtin_ia32_movmskps(high)
                                                                         << 4);
#else
    constexpr Marks bits = {1, 2, 4, 8, 16, 32, 64, 128};
    const auto quarters = std::bit_cast<std::array<std::uint64_t, 4> >(marks & bits);
    const std::uint64_t pairs = (quarters[0] | quarters[2]) | (quarters[1] | quarters[3]);
    return static_cast<std::uint32_t>(pairs | pairs >> 32);
#endif
}

[[gnu::always_inline]] inline void take_roots(Floats& of) {
    for (std::size_t i = 0; i < pack_lanes; ++i) of[i] = std::sqrt(of[i]);
}

}  // namespace

void pack_leaf(const PackedKinds& kinds, std::span<const std::uint32_t> items, const Box& cell,
               std::vector<float>& packs) {
    const Vec3 middle = cell.centre();
    const std::array anchor = {static_cast<float>(middle.x), static_cast<float>(middle.y),
                               static_cast<float>(middle.z)};
    const Vec3 from(anchor[0], anchor[1], anchor[2]);
    const auto triangles_begin = std::ranges::lower_bound(items, kinds.triangles_begin);
    const auto others_begin = std::ranges::lower_bound(items, kinds.others_begin);
    const auto spheres = static_cast<std::uint32_t>(triangles_begin - items.begin());
    const auto triangles = static_cast<std::uint32_t>(others_begin - triangles_begin);
    const auto others = static_cast<std::uint32_t>(items.end() - others_begin);
    const double size = length(cell.size());
    double reach = size + max_abs_component(middle - from);

    const std::size_t head = packs.size();
    packs.resize(head + pack_head + 4 * std::size_t{spheres} + 9 * std::size_t{triangles} +
                 6 * std::size_t{others});
    float* row = packs.data() + head + pack_head;
    for (std::uint32_t i = 0; i < spheres; ++i) {
        const auto [centre, radius] = kinds.sphere(items[i]);
        for (int axis = 0; axis < 3; ++axis)
            row[axis * spheres + i] = static_cast<float>(centre[axis] - from[axis]);
        row[3 * spheres + i] = rounded_up(radius + float_error * (radius + reach));
    }
    row += 4 * std::size_t{spheres};
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const auto corners = kinds.corners(items[spheres + i]);
        for (std::size_t k = 0; k < 9; ++k) {
            const int axis = static_cast<int>(k % 3);
            const double x = corners[k / 3][axis] - from[axis];
            reach = std::fmax(reach, std::abs(x));
            row[k * triangles + i] = static_cast<float>(x);
        }
    }
    row += 9 * std::size_t{triangles};
    for (std::uint32_t i = 0; i < others; ++i) {
        const Box box = clip(kinds.box(items[spheres + triangles + i]), cell);
        for (int axis = 0; axis < 3; ++axis) {
            row[axis * others + i] = static_cast<float>(box.low[axis] - from[axis]);
            row[(3 + axis) * others + i] = static_cast<float>(box.high[axis] - from[axis]);
        }
    }
    std::ranges::copy(anchor, packs.begin() + static_cast<std::ptrdiff_t>(head));
    packs[head + 3] = rounded_up(2 * reach);
    packs[head + 4] = std::bit_cast<float>(spheres);
    packs[head + 5] = std::bit_cast<float>(triangles);
}

void PackRay::prepare() {
    length_ = length(direction_);
    // Directions that have no length in numbers rule out nothing: comparisons with NaN fail.
    if (!(length_ > 1e-150 && length_ < 1e150)) length_ = std::numeric_limits<double>::quiet_NaN();
    const double shorter = 1 / length_;
    for (int axis = 0; axis < 3; ++axis)
        along_[axis] = static_cast<float>(direction_[axis] * shorter);
    for (int axis = 0; axis < 3; ++axis) steps_[axis] = 1 / along_[axis];
    const Vec3 size = glm::abs(direction_);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (x_ + 1) % 3;
    const double upright = 1 / direction_[z_];
    shear_ = {static_cast<float>(direction_[x_] * upright),
              static_cast<float>(direction_[y_] * upright)};
}

void PackRay::start(const KdLeaf& leaf, const Interval& range) {
    if (length_ == 0) prepare();
    double largest = std::abs(leaf.entry) * length_;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = leaf.pack[axis];
        point_[axis] = static_cast<float>(origin_[axis] - from + leaf.entry * direction_[axis]);
        largest += std::abs(origin_[axis]);
    }
    slack_ = static_cast<float>(double_error * largest);
    least_ = static_cast<float>((range.min - leaf.entry) * length_);
    most_ = static_cast<float>((range.max - leaf.entry) * length_);
    reach_ = leaf.pack[3];
    margin_ = reach_ * (static_cast<float>(float_error) * reach_ + 16 * slack_) + tiny;
}

/// By the distance of the closest approach, and by where the ray enters and leaves the sphere.
template <bool sure>
[[gnu::always_inline]] inline PackRay::Lanes PackRay::ask_spheres(const float* rows,
                                                                  std::size_t stride) const {
    Floats x, y, z, radius;
    load(x, rows);
    load(y, rows + stride);
    load(z, rows + 2 * stride);
    load(radius, rows + 3 * stride);
    x = x - point_[0];
    y = y - point_[1];
    z = z - point_[2];
    radius = radius + slack_;
    const Floats along = x * along_[0] + y * along_[1] + z * along_[2];
    x = x - along * along_[0];
    y = y - along * along_[1];
    z = z - along * along_[2];
    const Floats off2 = x * x + y * y + z * z;
    const Floats spare = radius * radius + tiny - off2;
    Floats half = spare;
    take_roots(half);
    const Floats pad = static_cast<float>(float_error) * (radius + reach_) + slack_;
    const std::uint32_t near =
        lanes_of(~((spare < 0) | (along - half > most_ + pad) | (along + half < least_ - pad)));
    if (!sure || near == 0) return {near, 0};
    // The radius as it was, and as much less as it had been made more. Comparisons with NaN, the
    // root of what is negative, are false.
    const Floats inner = radius - 4 * pad;
    Floats least_half = inner * inner - off2;
    take_roots(least_half);
    const Marks enters = (along - half > least_ + pad) & (along - least_half < most_ - pad);
    const Marks leaves = (along + least_half > least_ + pad) & (along + half < most_ - pad);
    return {near, lanes_of((inner > 0) & (enters | leaves))};
}

CANDELABRA_EVERY_MACHINE PackRay::Lanes PackRay::near_spheres(const float* rows,
                                                              std::size_t stride) const {
    return ask_spheres<false>(rows, stride);
}

CANDELABRA_EVERY_MACHINE PackRay::Lanes PackRay::sure_spheres(const float* rows,
                                                              std::size_t stride) const {
    return ask_spheres<true>(rows, stride);
}

/// As ShearedRay does.
CANDELABRA_EVERY_MACHINE PackRay::Lanes PackRay::near_triangles(const float* rows,
                                                                std::size_t stride) const {
    std::array<Floats, 3> x, y, z;
    const float x0 = point_[x_], y0 = point_[y_], z0 = point_[z_];
    for (int corner = 0; corner < 3; ++corner) {
        const float* const first = rows + 3 * corner * stride;
        load(x[corner], first + x_ * stride);
        load(y[corner], first + y_ * stride);
        load(z[corner], first + z_ * stride);
        z[corner] = z[corner] - z0;
        x[corner] = x[corner] - x0 - shear_[0] * z[corner];
        y[corner] = y[corner] - y0 - shear_[1] * z[corner];
    }
    const Floats u = x[2] * y[1] - y[2] * x[1];
    const Floats v = x[0] * y[2] - y[0] * x[2];
    const Floats w = x[1] * y[0] - y[1] * x[0];
    const Marks left = (u < -margin_) | (v < -margin_) | (w < -margin_);
    const Marks right = (u > margin_) | (v > margin_) | (w > margin_);
    const Marks within = ((u > margin_) & (v > margin_) & (w > margin_)) |
                         ((u < -margin_) & (v < -margin_) & (w < -margin_));
    // The crossing lies between the corners as the edges weigh them; what these may be wrong by
    // moves it the more, the more the triangle is seen edge-on.
    const Floats sum = u + v + w;
    const Floats along = (u * z[0] + v * z[1] + w * z[2]) / (sum * along_[z_]);
    const Floats rise = z[1] - z[0], fall = z[2] - z[1];
    const Floats depth = (rise < 0 ? -rise : rise) + (fall < 0 ? -fall : fall);
    const Floats pad = 8 * margin_ * depth / (sum < 0 ? -sum : sum) +
                       8 * (static_cast<float>(float_error) * reach_ + slack_);
    const Marks outside = (along > most_ + pad) | (along < least_ - pad);
    return {lanes_of(~((left & right) | (within & outside))),
            lanes_of(within & (along > least_ + pad) & (along < most_ - pad))};
}

/// By where the ray enters and leaves the slabs between opposite faces. For a ray that runs along a
/// face these are at infinity, or NaN, which rules out nothing.
CANDELABRA_EVERY_MACHINE std::uint32_t PackRay::near_boxes(const float* rows,
                                                           std::size_t stride) const {
    const float rounding = static_cast<float>(float_error) * reach_ + 4 * slack_;
    const float pad = 4 * rounding;
    Floats near = Floats{} + (least_ - pad), far = Floats{} + (most_ + pad);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool backward = std::signbit(steps_[axis]);
        const float wider = backward ? -rounding : rounding;
        Floats in, out;
        load(in, rows + (backward ? 3 + axis : axis) * stride);
        load(out, rows + (backward ? axis : 3 + axis) * stride);
        in = (in - (point_[axis] + wider)) * steps_[axis];
        out = (out - (point_[axis] - wider)) * steps_[axis];
        near = in > near ? in : near;
        far = out < far ? out : far;
    }
    return lanes_of(~(near > far + pad));
}
