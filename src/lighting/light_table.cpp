// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_table.h"

#include "base/running_sums.h"
#include "base/target_clones.h"
#include "lighting/tuning.h"

#include <algorithm>

namespace candelabra {

namespace {

struct ProxyColumns {
    const double *x, *y, *z, *radius, *strength;
    const double *axis_x, *axis_y, *axis_z, *evenness, *exact_within2;
};

template <Horizon horizon>
[[gnu::always_inline]] inline void estimate_even(const ProxyColumns& c, std::size_t count,
                                                 const Receiver& point, double* out) {
    const Vec3 p = point.position, n = point.normal;
    for (std::size_t i = 0; i < count; ++i)
        out[i] = irradiance<horizon>(Vec3(c.x[i] - p.x, c.y[i] - p.y, c.z[i] - p.z), n, c.radius[i],
                                     c.strength[i], c.radius[i]);
}

/// A negative sign marks an estimate to be replaced. -0 is not replaced, because nothing is above
/// the horizon then.
[[gnu::always_inline]] inline void turn_to_point(const ProxyColumns& c, std::size_t count,
                                                 const Vec3& p, double* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 v(c.x[i] - p.x, c.y[i] - p.y, c.z[i] - p.z);
        const double estimate =
            out[i] *
            facing(v, c.radius[i], Vec3(c.axis_x[i], c.axis_y[i], c.axis_z[i]), c.evenness[i]);
        const double d2 = v.x * v.x + v.y * v.y + v.z * v.z;
        out[i] = d2 < c.exact_within2[i] ? -estimate : estimate;
    }
}

CANDELABRA_TARGET_CLONES
void estimate_rows(const ProxyColumns& c, std::size_t count, const Receiver& point, double* out) {
    if (point.horizon == Horizon::one_side)
        estimate_even<Horizon::one_side>(c, count, point, out);
    else if (point.horizon == Horizon::both_sides)
        estimate_even<Horizon::both_sides>(c, count, point, out);
    else
        estimate_even<Horizon::none>(c, count, point, out);
    if (c.axis_x) turn_to_point(c, count, point.position, out);
}

/// Adds up in strands, in a fixed order.
double sum_rows(const double* rows, std::size_t count) {
    std::array<double, LightTable::lanes> strand{};
    for (std::size_t i = 0; i < count; i += LightTable::lanes)
        for (std::size_t j = 0; j < LightTable::lanes; ++j) strand[j] += rows[i + j];
    return ((strand[0] + strand[1]) + (strand[2] + strand[3])) +
           ((strand[4] + strand[5]) + (strand[6] + strand[7]));
}

std::size_t padded(std::size_t count) {
    return (count + LightTable::lanes - 1) / LightTable::lanes * LightTable::lanes;
}

}  // namespace

LightTable::LightTable(std::shared_ptr<const ChoosableLights> lights)
    : choosable_(std::move(lights)), records_(choosable_ ? choosable_->size() : 0) {
    for (LightIndex light = 0; light < records_.size(); ++light) {
        Record& record = records_[light];
        record.proxy = candelabra::light_proxy(choosable_->bounds(light));
        record.proxy.half = LightProxy().half;  // the rows know spheres only
        const double reach = tuning::exact_radii * record.proxy.radius;
        if (choosable_->exact_nearby(light)) record.exact_within2 = reach * reach;
        flat_ = flat_ || record.proxy.axis != Vec3(0);
    }
}

double LightTable::estimate(LightIndex light, const Receiver& point) const {
    const Record& record = records_[light];
    const double rough = irradiance(record.proxy, point);
    const Vec3 v = record.proxy.centre - point.position;
    const bool near = v.x * v.x + v.y * v.y + v.z * v.z < record.exact_within2;
    return near && rough > 0 ? choosable_->unoccluded(light, point) : rough;
}

void LightTable::reserve(std::size_t lists, std::size_t lights) {
    const std::size_t rows = lights_.size() + lights + lists * (lanes - 1);
    lights_.reserve(rows);
    for (auto* column : {&x_, &y_, &z_, &radius_, &strength_}) column->reserve(rows);
    if (flat_)
        for (auto* column : {&axis_x_, &axis_y_, &axis_z_, &evenness_, &exact_within2_})
            column->reserve(rows);
}

LightList LightTable::append(std::span<const LightIndex> lights) {
    const LightList list{lights_.size(), lights.size()};
    Record nothing;
    for (std::size_t i = 0; i < padded(lights.size()); ++i) {
        const Record& record = i < lights.size() ? records_[lights[i]] : nothing;
        const LightProxy& g = record.proxy;
        lights_.push_back(i < lights.size() ? lights[i] : 0);
        x_.push_back(g.centre.x);
        y_.push_back(g.centre.y);
        z_.push_back(g.centre.z);
        radius_.push_back(g.radius);
        strength_.push_back(g.strength);
        if (!flat_) continue;
        axis_x_.push_back(g.axis.x);
        axis_y_.push_back(g.axis.y);
        axis_z_.push_back(g.axis.z);
        evenness_.push_back(g.evenness);
        exact_within2_.push_back(record.exact_within2);
    }
    return list;
}

void LightTable::estimate_block(std::size_t first, std::size_t count, const Receiver& point,
                                double* out) const {
    const auto column = [&](const std::vector<double>& c) {
        return flat_ ? c.data() + first : nullptr;
    };
    estimate_rows({x_.data() + first, y_.data() + first, z_.data() + first, radius_.data() + first,
                   strength_.data() + first, column(axis_x_), column(axis_y_), column(axis_z_),
                   column(evenness_), column(exact_within2_)},
                  count, point, out);
    if (!flat_) return;
    for (std::size_t i = 0; i < count; ++i)
        if (out[i] < 0) out[i] = choosable_->unoccluded(lights_[first + i], point);
}

std::size_t LightTable::part_length(const LightList& list) {
    if (padded(list.count) <= max_parts) return 1;
    return ((list.count + max_parts - 1) / max_parts + block - 1) / block * block;
}

void LightTable::sum(const LightList& list, const Receiver& point, Sums& sums) const {
    const std::size_t rows = padded(list.count), length = part_length(list);
    if (length == 1) {
        for (std::size_t i = 0; i < rows; i += block)
            estimate_block(list.first + i, std::min(block, rows - i), point, sums.part.data() + i);
        sums.total = sum_rows(sums.part.data(), rows);
        return;
    }
    Block estimates;
    sums.total = 0;
    for (std::size_t part = 0; part * length < rows; ++part) {
        double sum = 0;
        for (std::size_t i = part * length; i < std::min((part + 1) * length, rows); i += block) {
            const std::size_t count = std::min(block, rows - i);
            estimate_block(list.first + i, count, point, estimates.data());
            sum += sum_rows(estimates.data(), count);
        }
        sums.part[part] = sum;
        sums.total += sum;
    }
}

LightTable::Row LightTable::find(const LightList& list, const Receiver& point, const Sums& sums,
                                 double target) const {
    const std::size_t rows = padded(list.count), length = part_length(list);
    // Rounding may carry the target past the end of the list or of a part: then the last possible
    // row is taken.
    const ChosenWeight part =
        choose(std::span(sums.part).first((rows + length - 1) / length), target);
    if (length == 1) return {list.first + part.index, part.weight};
    if (!part.passed) target = std::numeric_limits<double>::infinity();
    Block estimates;
    Row found{list.first, 0};
    for (std::size_t i = part.index * length; i < std::min((part.index + 1) * length, rows);
         i += block) {
        const std::size_t count = std::min(block, rows - i);
        estimate_block(list.first + i, count, point, estimates.data());
        const ChosenWeight row = choose(std::span<const double>(estimates).first(count), target);
        if (row.weight > 0) found = {list.first + i + row.index, row.weight};
        if (row.passed) break;
    }
    return found;
}

std::size_t LightTable::memory_bytes() const {
    const std::size_t columns = x_.capacity() + y_.capacity() + z_.capacity() + radius_.capacity() +
                                strength_.capacity() + axis_x_.capacity() + axis_y_.capacity() +
                                axis_z_.capacity() + evenness_.capacity() +
                                exact_within2_.capacity();
    return columns * sizeof(double) + lights_.capacity() * sizeof(LightIndex) +
           records_.capacity() * sizeof(Record);
}

}  // namespace candelabra
