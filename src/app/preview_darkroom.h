// SPDX-License-Identifier: GPL-3.0-or-later
// Where the preview's plates become pictures for the screen: a thread of its own, so that exposure,
// glare and lamps follow a slider while the picture is being rendered.
#pragma once

#include "app/preview_plate.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace candelabra {

/// A picture for the screen.
struct ScreenPicture {
    int width = 0, height = 0;                      ///< of the whole picture
    int columns = 0, rows = 0;                      ///< of what there is: fewer when it is coarse
    int generation = 0;                             ///< see PlateFrame
    std::string view = "picture";                   ///< what it shows
    std::shared_ptr<const std::string> bytes = {};  ///< see screen_bytes()
};

class Darkroom {
public:
    /// `shows` is called by the darkroom's thread.
    explicit Darkroom(std::function<void(ScreenPicture)> shows);
    Darkroom(const Darkroom&) = delete;
    Darkroom& operator=(const Darkroom&) = delete;
    ~Darkroom();

    /// The newest plate. Called by any thread, as all that follows.
    void take(std::shared_ptr<const Plate>, std::shared_ptr<const PlateFrame>);
    void set(const Look&);

    /// The newest picture as a file; empty when there is none.
    std::string png() const;
    std::string exr() const;

private:
    /// What a picture is made of.
    struct Order {
        std::shared_ptr<const Plate> plate;
        std::shared_ptr<const PlateFrame> frame;
        Look look;
        int number = 0;  ///< of those that have been taken
    };

    void work();
    /// Glare takes its time, so that a picture of fewer pixels comes first.
    static bool is_slow(const Order&);
    /// Makes the whole picture beside the others, once no hand is on a slider any more.
    void enlarge(const Order&);
    void print(const Order&, const Plate&);
    Order order() const;

    static constexpr int quick_step = 4;  ///< pixels to one of those that come first

    std::function<void(ScreenPicture)> shows_;
    mutable std::mutex mutex_;
    std::mutex showing_;
    std::condition_variable changed_;
    Order order_;
    bool fresh_ = false, ending_ = false;
    bool small_ = false;  ///< the last picture was smaller than its plate
    std::atomic<bool> enlarging_ = false;
    std::thread enlarger_;
    std::thread thread_;
};

}  // namespace candelabra
