#include "simulation/mesh_file.h"

#include "zonegrid/errors.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include <span>
#include <string>
#include <system_error>

namespace zonegrid {
namespace {

Eigen::Matrix3d body_from(MeshAxes axes) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (axes == MeshAxes::z_up) {
        turn = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
    } else if (axes == MeshAxes::y_up) {
        turn << 0, 0, -1, 1, 0, 0, 0, -1, 0;
    }
    return turn;
}

void append_mesh(Shape& shape, const aiMesh& mesh, const Eigen::Matrix3d& turn) {
    const auto first = static_cast<std::uint32_t>(shape.vertices_m.size());
    for (const aiVector3D& vertex : std::span(mesh.mVertices, mesh.mNumVertices)) {
        shape.vertices_m.push_back(turn *
                                   Eigen::Vector3f(vertex.x, vertex.y, vertex.z).cast<double>());
    }
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        if (face.mNumIndices == 3) { // points and lines have no surface
            shape.triangles.push_back(
                {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
        }
    }
}

} // namespace

Shape read_mesh_file(const std::filesystem::path& file, MeshAxes axes) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file.string(), "there is no such file",
                         "name a mesh relative to the scene's file");
    }
    Assimp::Importer importer;
    const aiScene* const scene =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                             aiProcess_PreTransformVertices);
    if (scene == nullptr) {
        throw InputError(file.string(),
                         fmt::format("the mesh cannot be read ({})", importer.GetErrorString()),
                         "give a PLY or OBJ with triangles or polygons");
    }
    Shape shape;
    for (const aiMesh* const mesh : std::span(scene->mMeshes, scene->mNumMeshes)) {
        append_mesh(shape, *mesh, body_from(axes));
    }
    if (shape.triangles.empty()) {
        throw InputError(file.string(), "the mesh holds no triangle",
                         "give a PLY or OBJ with triangles or polygons");
    }
    for (const Eigen::Vector3d& vertex : shape.vertices_m) {
        if (!vertex.allFinite()) {
            throw InputError(file.string(), "a vertex is not finite", "correct the mesh");
        }
    }
    return shape;
}

} // namespace zonegrid
