// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/limit_options.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace {

/// A whole number, which may be written 1e9. What it counts in megabytes fits into 64 bits, too.
std::optional<std::uint64_t> limit(const Given& given, Diagnostics& diagnostics,
                                   double most = 1e12) {
    const auto value = number(*given.value);
    if (value && *value >= 1 && *value <= most && std::floor(*value) == *value)
        return static_cast<std::uint64_t>(*value);
    refuse(given, diagnostics, message("a limit is a whole number from 1 to ", most));
    return std::nullopt;
}

/// For what is inside each other, and takes room on a stack that is set aside.
constexpr double most_deep = 1e8;

}  // namespace

void store::limit_steps(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.steps = limit(given, diagnostics).value_or(options.limits.steps);
}

void store::limit_depth(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.call_depth =
        limit(given, diagnostics, most_deep).value_or(options.limits.call_depth);
    options.limits.make_room();
}

void store::limit_nesting(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.nesting = limit(given, diagnostics, most_deep).value_or(options.limits.nesting);
    options.limits.make_room();
}

void store::limit_objects(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.objects = limit(given, diagnostics).value_or(options.limits.objects);
}

void store::limit_includes(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.include_depth = limit(given, diagnostics).value_or(options.limits.include_depth);
}

void store::limit_elements(Options& options, const Given& given, Diagnostics& diagnostics) {
    constexpr std::uint64_t most = 2'000'000'000;  // the language counts them with 32 bits
    const auto wanted = limit(given, diagnostics);
    if (wanted) options.limits.array_elements = std::min(*wanted, most);
}

void store::limit_memory(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto megabytes = limit(given, diagnostics)) options.memory_bytes = *megabytes << 20;
}

void store::limit_written(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto mb = limit(given, diagnostics)) options.limits.written_bytes = *mb << 20;
}

void store::limit_files(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.files = limit(given, diagnostics).value_or(options.limits.files);
}

void store::limit_said(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto mb = limit(given, diagnostics)) options.limits.said_bytes = *mb << 20;
}

void store::limit_text(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto mb = limit(given, diagnostics)) options.limits.text_bytes = *mb << 20;
}

void store::limit_function(Options& options, const Given& given, Diagnostics& diagnostics) {
    options.limits.function_steps =
        limit(given, diagnostics).value_or(options.limits.function_steps);
}

void store::limit_work(Options& options, const Given& given, Diagnostics& diagnostics) {
    if (const auto millions = limit(given, diagnostics))
        options.limits.work = *millions * 1'000'000;
}
