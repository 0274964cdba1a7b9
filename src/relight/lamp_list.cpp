// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_list.h"

#include <algorithm>
#include <utility>

namespace candelabra {

LampList::LampList(std::vector<LampGroup> groups, std::vector<std::uint32_t> numbers,
                   std::vector<float> powers)
    : groups_(std::move(groups)),
      numbers_(std::move(numbers)),
      powers_(std::move(powers)),
      places_(numbers_.size()) {
    for (const LampGroup& group : groups_) begins_.push_back(begins_.back() + group.lamps);
    for (std::size_t i = 0; i < groups_.size(); ++i)
        for (std::uint32_t place = begins_[i]; place < begins_[i + 1]; ++place)
            places_[begins_[i] + numbers_[place]] = place;
}

std::uint32_t LampList::division_of(const LampRange& range) const {
    const std::uint32_t middle = range.first + range.size() / 2;
    const auto inside = [&](std::uint32_t place) {
        return range.first < place && place < range.last;
    };
    // The beginnings of groups around the middle.
    const auto above = std::ranges::lower_bound(begins_, middle);
    const std::uint32_t after = above == begins_.end() ? range.last : *above;
    const std::uint32_t before = above == begins_.begin() ? range.first : above[-1];
    if (inside(after) && (!inside(before) || after - middle <= middle - before)) return after;
    return inside(before) ? before : middle;
}

bool are_numbers_of(const std::vector<LampGroup>& groups,
                    const std::vector<std::uint32_t>& numbers) {
    std::uint64_t begin = 0;
    for (const LampGroup& group : groups) {
        if (group.lamps > numbers.size() - begin) return false;
        std::vector<bool> there(group.lamps);
        for (std::uint64_t place = begin; place < begin + group.lamps; ++place) {
            const std::uint32_t number = numbers[place];
            if (number >= group.lamps || there[number]) return false;
            there[number] = true;
        }
        begin += group.lamps;
    }
    return begin == numbers.size();
}

}  // namespace candelabra
