#include "io/readable_text.h"

#include <gtest/gtest.h>

namespace zonegrid::testing {
namespace {

TEST(ReadableText, KeepsUtf8AndReplacesTheRest) {
    EXPECT_EQ(readable_text(""), "");
    EXPECT_EQ(readable_text("a b\xc3\xa4\xe2\x82\xac\xf0\x9f\x8c\xb2"),
              "a b\xc3\xa4\xe2\x82\xac\xf0\x9f\x8c\xb2");
    EXPECT_EQ(readable_text("two\nlines\tand\rmore"), "two lines and more");
    EXPECT_EQ(readable_text("\xe9t\xe9"), "?t?");
    EXPECT_EQ(readable_text("\xc0\xaf \xed\xa0\x80 \xe2\x82"), "?? ??? ??"); // overlong, half, cut
}

} // namespace
} // namespace zonegrid::testing
