// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_cut.h"

#include "base/every_machine.h"

#include <algorithm>
#include <bit>

namespace {

/// Shares of the whole strength below this one count as this: single precision would lose them.
constexpr double least_strength = 1e-24;
/// Radius over distance at which rounding in single precision may still lift an entry over the
/// horizon.
constexpr float slack = 1e-6f;
/// Single luminaires that outshine all clusters so many times are left out when the noise of these
/// is judged: they may turn out to be hidden.
constexpr double outshining = 20;

struct Columns {
    const float *x, *y, *z, *radius, *strength;
    const float *axis_x, *axis_y, *axis_z, *evenness;
    const float *half_x, *half_y, *half_z;
    const float *lean_x, *lean_y, *lean_z, *lean;
};
struct SourceColumns {
    const float *fade_power, *per_fade_distance, *dark, *per_edge;
};
struct Place {
    float x, y, z, nx, ny, nz;
};

/// A block of rows. Arithmetic on local arrays of known length, which nothing else can refer to, is
/// what compilers turn into vectors.
constexpr std::size_t block = CutWeights::block;
using Rows = std::array<float, block>;

/// The formula of irradiance() in glow.h, in single precision and with wider margins.
template <bool both_sides>
[[gnu::always_inline]] inline void weigh_even(const Columns& c, std::size_t first, const Place& p,
                                              Rows& out) {
    const float steep_x = std::abs(p.nx), steep_y = std::abs(p.ny), steep_z = std::abs(p.nz);
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const float vx = c.x[row] - p.x, vy = c.y[row] - p.y, vz = c.z[row] - p.z;
        const float radius = c.radius[row], r2 = radius * radius;
        const float d2 = vx * vx + vy * vy + vz * vz;
        const float outside2 = d2 > r2 ? d2 : r2;
        const float distance = std::sqrt(outside2);
        const float inverse = 1 / distance;
        const float signed_height = p.nx * vx + p.ny * vy + p.nz * vz;
        const float height = both_sides ? std::abs(signed_height) : signed_height;
        const float of_box =
            steep_x * c.half_x[row] + steep_y * c.half_y[row] + steep_z * c.half_z[row];
        const float least = 1e-3f * radius, wide = of_box > least ? of_box : least;
        const float reach = wide < radius ? wide : radius;
        const float cut = height < reach ? height : reach;
        float lifted = cut + reach + slack * distance;
        lifted = lifted > 0 ? lifted : 0;
        const float partly =
            both_sides ? 0.5f * (cut * cut / reach + reach) : 0.25f * lifted * lifted / reach;
        const float above = partly + (height - cut);
        const float surrounded = both_sides ? 2 * reach : reach;
        const float within = d2 < r2 ? surrounded : 0;
        out[i] = c.strength[row] * radius * (above > within ? above : within) * inverse * inverse *
                 inverse;
    }
}

[[gnu::always_inline]] inline void turn_to_point(const Columns& c, std::size_t first,
                                                 const Place& p, Rows& out) {
    constexpr auto kept = static_cast<float>(least_leaning);
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const float vx = c.x[row] - p.x, vy = c.y[row] - p.y, vz = c.z[row] - p.z;
        const float r2 = c.radius[row] * c.radius[row];
        const float d2 = vx * vx + vy * vy + vz * vz;
        const float along = std::abs(c.axis_x[row] * vx + c.axis_y[row] * vy + c.axis_z[row] * vz);
        const float leaning = c.lean_x[row] * vx + c.lean_y[row] * vy + c.lean_z[row] * vz;
        const float inverse = 1 / std::sqrt(d2 > r2 ? d2 : r2);
        const float seen = c.evenness[row] + (along - leaning) * inverse;
        const float least = c.lean[row] * (kept + c.radius[row] * inverse);
        out[i] *= seen > least ? seen : least;
    }
}

/// x to the power p within some hundredths, for x above 0; the result stays in a wide range.
[[gnu::always_inline]] inline float rough_power(float x, float p) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    const float m = std::bit_cast<float>((bits & 0x7fffff) | 0x3f800000);
    const float log =
        static_cast<float>((bits >> 23) - 127) + ((-0.3333333f * m + 2) * m - 1.6666667f);
    float e = p * log;
    e = e < -60 ? -60.0f : (e > 60 ? 60.0f : e);
    const auto towards_zero = static_cast<std::int32_t>(e);
    const std::int32_t whole = towards_zero - (e < static_cast<float>(towards_zero) ? 1 : 0);
    const float f = e - static_cast<float>(whole);
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(1 + f * (0.6565f + 0.3435f * f)) +
                                whole * (1 << 23));
}

/// against_square_law(), in single precision.
[[gnu::always_inline]] inline void fall_off(const Columns& c, const SourceColumns& s,
                                            std::size_t first, const Place& p, Rows& out) {
    constexpr auto slack = static_cast<float>(cone_slack), edge = static_cast<float>(cone_edge);
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const float vx = c.x[row] - p.x, vy = c.y[row] - p.y, vz = c.z[row] - p.z;
        const float radius = c.radius[row], r2 = radius * radius;
        const float d2 = vx * vx + vy * vy + vz * vz;
        const float outside2 = d2 > r2 ? d2 : r2;
        const float distance = std::sqrt(outside2);
        const float far = rough_power(distance * s.per_fade_distance[row], s.fade_power[row]);
        const float inverse = 1 / distance, sine = radius * inverse;
        const float cosine2 = 1 - sine * sine;
        const float cosine = std::sqrt(cosine2 > 0 ? cosine2 : 0);
        const float along =
            -(c.axis_x[row] * vx + c.axis_y[row] * vy + c.axis_z[row] * vz) * inverse;
        const float across2 = 1 - along * along;
        const float across = std::sqrt(across2 > 0 ? across2 : 0);
        const float turned = along * cosine + across * sine;
        const float nearest = along < cosine ? turned : 1;
        const float inside = nearest + slack - s.dark[row];
        const float t0 = inside * s.per_edge[row], t = t0 < 1 ? t0 : 1;
        const float smooth = t * t * (3 - 2 * t), lit = smooth > edge ? smooth : edge;
        const float share = inside > 0 ? lit : 0;
        const float kept = d2 > r2 ? share : 1;
        out[i] *= outside2 * kept * (2 / (1 + far));
    }
}

/// Exact but for the last bits of double precision: a faint entry behind glaring ones must keep its
/// chance.
[[gnu::always_inline]] inline double sum(const Rows& rows) {
    std::array<double, block / 2> strand;
    for (std::size_t j = 0; j < block / 2; ++j)
        strand[j] = static_cast<double>(rows[j]) + static_cast<double>(rows[j + block / 2]);
    for (std::size_t half = block / 4; half > 0; half /= 2)
        for (std::size_t j = 0; j < half; ++j) strand[j] += strand[j + half];
    return strand[0];
}

struct Look {
    bool both_sides;               ///< the point is lit from both sides
    bool turned;                   ///< some luminaires are flat, or lean
    const SourceColumns* sources;  ///< null: there are luminaires only
};

/// Weighs all rows, and adds up each block of them.
CANDELABRA_EVERY_MACHINE
void weigh_rows(const Columns& c, std::size_t count, const Place& place, const Look& look,
                CutWeights& result) {
    const Place p = place;
    for (std::size_t first = 0; first < count; first += block) {
        Rows rows;
        if (look.both_sides)
            weigh_even<true>(c, first, p, rows);
        else
            weigh_even<false>(c, first, p, rows);
        if (look.turned) turn_to_point(c, first, p, rows);
        if (look.sources) fall_off(c, *look.sources, first, p, rows);
        std::ranges::copy(rows, result.weight.begin() + first);
        result.block_sum[first / block] = sum(rows);
    }
}

Glow exact_glow(const Luminaire& luminaire) {
    const LightBounds b = bounds(luminaire);
    return leaning(glow(b), b.lean);
}

/// A cluster as a point of the cell sees it, roughly.
struct Entry {
    LightCluster cluster;
    double weight = 0;
    double excess = 0;  ///< what it adds to the variance of the choice

    bool operator<(const Entry& other) const {
        return excess != other.excess ? excess < other.excess : cluster.first > other.cluster.first;
    }
};

class Refinement {
public:
    Refinement(const LightTree& tree, const Box& cell)
        : tree_(tree), centre_(cell.centre()), radius_(0.5 * length(cell.size())) {}

    void refine(const CutRule& rule) {
        const auto most = std::min(static_cast<std::size_t>(rule.most_entries), CutWeights::most);
        add(tree_.root());
        // A block of entries takes the same time whether it is full or not.
        while (heap_.size() < most && (heap_.size() < CutWeights::block || noise() > rule.noise)) {
            std::pop_heap(heap_.begin(), heap_.end());
            const Entry coarse = heap_.back();
            if (coarse.excess <= 0) break;
            heap_.pop_back();
            const auto [first, second] = tree_.halves(coarse.cluster);
            add(first);
            add(second);
        }
        std::ranges::sort(heap_, {}, [](const Entry& e) { return e.cluster.first; });
    }
    const std::vector<Entry>& entries() const { return heap_; }
    double noise() const {
        double clusters = 0, singles = 0, excess = 0;
        for (const Entry& e : heap_) {
            if (e.cluster.count > 1) clusters += e.weight;
            excess += e.excess;
        }
        for (const Entry& e : heap_)
            if (e.cluster.count == 1 && e.weight < outshining * clusters) singles += e.weight;
        return excess > 0 ? excess / (clusters + singles) : 0;
    }

private:
    void add(const LightCluster& cluster) {
        if (tree_.dark(cluster)) return;
        const Glow g = tree_.glow(cluster);
        const double d = length(g.centre - centre_);
        Entry entry{cluster, 0, 0};
        entry.weight = g.strength * g.radius / (d * d + radius_ * radius_ + g.radius * g.radius);
        if (g.lean != Vec3(0)) entry.weight *= turned(g, g.centre - centre_, radius_ + g.radius);
        if (const Falloff* falloff = tree_.falloff(cluster))
            entry.weight *= against_square_law(*falloff, g.centre - centre_, radius_ + g.radius);
        if (cluster.count > 1) {
            // From everywhere in the cell, distance and height of the members differ by about this
            // share.
            const double spread = g.radius / std::fmax(d - radius_, g.radius);
            entry.excess = entry.weight * spread * spread;
        }
        heap_.push_back(entry);
        std::push_heap(heap_.begin(), heap_.end());
    }

    const LightTree& tree_;
    Vec3 centre_;
    double radius_;
    std::vector<Entry> heap_;
};

}  // namespace

LightCut::LightCut(const LightTree& tree, std::span<const Luminaire> luminaires, const Box& cell,
                   const CutRule& rule, double unit)
    : middle_(cell.centre()), scale_(1 / unit) {
    Refinement refinement(tree, cell);
    refinement.refine(rule);
    noise_ = refinement.noise();
    const Glow all = tree.glow(tree.root());
    const double whole = all.strength * all.radius;
    for (const auto& entry : refinement.entries()) clusters_.push_back(entry.cluster);
    rows_ = (clusters_.size() + block - 1) / block * block;
    sources_ = tree.falloff(tree.root()) != nullptr;
    values_.assign((sources_ ? source_columns : columns) * rows_, 0);
    std::fill_n(column(radius), rows_, 1.0f);
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
        const LightCluster& c = clusters_[i];
        Glow g = c.count == 1 ? exact_glow(luminaires[tree.light(c.first)]) : tree.glow(c);
        g.strength /= whole;
        fill(i, g);
        if (sources_) fill(i, *tree.falloff(c));
    }
}

void LightCut::fill(std::size_t entry, const Glow& g) {
    const Vec3 place = (g.centre - middle_) * scale_;
    // Rounding must not carry any of it below a horizon that it is above.
    const double rounding = 4e-7 * (max_abs_component(place) + 1e-3);
    const double r = g.radius * scale_ + rounding;
    column(x)[entry] = static_cast<float>(place.x);
    column(y)[entry] = static_cast<float>(place.y);
    column(z)[entry] = static_cast<float>(place.z);
    column(radius)[entry] = static_cast<float>(r);
    const double share = std::fmax(g.strength * g.radius, least_strength);
    column(strength)[entry] = static_cast<float>(share / r);
    const Vec3 half = glm::min(g.half * scale_ + rounding, r);
    column(half_x)[entry] = static_cast<float>(half.x);
    column(half_y)[entry] = static_cast<float>(half.y);
    column(half_z)[entry] = static_cast<float>(half.z);
    column(axis_x)[entry] = static_cast<float>(g.axis.x);
    column(axis_y)[entry] = static_cast<float>(g.axis.y);
    column(axis_z)[entry] = static_cast<float>(g.axis.z);
    column(evenness)[entry] = static_cast<float>(g.evenness);
    column(lean_x)[entry] = static_cast<float>(g.lean.x);
    column(lean_y)[entry] = static_cast<float>(g.lean.y);
    column(lean_z)[entry] = static_cast<float>(g.lean.z);
    column(lean)[entry] = static_cast<float>(length(g.lean));
    turned_ = turned_ || g.axis != Vec3(0) || g.lean != Vec3(0);
}

void LightCut::fill(std::size_t entry, const Falloff& f) {
    column(axis_x)[entry] = static_cast<float>(f.axis.x);
    column(axis_y)[entry] = static_cast<float>(f.axis.y);
    column(axis_z)[entry] = static_cast<float>(f.axis.z);
    column(fade_power)[entry] = f.fades() ? static_cast<float>(f.fade_power) : 0;
    const double distance = f.fades() ? std::fmax(f.fade_distance * scale_, 1e-30) : 1;
    column(per_fade_distance)[entry] = static_cast<float>(1 / distance);
    const double least = std::cos(f.dark), wide = std::fmax(std::cos(f.bright) - least, cone_slack);
    column(dark)[entry] = f.all_around() ? -10 : static_cast<float>(least);
    column(per_edge)[entry] = f.all_around() ? 1 : static_cast<float>(1 / wide);
}

std::size_t LightCut::entry_of(std::uint32_t place) const {
    const auto after = std::ranges::upper_bound(clusters_, place, {}, &LightCluster::first);
    return static_cast<std::size_t>(after - clusters_.begin()) - 1;
}

void LightCut::weigh(const ShadingPoint& point, CutWeights& result) const {
    const Vec3 p = (point.position - middle_) * scale_;
    const Place place{static_cast<float>(p.x),
                      static_cast<float>(p.y),
                      static_cast<float>(p.z),
                      static_cast<float>(point.normal.x),
                      static_cast<float>(point.normal.y),
                      static_cast<float>(point.normal.z)};
    const Columns c{column(x),        column(y),      column(z),      column(radius),
                    column(strength), column(axis_x), column(axis_y), column(axis_z),
                    column(evenness), column(half_x), column(half_y), column(half_z),
                    column(lean_x),   column(lean_y), column(lean_z), column(lean)};
    SourceColumns s{};
    if (sources_)
        s = {column(fade_power), column(per_fade_distance), column(dark), column(per_edge)};
    weigh_rows(c, rows_, place, {point.both_sides, turned_, sources_ ? &s : nullptr}, result);
    result.total = 0;
    for (std::size_t i = 0; i < rows_ / CutWeights::block; ++i) result.total += result.block_sum[i];
}

void LightCut::scale(std::span<const float> factors) {
    for (std::size_t i = 0; i < entries(); ++i) column(strength)[i] *= factors[i];
}

std::size_t LightCut::find(const CutWeights& weights, double& target) const {
    // Rounding may carry the target past the end of the list or of a block: then the last that has
    // a weight is taken.
    std::size_t found = 0;
    bool passed = false;
    for (std::size_t i = 0; !passed && i < rows_ / CutWeights::block; ++i) {
        const double sum = weights.block_sum[i];
        if (!(sum > 0)) continue;
        found = i;
        passed = target < sum;
        if (!passed) target -= sum;
    }
    std::size_t last = 0;
    for (std::size_t i = found * CutWeights::block; i < (found + 1) * CutWeights::block; ++i) {
        const double weight = weights.weight[i];
        if (!(weight > 0)) continue;
        last = i;
        if (passed && target < weight) return i;
        target -= weight;
    }
    target = weights.weight[last] * (1 - 0x1p-53);
    return last;
}

std::size_t LightCut::memory_bytes() const {
    return clusters_.capacity() * sizeof(LightCluster) + values_.capacity() * sizeof(float);
}
