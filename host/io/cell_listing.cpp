#include "io/cell_listing.h"

#include <fmt/format.h>

#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;
constexpr std::size_t longest_line_bytes = 64;

void append_number(std::string& text, int number) {
    const fmt::format_int digits(number);
    text.append(digits.data(), digits.size());
}

} // namespace

CellListing::CellListing(std::function<void(std::string_view)> take) : take_(std::move(take)) {
    lines_.reserve(piece_bytes);
}

void CellListing::add(const CellIndex& cell, int value) {
    if (!started_ || cell.x != last_.x || cell.y != last_.y) {
        start_column(cell);
    }
    if (lines_.size() + longest_line_bytes > piece_bytes) {
        take_(lines_);
        lines_.clear();
    }
    lines_ += column_;
    append_number(lines_, cell.z);
    lines_ += ' ';
    append_number(lines_, value);
    lines_ += '\n';
}

void CellListing::finish() {
    if (!lines_.empty()) {
        take_(lines_);
        lines_.clear();
    }
}

void CellListing::start_column(const CellIndex& cell) {
    column_.clear();
    append_number(column_, cell.x);
    column_ += ' ';
    append_number(column_, cell.y);
    column_ += ' ';
    last_ = cell;
    started_ = true;
}

} // namespace zonegrid
