#pragma once

#include "ops/measure_objects.h"
#include "support/case_count.h"
#include "support/labelled_zones.h"

#include <gtest/gtest.h>

#include <string>

namespace zonegrid {

/// Compares the trees that `Operation` writes of pieces on a device with those that `encode`, the
/// reference's, gives for the same cells in a zone.
template <class Operation, class Encode>
void compare_piece_trees(device::Device& device, const Encode& encode) {
    ops::MeasureObjects measures(device);
    Operation wide(device);
    Operation narrow(device, 32);
    std::size_t compared = 0;
    const std::uint64_t count = case_count(40);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        oracle::Random random(seed);
        const std::int32_t edge = 8 << random.pick(0, 2);
        auto& operation = random.chance(0.5) ? wide : narrow;
        ops::LabelComponents labels(device, edge);
        const auto zones = nasty_zones(random, edge);
        label(device, zones, labels);
        measures.dispatch(labels);
        operation.dispatch(labels, measures);
        const auto trees = operation.trees();
        const auto pieces = pieces_of(zones, edge);
        ASSERT_EQ(trees.size(), pieces.size());
        for (std::size_t i = 0; i < pieces.size(); ++i, ++compared) {
            ASSERT_EQ(trees[i], encode(pieces[i], {{0, 0, 0}, edge})) << "piece " << i;
        }
    }
    EXPECT_TRUE(compared > 10000U || count < 40) << compared;
}

} // namespace zonegrid
