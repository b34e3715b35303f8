#pragma once

#include "io/description_table.h"
#include "simulation/scene.h"
#include "simulation/shape.h"
#include "simulation/terrain.h"
#include "truth/surfaces.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace zonegrid {

/// One obstacle before its triangles are put together with all others.
struct Thing {
    std::string name;
    ObstacleKind kind = ObstacleKind::other;
    Shape shape; ///< world frame, or its own where it moves
    double texture = 1.0;
    bool moving = false;
};

/// What stands in a scene, while it is read.
class World {
public:
    explicit World(Terrain terrain) : terrain_(std::move(terrain)) {}

    [[nodiscard]] const Terrain& terrain() const { return terrain_; }

    /// Adds what a table describes, by the name it gives or as "<base> 1", "<base> 2", ...
    /// Throws InputError if the name is taken.
    void add_named(DescriptionTable& table, const std::string& base, Thing thing);
    /// Adds one of many as the next "<base> N".
    void add_numbered(const std::string& base, Thing thing);

    /// Turned by `yaw_rad`, its origin `height_m` above the ground at this place.
    [[nodiscard]] Eigen::Isometry3d on_ground(const Eigen::Vector2d& place_m, double yaw_rad = 0.0,
                                              double height_m = 0.0) const;

    [[nodiscard]] const std::vector<Thing>& things() const { return things_; }

    /// Draws the ground under all things and the given points, with a margin, as the first thing.
    /// Throws InputError at `place`, that of its table, if that takes too many triangles.
    void add_ground(const std::vector<Eigen::Vector3d>& points_m, double texture,
                    const std::string& place);

    /// Puts the triangles and textures of all things together.
    void move_into(Scene& scene);

private:
    Terrain terrain_;
    std::vector<Thing> things_;
    std::set<std::string> names_{"ground"}; ///< taken
    std::map<std::string, int> last_number_;
};

} // namespace zonegrid
