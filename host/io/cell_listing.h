#pragma once

#include "zonegrid/objects.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace zonegrid {

/// The lines "x y z value\n" of docs/model.md, section 10, for cells that come by x, then y, then
/// z.
class CellListing {
public:
    /// `take` gets the lines in pieces of up to a mebibyte.
    explicit CellListing(std::function<void(std::string_view)> take);

    void add(const CellIndex& cell, int value);

    /// Hands over what is left; to be called once, after the last cell.
    void finish();

private:
    void start_column(const CellIndex& cell);

    std::function<void(std::string_view)> take_;
    std::string lines_;
    std::string column_; ///< "x y " of the last cell: many cells share it
    CellIndex last_;
    bool started_ = false;
};

} // namespace zonegrid
