// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of base/elementary.h beside those of the C library: nanoseconds of a call, where
// calls overlap and where each waits for the one before.
//   elementary_bench
#include "base/elementary.h"
#include "base/random.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using namespace candelabra;

struct Arguments {
    double from, to, second_from = 0, second_to = 1;
};

/// The best of several times, in nanoseconds.
template <class Function>
double time_of(const Function& f, const Arguments& range, bool waiting) {
    constexpr std::size_t count = 4096;
    std::vector<double> x, y;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto share = [&](std::uint64_t n) {
            return static_cast<double>(mix(2 * i + n) >> 11) * 0x1p-53;
        };
        x.push_back(range.from + (range.to - range.from) * share(0));
        y.push_back(range.second_from + (range.second_to - range.second_from) * share(1));
    }
    double best = 1e9, sum = 0;
    for (int run = 0; run < 20; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        for (int again = 0; again < 10; ++again)
            for (std::size_t i = 0; i < count; ++i)
                sum = waiting ? f(x[i] + sum * 1e-300, y[i]) : sum + f(x[i], y[i]);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        best = std::min(best, taken.count() / (10 * count) * 1e9);
        sum = std::isfinite(sum) ? sum * 1e-9 : 0;
    }
    volatile double used = sum;
    (void)used;
    return best;
}

template <class Library, class Own>
void compare(const char* name, const Arguments& range, const Library& library, const Own& own) {
    std::printf("%-18s%8.1f%8.1f%10.1f%8.1f\n", name, time_of(library, range, false),
                time_of(own, range, false), time_of(library, range, true),
                time_of(own, range, true));
}

#define COMPARE_ONE(name, f, ...)                                        \
    compare(                                                             \
        name, {__VA_ARGS__}, [](double x, double) { return std::f(x); }, \
        [](double x, double) { return math::f(x); })
#define COMPARE_TWO(name, f, ...)                                             \
    compare(                                                                  \
        name, {__VA_ARGS__}, [](double x, double y) { return std::f(x, y); }, \
        [](double x, double y) { return math::f(x, y); })

}  // namespace

int main() {
    std::printf("%-18s%16s%18s\n%-18s%8s%8s%10s%8s\n", "", "overlapping", "waiting", "", "library",
                "own", "library", "own");
    COMPARE_ONE("sin, to 0.7", sin, -0.7, 0.7);
    COMPARE_ONE("sin, to 6.3", sin, -6.3, 6.3);
    COMPARE_ONE("cos, to 6.3", cos, -6.3, 6.3);
    COMPARE_ONE("sin, to 10,000", sin, -1e4, 1e4);
    COMPARE_ONE("tan", tan, -1.5, 1.5);
    COMPARE_ONE("asin", asin, -1, 1);
    COMPARE_ONE("acos", acos, -1, 1);
    COMPARE_ONE("atan", atan, -3, 3);
    COMPARE_TWO("atan2", atan2, -3, 3, -3, 3);
    COMPARE_ONE("exp", exp, -20, 1);
    COMPARE_ONE("exp2", exp2, -20, 1);
    COMPARE_ONE("expm1", expm1, -2, 2);
    COMPARE_ONE("log", log, 0, 3);
    COMPARE_ONE("log2", log2, 0, 3);
    COMPARE_ONE("log1p", log1p, -0.9, 3);
    COMPARE_TWO("pow", pow, 0, 1, 0, 20);
    COMPARE_ONE("cbrt", cbrt, 0, 3);
    COMPARE_TWO("hypot", hypot, 0, 1, 0, 1);
    COMPARE_ONE("sinh", sinh, -3, 3);
    COMPARE_ONE("cosh", cosh, -3, 3);
    COMPARE_ONE("tanh", tanh, -3, 3);
}
