// SPDX-License-Identifier: GPL-3.0-or-later
// Orders that follow from the input alone. The standard leaves some of them to each library: which
// of two equal elements comes first after std::sort, and where elements stand within both parts
// after std::nth_element and std::partition, or within a heap. Pictures must not depend on that, so
// sources use these functions instead (a test in tests/house checks it).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>

namespace candelabra {

/// Sorts by projected values; equal elements keep their order. Short lists need no memory.
template <class Range, class Less = std::less<>, class Projection = std::identity>
void sort_stably(Range& range, Less less = {}, Projection projection = {}) {
    constexpr std::ptrdiff_t is_short = 32;
    const auto first = std::begin(range), last = std::end(range);
    const auto before = [&](const auto& a, const auto& b) {
        return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
    };
    if (last - first > is_short) return std::stable_sort(first, last, before);
    for (auto next = first; next != last; ++next)
        std::rotate(std::upper_bound(first, next, *next, before), next, std::next(next));
}

/// Puts the element there that would stand there after sorting; none before it is greater, none
/// behind it is less.
template <class Iterator, class Less = std::less<>>
void put_nth(Iterator begin, Iterator nth, Iterator end, Less less = {}) {
    std::ptrdiff_t first = 0, last = end - begin - 1;
    // A bad choice of pivots is given up.
    int rounds = 4 * std::bit_width(static_cast<std::size_t>(end - begin));
    while (last - first > 8 && --rounds > 0) {
        auto a = begin[first], pivot = begin[first + (last - first) / 2], c = begin[last];
        if (less(pivot, a)) std::swap(a, pivot);
        if (less(c, pivot)) pivot = less(c, a) ? a : c;
        std::ptrdiff_t low = first, high = last;
        while (low <= high) {
            while (less(begin[low], pivot)) ++low;
            while (less(pivot, begin[high])) --high;
            if (low <= high) std::iter_swap(begin + low++, begin + high--);
        }
        if (nth - begin <= high)
            last = high;
        else if (nth - begin >= low)
            first = low;
        else
            return;
    }
    std::stable_sort(begin + first, begin + last + 1, less);
}

/// Moves the elements that belong in front there, and returns how many they are.
template <class Range, class Front>
std::size_t put_in_front(Range&& range, Front front) {
    auto low = std::begin(range), high = std::end(range);
    while (true) {
        while (low != high && front(*low)) ++low;
        while (low != high && !front(*std::prev(high))) --high;
        if (low == high) return static_cast<std::size_t>(low - std::begin(range));
        std::iter_swap(low++, --high);
    }
}

/// Adds to a heap, whose first element is the greatest.
template <class List>
void add_to_heap(List& heap, typename List::value_type element) {
    heap.push_back(std::move(element));
    for (std::size_t i = heap.size() - 1; i > 0;) {
        const std::size_t above = (i - 1) / 2;
        if (!(heap[above] < heap[i])) return;
        std::swap(heap[above], heap[i]);
        i = above;
    }
}

/// Removes the first element of a heap.
template <class List>
void remove_greatest(List& heap) {
    std::swap(heap.front(), heap.back());
    heap.pop_back();
    for (std::size_t i = 0; 2 * i + 1 < heap.size();) {
        std::size_t below = 2 * i + 1;
        if (below + 1 < heap.size() && heap[below] < heap[below + 1]) ++below;
        if (!(heap[i] < heap[below])) return;
        std::swap(heap[i], heap[below]);
        i = below;
    }
}

}  // namespace candelabra
