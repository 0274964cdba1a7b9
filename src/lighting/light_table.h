// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of luminaires, laid out so that one vectorised loop estimates the contributions of a whole
// list to a point. Used by the strategies that choose in proportion to these. The result is bitwise
// the same for every instruction set.
#pragma once

#include "lighting/choosable_lights.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace candelabra {

/// A list in a table.
struct LightList {
    std::size_t first = 0;  ///< its first row, a multiple of LightTable::lanes
    std::size_t count = 0;
};

class LightTable {
public:
    /// Number of strands in which rows are added up; lists are padded to a multiple of it.
    static constexpr std::size_t lanes = 8;
    static constexpr std::size_t block = 64;  ///< rows estimated at once
    static constexpr std::size_t max_parts = 512;

    /// Sums of the estimates of a list: those of parts of equal length (single rows if there are
    /// not too many), and the total.
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
    /// Makes a table without lists. Null: there are no lights.
    explicit LightTable(std::shared_ptr<const ChoosableLights>);

    /// Reserves memory for that number of lists, with that number of luminaires in all.
    void reserve(std::size_t lists, std::size_t lights);
    LightList append(std::span<const LightIndex>);

    /// Estimate for one luminaire, bitwise equal to that in a list.
    double estimate(LightIndex, const Receiver&) const;
    const LightProxy& light_proxy(LightIndex light) const { return records_[light].proxy; }
    LightIndex light(std::size_t row) const { return lights_[row]; }
    std::span<const LightIndex> lights(const LightList& list) const {
        return {lights_.data() + list.first, list.count};
    }

    void sum(const LightList&, const Receiver&, Sums&) const;
    /// Returns the row at which the running sum of the estimates passes target, which is in [0,
    /// sums.total). Its estimate is above 0. Precondition: sum() computed these sums, and their
    /// total is above 0.
    Row find(const LightList&, const Receiver&, const Sums&, double target) const;

    std::size_t memory_bytes() const;

private:
    /// Data of a luminaire for its estimates.
    struct Record {
        LightProxy proxy;
        /// Squared distance below which the luminaire is evaluated exactly: the estimate is too
        /// rough there.
        double exact_within2 = 0;
    };
    using Block = std::array<double, block>;

    void estimate_block(std::size_t first, std::size_t count, const Receiver&, double* out) const;
    static std::size_t part_length(const LightList&);

    std::shared_ptr<const ChoosableLights> choosable_;
    std::vector<Record> records_;
    std::vector<LightIndex> lights_;
    std::vector<double> x_, y_, z_, radius_, strength_;
    bool flat_ = false;  ///< whether some luminaire is flat; if not, the other columns are empty
    std::vector<double> axis_x_, axis_y_, axis_z_, evenness_, exact_within2_;
};

}  // namespace candelabra
