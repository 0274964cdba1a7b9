// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps whose light a file keeps. They stand in an order in which lamps beside each other light
// a scene alike: group by group, and within a group by their places in the scene. So a range of the
// list is a node of a tree of lamps, and light of many weak lamps can be kept by ranges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The lamps of one name.
struct LampGroup {
    std::string name;
    std::uint32_t lamps = 0;

    friend bool operator==(const LampGroup&, const LampGroup&) = default;
};

/// Lamps from the first to the one before the last.
struct LampRange {
    std::uint32_t first = 0, last = 0;

    std::uint32_t size() const { return last - first; }
    friend bool operator==(const LampRange&, const LampRange&) = default;
};

class LampList {
public:
    LampList() = default;
    /// `numbers`: of each lamp in its group, where they are 0, 1, ... in any order. `powers`: how
    /// much light each lamp emits, in any unit, above 0.
    LampList(std::vector<LampGroup> groups, std::vector<std::uint32_t> numbers,
             std::vector<float> powers);

    std::uint32_t size() const { return static_cast<std::uint32_t>(numbers_.size()); }
    const std::vector<LampGroup>& groups() const { return groups_; }
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }
    const std::vector<float>& powers() const { return powers_; }

    /// Returns the places of a group in the list.
    LampRange range_of(std::size_t group) const { return {begins_[group], begins_[group + 1]}; }
    /// Returns the place of a lamp, which the group must have.
    std::uint32_t place_of(std::size_t group, std::uint32_t number) const {
        return places_[begins_[group] + number];
    }
    /// Returns the place before which a node is divided in two: between groups, or in the middle.
    /// Precondition: it has two lamps.
    std::uint32_t division_of(const LampRange&) const;

    friend bool operator==(const LampList&, const LampList&) = default;

private:
    std::vector<LampGroup> groups_;
    std::vector<std::uint32_t> begins_ = {0};  ///< of the groups, and the end of the last
    std::vector<std::uint32_t> numbers_;
    std::vector<float> powers_;
    std::vector<std::uint32_t> places_;  ///< by group and number
};

/// Whether lamps of these groups can be numbered so.
bool are_numbers_of(const std::vector<LampGroup>&, const std::vector<std::uint32_t>& numbers);

}  // namespace candelabra
