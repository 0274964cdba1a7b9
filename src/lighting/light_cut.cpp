// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_cut.h"

#include "base/random.h"
#include "base/running_sums.h"
#include "base/target_clones.h"
#include "lighting/lobe_weights.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace candelabra {

namespace {

/// Minimum strength, relative to the entry that lights the cell most: single precision would lose
/// smaller ones.
constexpr double min_strength = 1e-24;
/// Distance in sizes of the cell to which farther and larger entries are brought in, in the same
/// direction and with the same light: products of their distances stay in the range of single
/// precision.
constexpr double farthest = 0x1p36;
struct EntryColumns {
    const float *x, *y, *z, *radius, *strength;
    const float *axis_x, *axis_y, *axis_z, *evenness;
    const float *half_x, *half_y, *half_z;
    const float *bent_x, *bent_y, *bent_z, *bent_length;
};
/// Of rows with a falloff; those before the first one have none.
struct SourceColumns {
    std::size_t first;
    const float *fade_power, *per_fade_distance, *cone_x, *cone_y, *cone_z, *dark, *per_edge;
};
using Single = glm::vec<3, float>;
struct Place {
    Single position, normal;
};

/// A block of rows. Compilers vectorise arithmetic on local arrays of known length, to which
/// nothing else can refer.
constexpr std::size_t block = CutWeights::block;
using Rows = std::array<float, block>;

/// From the receiver to the centre of an entry.
[[gnu::always_inline]] inline Single towards(const EntryColumns& c, std::size_t row,
                                             const Place& p) {
    return {c.x[row] - p.position.x, c.y[row] - p.position.y, c.z[row] - p.position.z};
}

[[gnu::always_inline]] inline Single axis_of(const EntryColumns& c, std::size_t row) {
    return {c.axis_x[row], c.axis_y[row], c.axis_z[row]};
}

template <Horizon horizon>
[[gnu::always_inline]] inline void weigh_even(const EntryColumns& c, std::size_t first,
                                              const Place& p, Rows& out) {
    const Single steep(std::abs(p.normal.x), std::abs(p.normal.y), std::abs(p.normal.z));
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const Single half(c.half_x[row], c.half_y[row], c.half_z[row]);
        const float reach = reach_along(steep, half, c.radius[row]);
        out[i] = irradiance<horizon>(towards(c, row, p), p.normal, c.radius[row], c.strength[row],
                                     reach);
    }
}

[[gnu::always_inline]] inline void turn_to_point(const EntryColumns& c, std::size_t first,
                                                 const Place& p, Rows& out) {
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const Single bent(c.bent_x[row], c.bent_y[row], c.bent_z[row]);
        out[i] *= turned(towards(c, row, p), c.radius[row], axis_of(c, row), c.evenness[row], bent,
                         c.bent_length[row]);
    }
}

/// x to the power p within some hundredths, for x above 0; the result is clamped to a wide range.
struct RoughPower {
    [[gnu::always_inline]] float operator()(float x, float p) const {
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
};

[[gnu::always_inline]] inline void fall_off(const EntryColumns& c, const SourceColumns& s,
                                            std::size_t first, const Place& p, Rows& out) {
    Rows factors;
    for (std::size_t i = 0; i < block; ++i) {
        const std::size_t row = first + i;
        const FalloffTerms<float> terms{s.fade_power[row], s.per_fade_distance[row],
                                        Single(s.cone_x[row], s.cone_y[row], s.cone_z[row]),
                                        s.dark[row], s.per_edge[row]};
        factors[i] = against_square_law(terms, towards(c, row, p), c.radius[row], RoughPower());
    }
    for (std::size_t i = first; i < s.first; ++i) factors[i - first] = 1;
    for (std::size_t i = 0; i < block; ++i) out[i] *= factors[i];
}

/// Exact except for the last bits of double precision: a faint entry behind glaring ones must keep
/// its chance.
[[gnu::always_inline]] inline double sum(const Rows& rows) {
    std::array<double, block / 2> strand;
    for (std::size_t j = 0; j < block / 2; ++j)
        strand[j] = static_cast<double>(rows[j]) + static_cast<double>(rows[j + block / 2]);
    for (std::size_t half = block / 4; half > 0; half /= 2)
        for (std::size_t j = 0; j < half; ++j) strand[j] += strand[j + half];
    return strand[0];
}

struct Look {
    Horizon horizon;
    bool turned;                   ///< whether any luminaire is flat, or has a bent normal
    const SourceColumns* sources;  ///< null: all fall off with the square of the distance
};

/// Sets the weights of all rows, and the sum of each block of them.
CANDELABRA_TARGET_CLONES
void weigh_rows(const EntryColumns& c, std::size_t count, const Place& place, const Look& look,
                CutWeights& result) {
    const Place p = place;
    for (std::size_t first = 0; first < count; first += block) {
        Rows rows;
        if (look.horizon == Horizon::one_side)
            weigh_even<Horizon::one_side>(c, first, p, rows);
        else if (look.horizon == Horizon::both_sides)
            weigh_even<Horizon::both_sides>(c, first, p, rows);
        else
            weigh_even<Horizon::none>(c, first, p, rows);
        if (look.turned) turn_to_point(c, first, p, rows);
        if (look.sources && look.sources->first < first + block)
            fall_off(c, *look.sources, first, p, rows);
        std::ranges::copy(rows, result.weight.begin() + first);
        result.block_sum[first / block] = sum(rows);
    }
}

template <bool by_half_vector>
[[gnu::always_inline]] inline void add_shine(const EntryColumns& c, std::size_t first,
                                             const Place& p, const Peak<float>& peak, Rows& out) {
    for (std::size_t i = 0; i < block; ++i)
        out[i] +=
            shine<by_half_vector>(towards(c, first + i, p), p.normal, c.radius[first + i], peak);
}

CANDELABRA_TARGET_CLONES
void weigh_answers_of_rows(const EntryColumns& c, std::size_t count, const Place& place,
                           const LobeWeights<float>& lobes, CutWeights& result) {
    const Place p = place;
    for (std::size_t first = 0; first < count; first += block) {
        Rows answers;
        answers.fill(lobes.diffuse);
        for (const Peak<float>& peak : std::span(lobes.peaks).first(lobes.count)) {
            if (peak.by_half_vector)
                add_shine<true>(c, first, p, peak, answers);
            else
                add_shine<false>(c, first, p, peak, answers);
        }
        Rows rows;
        for (std::size_t i = 0; i < block; ++i) rows[i] = result.weight[first + i] * answers[i];
        std::ranges::copy(rows, result.weight.begin() + first);
        result.block_sum[first / block] = sum(rows);
    }
}

double total(const CutWeights& weights, std::size_t rows) {
    double sum = 0;
    for (std::size_t i = 0; i < rows / block; ++i) sum += weights.block_sum[i];
    return sum;
}

LightProxy exact_proxy(const LightBounds& b) {
    return with_bent_normal(light_proxy(b), b.bent_normal);
}

}  // namespace

LightCut::LightCut(const LightTree& tree, const ChoosableLights& lights, const Box& cell,
                   const CutRule& rule)
    : middle_(cell.centre()), scale_(1 / std::fmax(max_component(cell.size()), 1e-100)) {
    RefinedCut refined = refined_cut(tree, cell, rule);
    noise_ = refined.noise;
    clusters_ = std::move(refined.clusters);
    rows_ = (clusters_.size() + block - 1) / block * block;
    first_source_ = static_cast<std::size_t>(
        std::ranges::count_if(clusters_, [&](const LightCluster& c) { return !tree.falloff(c); }));
    values_.assign((has_sources() ? source_columns : columns) * rows_, 0);
    std::fill_n(column(radius), rows_, 1.0f);
    // Squares of distances are in units of the cell's size. A falloff has none to divide by, so
    // that beside others it is divided by the unit.
    const double of_source = first_source_ > 0 ? 1 / (scale_ * scale_) : 1;
    std::vector<LightProxy> proxies;
    double greatest = 0;
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
        const LightCluster& c = clusters_[i];
        proxies.push_back(c.count == 1 ? exact_proxy(lights.bounds(tree.light(c.first)))
                                       : tree.light_proxy(c));
        const bool by_square_law = i < first_source_;
        if (!by_square_law) proxies.back().strength *= of_source;
        greatest = std::fmax(greatest, light_in_cell(proxies.back(), by_square_law));
    }
    unit_ = (greatest > 0 ? greatest : 1) * (first_source_ > 0 ? scale_ * scale_ : 1);
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
        LightProxy& g = proxies[i];
        const double size = std::fmax(length(g.centre - middle_), g.radius) * scale_;
        const double nearer = std::fmin(farthest / size, 1);
        if (greatest > 0) g.strength /= greatest;
        fill(i, g, nearer);
        if (i >= first_source_) fill(i, *tree.falloff(clusters_[i]), nearer);
    }
}

/// Light of an entry about the cell, up to a constant factor.
double LightCut::light_in_cell(const LightProxy& g, bool by_square_law) const {
    const double intensity = g.strength * g.radius;
    if (!by_square_law) return intensity;
    const Vec3 v = (g.centre - middle_) * scale_;
    const double r = g.radius * scale_;
    return intensity / (dot(v, v) + r * r + 1);
}

void LightCut::fill(std::size_t entry, const LightProxy& g, double nearer) {
    const double scale = scale_ * nearer;
    const Vec3 place = (g.centre - middle_) * scale;
    // Rounding must not move any of it below a horizon that it is above.
    const double rounding = 4e-7 * (max_abs_component(place) + 1);
    const double r = g.radius * scale + rounding;
    column(x)[entry] = static_cast<float>(place.x);
    column(y)[entry] = static_cast<float>(place.y);
    column(z)[entry] = static_cast<float>(place.z);
    column(radius)[entry] = static_cast<float>(r);
    const double brought = entry < first_source_ ? nearer * nearer : 1;
    const double share = std::fmax(g.strength * g.radius * brought, min_strength);
    column(strength)[entry] = static_cast<float>(share / r);
    const Vec3 half = glm::min(g.half * scale + rounding, r);
    column(half_x)[entry] = static_cast<float>(half.x);
    column(half_y)[entry] = static_cast<float>(half.y);
    column(half_z)[entry] = static_cast<float>(half.z);
    column(axis_x)[entry] = static_cast<float>(g.axis.x);
    column(axis_y)[entry] = static_cast<float>(g.axis.y);
    column(axis_z)[entry] = static_cast<float>(g.axis.z);
    column(evenness)[entry] = static_cast<float>(g.evenness);
    column(bent_x)[entry] = static_cast<float>(g.bent_normal.x);
    column(bent_y)[entry] = static_cast<float>(g.bent_normal.y);
    column(bent_z)[entry] = static_cast<float>(g.bent_normal.z);
    column(bent_length)[entry] = static_cast<float>(length(g.bent_normal));
    turned_ = turned_ || g.axis != Vec3(0) || g.bent_normal != Vec3(0);
}

void LightCut::fill(std::size_t entry, const Falloff& falloff, double nearer) {
    const FalloffTerms<double> terms = terms_of(falloff, scale_ * nearer);
    column(cone_x)[entry] = static_cast<float>(terms.axis.x);
    column(cone_y)[entry] = static_cast<float>(terms.axis.y);
    column(cone_z)[entry] = static_cast<float>(terms.axis.z);
    column(fade_power)[entry] = static_cast<float>(terms.fade_power);
    column(per_fade_distance)[entry] = static_cast<float>(terms.per_fade_distance);
    column(dark)[entry] = static_cast<float>(terms.dark);
    column(per_edge)[entry] = static_cast<float>(terms.per_edge);
}

std::size_t LightCut::entry_of(std::uint32_t place) const {
    const auto after = std::ranges::upper_bound(clusters_, place, {}, &LightCluster::first);
    return static_cast<std::size_t>(after - clusters_.begin()) - 1;
}

struct LightCut::Rough {
    Place place;
    EntryColumns columns;
};

LightCut::Rough LightCut::rough(const Receiver& point) const {
    const Vec3 p = (point.position - middle_) * scale_;
    return {{Single(p), Single(point.normal)},
            {column(x), column(y), column(z), column(radius), column(strength), column(axis_x),
             column(axis_y), column(axis_z), column(evenness), column(half_x), column(half_y),
             column(half_z), column(bent_x), column(bent_y), column(bent_z), column(bent_length)}};
}

void LightCut::weigh(const Receiver& point, CutWeights& result) const {
    SourceColumns s{};
    const bool sources = has_sources();
    if (sources)
        s = {first_source_,  column(fade_power), column(per_fade_distance),
             column(cone_x), column(cone_y),     column(cone_z),
             column(dark),   column(per_edge)};
    const Rough all = rough(point);
    weigh_rows(all.columns, rows_, all.place, {point.horizon, turned_, sources ? &s : nullptr},
               result);
    result.total = total(result, rows_);
}

void LightCut::weigh_answers(const Receiver& point, const BsdfLobes& lobes,
                             CutWeights& result) const {
    const Rough all = rough(point);
    weigh_answers_of_rows(all.columns, rows_, all.place, LobeWeights<float>(lobes), result);
    result.total = total(result, rows_);
}

void LightCut::share_evenly(double share, CutWeights& result) const {
    const auto weights = std::span(result.weight).first(entries());
    const auto lit = std::ranges::count_if(weights, [](float weight) { return weight > 0; });
    if (lit == 0) return;
    const auto each = static_cast<float>(share * result.total / static_cast<double>(lit));
    for (std::size_t first = 0; first < rows_; first += block) {
        Rows rows;
        for (std::size_t i = 0; i < block; ++i) {
            const float weight = result.weight[first + i];
            rows[i] = weight > 0 ? weight + each : 0;
        }
        std::ranges::copy(rows, result.weight.begin() + static_cast<std::ptrdiff_t>(first));
        result.block_sum[first / block] = sum(rows);
    }
    result.total = total(result, rows_);
}

double LightCut::share_of_sources(const CutWeights& weights) const {
    double sum = 0;
    for (std::size_t i = first_source_; i < entries(); ++i)
        sum += static_cast<double>(weights.weight[i]);
    return std::fmin(sum / weights.total, 1);
}

void LightCut::dim_luminaires(double factor, CutWeights& result) const {
    for (std::size_t i = 0; i < first_source_; ++i) result.weight[i] *= static_cast<float>(factor);
    for (std::size_t first = 0; first < std::min(first_source_, rows_); first += block) {
        Rows rows;
        std::ranges::copy_n(result.weight.begin() + static_cast<std::ptrdiff_t>(first), block,
                            rows.begin());
        result.block_sum[first / block] = sum(rows);
    }
    result.total = total(result, rows_);
}

void LightCut::scale(std::span<const float> factors) {
    for (std::size_t i = 0; i < entries(); ++i) column(strength)[i] *= factors[i];
}

std::size_t LightCut::find(const CutWeights& weights, double& target) const {
    // Rounding may carry the target past the end of the list or of a block: then the last entry
    // with a weight is taken.
    const auto blocks = std::span(weights.block_sum).first(rows_ / block);
    const ChosenWeight part = choose(blocks, target);
    if (!part.passed) target = std::numeric_limits<double>::infinity();
    const ChosenWeight entry =
        choose(std::span(weights.weight).subspan(part.index * block, block), target);
    if (!entry.passed) target = entry.weight * below_1;
    return part.index * block + entry.index;
}

std::size_t LightCut::memory_bytes() const {
    return clusters_.capacity() * sizeof(LightCluster) + values_.capacity() * sizeof(float);
}

}  // namespace candelabra
