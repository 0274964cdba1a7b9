// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the texts of scenes by the library, with one thread, and stops what takes too long.
#pragma once

#include "base/image.h"
#include "proof/element.h"
#include "world/instance_plan.h"

#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {
struct RenderPlan;
struct RenderSettings;
struct Shot;
}  // namespace candelabra

namespace candelabra::proof {

/// Why there is no picture.
enum class Trouble { none, illegal, too_slow };

/// A number of seconds of the processor that are over at some time.
class Deadline {
public:
    explicit Deadline(double seconds)
        : end_(static_cast<double>(std::clock()) / CLOCKS_PER_SEC + seconds) {}
    bool over() const { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC > end_; }

private:
    double end_;
};

struct Studio {
    /// Seconds of the processor that the renderings for a stage of a claim may take together, and
    /// those that the first look may take.
    double seconds = 40, look_seconds = 4;
    int width = 24, height = 18;
    InstanceLimits instances = {};  ///< which unions are stored once
};

/// A scene that is ready to be rendered again and again.
class Prepared {
public:
    Prepared(const Studio&, const std::string& text, const std::vector<RunOption>&);
    ~Prepared();
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;

    Trouble trouble() const { return complaint_.empty() ? Trouble::none : Trouble::illegal; }
    /// What was said about a scene that is not legal.
    const std::string& complaint() const { return complaint_; }
    const Shot& shot() const;
    RenderSettings settings(int samples, int seed) const;

    /// Returns an empty image if it took too long.
    Image render(int samples, int seed, const Deadline& end) const;

private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
    std::string complaint_;
};

/// The picture of a plan; an empty image if it took too long.
Image rendered(const RenderPlan&, const Deadline& end);

/// The scene of the text as --dump writes it; nothing if the text is not legal.
std::optional<std::string> dumped(const Studio&, const std::string& text,
                                  const std::vector<RunOption>&);

/// Settings of a run with these options.
RenderSettings settings_with(const Studio&, const std::vector<RunOption>&);

}  // namespace candelabra::proof
