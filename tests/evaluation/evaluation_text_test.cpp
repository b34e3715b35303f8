#include "evaluation/evaluation_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;

std::string repeated(const std::string& letter, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += letter;
    }
    return text;
}

TEST(EvaluationText, CutsLongNamesBetweenLetters) {
    Evaluation evaluation;
    evaluation.obstacles.resize(2);
    evaluation.obstacles[0].name = repeated("\xc3\xa4", 22); // fills the column
    evaluation.obstacles[1].name = repeated("\xc3\xa4", 23);
    const std::string text = text_of(evaluation);
    EXPECT_THAT(text, HasSubstr("  " + repeated("\xc3\xa4", 22) + " NO"));
    EXPECT_THAT(text, HasSubstr("  " + repeated("\xc3\xa4", 21) + "~ NO"));
}

} // namespace
} // namespace zonegrid::testing
