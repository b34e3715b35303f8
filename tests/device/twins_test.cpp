#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// A kernel and its shader are twins: who reads one finds the same functions, in the same order, in
// the other.

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

/// Names of the functions that a file defines; a kernel is called "main", as in a shader.
std::vector<std::string> functions_of(const fs::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    std::string code = std::regex_replace(
        text.str(), std::regex(R"(\n__kernel\s+__attribute__\(\([^\n]*\)\)\)\s+void \w+\()"),
        "\nvoid main(");
    std::vector<std::string> names;
    const std::regex definition(R"(\n(?:void|bool|u?int|float|i?vec3|int3) (\w+)\()");
    for (std::sregex_iterator match(code.begin(), code.end(), definition), end; match != end;
         ++match) {
        names.push_back((*match)[1]);
    }
    return names;
}

class Twins : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Twins, DefineTheSameFunctionsInTheSameOrder) {
    const fs::path root = ZONEGRID_SOURCE_DIR;
    const auto& [kernel, shader] = GetParam();
    ASSERT_TRUE(fs::exists(root / shader)) << shader << " is missing beside " << kernel;
    const auto functions = functions_of(root / kernel);
    EXPECT_FALSE(functions.empty());
    EXPECT_EQ(functions, functions_of(root / shader));
}

std::vector<std::pair<std::string, std::string>> twins() {
    const fs::path root = ZONEGRID_SOURCE_DIR;
    std::vector<std::pair<std::string, std::string>> twins{
        {"kernels/common.cl", "shaders/common.glsl"}};
    for (const auto& entry : fs::directory_iterator(root / "kernels/parts")) {
        const auto name = entry.path().stem().string();
        twins.emplace_back("kernels/parts/" + name + ".cl", "shaders/parts/" + name + ".glsl");
    }
    for (const auto& entry : fs::directory_iterator(root / "shaders")) {
        const auto name = entry.path().stem().string();
        if (entry.path().extension() == ".comp") {
            twins.emplace_back("kernels/" + name + ".cl", "shaders/" + name + ".comp");
        }
    }
    return twins;
}

INSTANTIATE_TEST_SUITE_P(All, Twins, testing::ValuesIn(twins()), [](const auto& twin) {
    return fs::path(twin.param.second).stem().string() +
           (twin.param.first.find("parts/") != std::string::npos ? "_part" : "");
});

} // namespace
} // namespace zonegrid
