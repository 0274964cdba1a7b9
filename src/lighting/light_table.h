// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of luminaires, laid out so that a whole list's contributions to a point are estimated in
// one vectorised loop. Used by the strategies that choose in proportion to them. The same bits come
// out for every instruction set.
#pragma once

#include "lighting/pick.h"
#include "luminaire/light_proxy.h"

#include <array>

namespace candelabra {

/// A list in a table.
struct LightList {
    std::size_t first = 0;  ///< its first row, a multiple of LightTable::lanes
    std::size_t count = 0;
};

class LightTable {
public:
    /// Rows are added up in so many strands; lists are padded to full ones.
    static constexpr std::size_t lanes = 8;
    static constexpr std::size_t block = 64;  ///< rows estimated at once
    static constexpr std::size_t max_parts = 512;

    /// Sums of the estimates of a list: of its parts of equal length (the rows themselves when they
    /// are not too many), and of all.
    struct Sums {
        std::array<double, max_parts> part;
        double total = 0;
    };
    /// A row with its estimate.
    struct Row {
        std::size_t row;
        double estimate;
    };

    LightTable() = default;
    /// No list yet. The luminaires outlive the table.
    explicit LightTable(std::span<const Luminaire>);

    /// Takes memory for so many lists with so many luminaires in all.
    void reserve(std::size_t lists, std::size_t lights);
    LightList append(std::span<const LightIndex>);

    /// Estimate for one luminaire: what a list gives for it, to the last bit.
    double estimate(LightIndex, const Receiver&) const;
    const LightProxy& light_proxy(LightIndex light) const { return records_[light].glow; }
    LightIndex light(std::size_t row) const { return lights_[row]; }
    std::span<const LightIndex> lights(const LightList& list) const {
        return {lights_.data() + list.first, list.count};
    }

    void sum(const LightList&, const Receiver&, Sums&) const;
    /// The row at which the running sum of the estimates passes target, which is in [0,
    /// sums.total). Its estimate is above 0. Precondition: sum() gave these sums, and their total
    /// is above 0.
    Row find(const LightList&, const Receiver&, const Sums&, double target) const;

    std::size_t memory_bytes() const;

private:
    /// What the estimates need to know of a luminaire.
    struct Record {
        LightProxy glow;
        double exact_within2 = 0;  ///< squared distance below which the luminaire itself is asked:
                                   ///< the estimate is too rough there
    };
    using Block = std::array<double, block>;

    struct Found {
        std::size_t index = 0;
        double sum = 0;
        bool passed = false;
    };

    void estimate_block(std::size_t first, std::size_t count, const Receiver&, double* out) const;
    static std::size_t part_length(const LightList&);
    /// The first index at which the running sum passes target, else the last one above 0; target is
    /// left as what is missing.
    static Found find_among(const double* sums, std::size_t count, double& target);

    std::span<const Luminaire> luminaires_;
    std::vector<Record> records_;
    std::vector<LightIndex> lights_;
    std::vector<double> x_, y_, z_, radius_, strength_;
    bool flat_ = false;  ///< whether some luminaire is; the other columns are empty if not
    std::vector<double> axis_x_, axis_y_, axis_z_, evenness_, exact_within2_;
};

}  // namespace candelabra
