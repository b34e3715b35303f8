#include "truth/triangle_scene.h"

#include "zonegrid/errors.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t packet_rays = 8;

/// One geometry of the triangles, with copies of the vertices that they use. The caller releases
/// it.
RTCGeometry make_geometry(RTCDevice device, const Surfaces& surfaces,
                          std::span<const std::uint32_t> triangles) {
    constexpr std::uint32_t not_used = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renumbered(surfaces.vertices_m.size(), not_used);
    std::vector<Eigen::Vector3f> vertices;
    std::vector<std::array<std::uint32_t, 3>> corners;
    corners.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        auto& corner = corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = surfaces.triangles[triangle][i];
            if (renumbered[vertex] == not_used) {
                renumbered[vertex] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(surfaces.vertices_m[vertex]);
            }
            corner[i] = renumbered[vertex];
        }
    }
    auto* const geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!triangles.empty()) {
        auto* const vertex_target = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), vertices.size()));
        auto* const corner_target = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), corners.size()));
        if (vertex_target != nullptr && corner_target != nullptr) {
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                std::copy_n(vertices[i].data(), 3, vertex_target + 3 * i);
            }
            for (std::size_t i = 0; i < corners.size(); ++i) {
                std::copy_n(corners[i].data(), 3, corner_target + 3 * i);
            }
        }
    }
    rtcCommitGeometry(geometry);
    return geometry;
}

RTCScene make_scene(RTCDevice device) {
    auto* const scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST); // no ray slips between two triangles
    return scene;
}

} // namespace

/// Embree's handles, which count references.
class TriangleScene::Handles {
public:
    Handles() : device(rtcNewDevice("threads=1,max_isa=avx2")) {
        if (device == nullptr) {
            throw DeviceError("Embree",
                              fmt::format("no device can be made (error {})",
                                          static_cast<int>(rtcGetDeviceError(nullptr))),
                              "check the memory that is left");
        }
        scene = make_scene(device);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        for (auto* const instance : instances) {
            rtcReleaseGeometry(instance);
        }
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    RTCDevice device;
    RTCScene scene = nullptr;
    std::vector<RTCGeometry> instances; ///< of the moving parts
};

TriangleScene::TriangleScene() : handles_(std::make_unique<Handles>()) {}

TriangleScene::~TriangleScene() = default;

void TriangleScene::add_triangles(const Surfaces& surfaces, std::vector<std::uint32_t> triangles) {
    auto* const geometry = make_geometry(handles_->device, surfaces, triangles);
    rtcAttachGeometryByID(handles_->scene, geometry, still_part);
    rtcReleaseGeometry(geometry);
    triangles_.push_back(std::move(triangles));
}

void TriangleScene::add_moving_triangles(const Surfaces& surfaces,
                                         std::vector<std::uint32_t> triangles) {
    auto* const part = make_scene(handles_->device);
    auto* const geometry = make_geometry(handles_->device, surfaces, triangles);
    rtcAttachGeometry(part, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(part);
    auto* const instance = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, part);
    rtcReleaseScene(part);
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(handles_->scene, instance, static_cast<unsigned>(triangles_.size()));
    handles_->instances.push_back(instance);
    triangles_.push_back(std::move(triangles));
}

void TriangleScene::place(std::size_t number, const Eigen::Isometry3d& world_from_part) {
    auto* const instance = handles_->instances[number];
    const Eigen::Matrix<float, 3, 4> columns = world_from_part.matrix().topRows<3>().cast<float>();
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    rtcCommitGeometry(instance);
}

void TriangleScene::commit() {
    rtcCommitScene(handles_->scene);
    const RTCError error = rtcGetDeviceError(handles_->device);
    if (error != RTC_ERROR_NONE) {
        throw DeviceError(
            "Embree", fmt::format("the scene cannot be built (error {})", static_cast<int>(error)),
            "use a smaller scene or a machine with more memory");
    }
}

std::optional<TriangleHit> TriangleScene::cast(const Eigen::Vector3f& start_m,
                                               const Eigen::Vector3f& direction) const {
    TriangleHit hit;
    cast_row(start_m, std::span(&direction, 1), std::span(&hit, 1));
    return hit.triangle == TriangleHit{}.triangle ? std::nullopt : std::optional(hit);
}

void TriangleScene::cast_row(const Eigen::Vector3f& start_m,
                             std::span<const Eigen::Vector3f> directions,
                             std::span<TriangleHit> hits) const {
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t first = 0; first < directions.size(); first += packet_rays) {
        const std::size_t count = std::min(packet_rays, directions.size() - first);
        RTCRayHit8 packet{};
        alignas(32) std::array<int, packet_rays> valid{};
        for (std::size_t i = 0; i < count; ++i) {
            valid[i] = -1;
            packet.ray.org_x[i] = start_m.x();
            packet.ray.org_y[i] = start_m.y();
            packet.ray.org_z[i] = start_m.z();
            packet.ray.dir_x[i] = directions[first + i].x();
            packet.ray.dir_y[i] = directions[first + i].y();
            packet.ray.dir_z[i] = directions[first + i].z();
            packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
            packet.ray.mask[i] = std::numeric_limits<unsigned>::max();
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid.data(), handles_->scene, &context, &packet);
        for (std::size_t i = 0; i < count; ++i) {
            TriangleHit& hit = hits[first + i];
            hit = {};
            if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
                hit.distance = packet.ray.tfar[i];
                const unsigned instance = packet.hit.instID[0][i];
                hit.part = instance == RTC_INVALID_GEOMETRY_ID ? still_part : instance;
                hit.triangle = packet.hit.primID[i];
            }
        }
    }
}

} // namespace zonegrid
