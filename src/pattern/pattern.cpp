// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/pattern.h"

#include "base/work_watch.h"

#include <concepts>
#include <type_traits>

namespace candelabra {

namespace {

/// A pattern that depends on the point alone.
template <class T>
concept PlainPattern = requires(const T& pattern, const Vec3& point) {
    { evaluate(pattern, point) } -> std::same_as<double>;
};

/// A pattern that may also depend on the point's context.
template <class T>
concept PatternKind = PlainPattern<T> || requires(const T& pattern, const PatternPoint& point) {
    { evaluate(pattern, point) } -> std::same_as<double>;
};

}  // namespace

double evaluate(const Pattern& pattern, const PatternPoint& at) {
    count_work(3);
    return std::visit(
        [&]<PatternKind T>(const T& kind) {
            if constexpr (PlainPattern<T>)
                return evaluate(kind, at.position);
            else
                return evaluate(kind, at);
        },
        pattern);
}

int choices(const Pattern& pattern) {
    return std::visit(
        []<class T>(const T&) {
            if constexpr (requires { T::choices; })
                return T::choices;
            else
                return 0;
        },
        pattern);
}

std::string_view home(const Pattern& pattern) {
    return std::visit(
        []<class T>(const T&) -> std::string_view {
            if constexpr (requires { T::home; })
                return T::home;
            else
                return {};
        },
        pattern);
}

PictureMap* picture_of(Pattern& pattern) {
    return std::visit(
        []<class T>(T& kind) -> PictureMap* {
            if constexpr (std::is_base_of_v<PictureMap, T>)
                return &kind;
            else
                return nullptr;
        },
        pattern);
}

const PictureMap* picture_of(const Pattern& pattern) {
    return picture_of(const_cast<Pattern&>(pattern));
}

bool displaced(const Pattern& pattern) {
    return std::visit(
        []<class T>(const T&) {
            return !requires { T::displaced; };
        },
        pattern);
}

void name_pattern(const Pattern& pattern, PatternModifiers& modifiers, Waveform& wave) {
    std::visit(
        [&]<class T>(const T&) {
            if constexpr (requires { typename T::Wave; }) wave = typename T::Wave{};
            if constexpr (
                requires { T::choices; } || requires { T::frequency; })
                modifiers.frequency = 0;
        },
        pattern);
}

}  // namespace candelabra
