#include "io/plain_writer.h"

#include "io/depth_png_writer.h"
#include "io/plain_description.h"
#include "io/recording_folder.h"
#include "zonegrid/errors.h"

namespace zonegrid::testing {
namespace {

TEST(PlainWriter, GivesMountingsThatAreReadAsTheyAre) {
    for (const Eigen::Vector3d& angles_deg :
         {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(5.0, -35.0, 120.0),
          Eigen::Vector3d(-170.0, 60.0, -10.0), Eigen::Vector3d(0.0, -90.0, 30.0),
          Eigen::Vector3d(20.0, 90.0, 0.0), Eigen::Vector3d(0.0, -89.999, 45.0)}) {
        const RecordingFolder folder;
        Camera camera;
        camera.width_px = 4;
        camera.height_px = 3;
        camera.fx_px = 5.0;
        camera.fy_px = 5.5;
        camera.body_from_camera.linear() = mounted_rotation(
            angles_deg.x(), angles_deg.y(), angles_deg.z(), body_from_forward_camera());
        camera.body_from_camera.translation() = Eigen::Vector3d(0.5, -1.0, 1e22);
        PlainSensor sensor;
        sensor.camera = camera;
        sensor.mounting = mounting_of(camera.body_from_camera);
        sensor.coding = DepthCoding{512.0, DepthKind::ray, {0.0F, 3.0F}, {65535.0F}};
        sensor.comments = {"made by a test", "of two\nlines"}; // which would not be TOML
        sensor.truth_digest = std::string(64, 'a');
        write_plain_description(folder.path() / "description.toml", sensor);
        const PlainDescription read = read_plain_description(folder.path() / "description.toml");
        EXPECT_LT((read.camera->body_from_camera.linear() - camera.body_from_camera.linear())
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-9)
            << angles_deg.transpose();
        EXPECT_EQ(read.camera->body_from_camera.translation(),
                  camera.body_from_camera.translation());
        EXPECT_EQ(read.camera->fy_px, 5.5);
        EXPECT_EQ(read.coding.units_per_m, 512.0);
        EXPECT_EQ(read.coding.kind, DepthKind::ray);
        EXPECT_EQ(read.coding.missing, sensor.coding->missing);
        EXPECT_EQ(read.coding.infinite, sensor.coding->infinite);
        EXPECT_EQ(read.truth_digest, sensor.truth_digest);
        EXPECT_TRUE(folder.bytes("description.toml")
                        .starts_with("# made by a test\n# of two lines\n[camera]\n"));
    }
}

TEST(DepthPngWriter, WritesWhatIsReadBack) {
    const RecordingFolder folder;
    for (const ImageSize size : {ImageSize{1, 1}, ImageSize{7, 5}, ImageSize{320, 3}}) {
        DepthPng image{size, {}};
        for (int i = 0; i < size.width_px * size.height_px; ++i) {
            image.values.push_back(static_cast<std::uint16_t>(i * 40503));
        }
        const std::vector<std::uint8_t> bytes = encode_depth_png(image);
        const DepthPng read = read_depth_png(folder.write(
            "image.png",
            std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())));
        EXPECT_EQ(read.size, size);
        EXPECT_EQ(read.values, image.values);
    }
}

TEST(DepthPngWriter, RefusesValuesThatDoNotFill) {
    EXPECT_THROW(static_cast<void>(encode_depth_png({{2, 2}, {1, 2, 3}})), UsageError);
    EXPECT_THROW(static_cast<void>(encode_depth_png({{0, 2}, {}})), UsageError);
}

} // namespace
} // namespace zonegrid::testing
