#pragma once

namespace zonegrid {

// What goes wrong in a simulated flight; everything is off at 0 (docs/simulation.md, "Faults").

/// What goes wrong in the stereo camera.
struct SensorFaults {
    double disparity_sigma_px = 0.0; ///< standard deviation of the disparity
    double disparity_step_px = 0.0;  ///< disparities are whole multiples of this
    double missing = 0.0;            ///< 0 ... 1: share of (1 - texture) that has no match; with
                                     ///< it go pixels that the second camera does not see
    int bleeding_px = 0;             ///< how far a near surface spreads over a far one
    double outlier_share = 0.0;      ///< of the pixels, with any disparity at all
    bool missing_sky = false;        ///< sky is missing in place of infinite
    double vibration_deg = 0.0;      ///< amplitude of the camera's turns
    double screen_px = 0.0;          ///< disparity error in the stripes of a filmed screen; with
                                     ///< it two exposures are mixed
    friend bool operator==(const SensorFaults&, const SensorFaults&) = default;
};

/// What goes wrong in the navigation.
struct NavigationFaults {
    double scale = 0.0;            ///< 1: the published system's errors
    double time_constant_s = 60.0; ///< of the slowly varying errors
    friend bool operator==(const NavigationFaults&, const NavigationFaults&) = default;
};

/// What goes wrong with time stamps and on the way to the recording; shares are in 0 ... 1.
struct TransferFaults {
    double late_images = 0.0;     ///< share of images whose time is late
    double late_by_s = 0.0;       ///< by at most this
    double lost_images = 0.0;     ///< share of images
    double lost_navigation = 0.0; ///< share of navigation samples
    friend bool operator==(const TransferFaults&, const TransferFaults&) = default;
};

} // namespace zonegrid
