// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/limit_options.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr double most = 1e12;
/// Maximum nesting depth, since nesting uses space on a preallocated stack.
constexpr double max_deep = 1e8;

/// Parses a whole number, which may be written 1e9. A valid number of megabytes fits into 64 bits
/// as bytes.
std::optional<std::uint64_t> whole(const Given& given, Diagnostics& diagnostics, double greatest) {
    const auto value = number(*given.value);
    if (value && *value >= 1 && *value <= greatest && std::floor(*value) == *value)
        return static_cast<std::uint64_t>(*value);
    refuse(given, diagnostics, message("a limit is a whole number from 1 to ", greatest));
    return std::nullopt;
}

/// Sets a limit to the value times the unit if the value is valid.
template <class Limit>
void take(Limit& limit, const Given& given, Diagnostics& diagnostics, std::uint64_t unit = 1,
          double greatest = most) {
    if (const auto value = whole(given, diagnostics, greatest)) limit = *value * unit;
}

constexpr std::uint64_t megabyte = 1 << 20, million = 1'000'000;

}  // namespace

void store::limit_steps(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.steps, given, diagnostics);
}

void store::limit_depth(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.call_depth, given, diagnostics, 1, max_deep);
    options.limits.make_room();
}

void store::limit_nesting(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.nesting, given, diagnostics, 1, max_deep);
    options.limits.make_room();
}

void store::limit_objects(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.objects, given, diagnostics);
}

void store::limit_includes(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.include_depth, given, diagnostics);
}

void store::limit_elements(Options& options, const Given& given, Diagnostics& diagnostics) {
    constexpr std::size_t max_counted = 2'000'000'000;  // the language counts elements in 32 bits
    take(options.limits.array_elements, given, diagnostics);
    options.limits.array_elements = std::min(options.limits.array_elements, max_counted);
}

void store::limit_memory(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.memory_bytes, given, diagnostics, megabyte);
}

void store::limit_written(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.written_bytes, given, diagnostics, megabyte);
}

void store::limit_files(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.files, given, diagnostics);
}

void store::limit_said(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.said_bytes, given, diagnostics, megabyte);
}

void store::limit_text(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.text_bytes, given, diagnostics, megabyte);
}

void store::limit_function(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.function_steps, given, diagnostics);
}

void store::limit_work(Options& options, const Given& given, Diagnostics& diagnostics) {
    take(options.limits.work, given, diagnostics, million);
}

}  // namespace candelabra
