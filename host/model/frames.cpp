#include "zonegrid/sensors.h"

namespace zonegrid {

Eigen::Quaterniond attitude_from_euler(double roll_rad, double pitch_rad, double yaw_rad) {
    return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX());
}

Eigen::Matrix3d body_from_forward_camera() {
    Eigen::Matrix3d rotation;
    rotation.col(0) = Eigen::Vector3d::UnitY(); // camera right is body right
    rotation.col(1) = Eigen::Vector3d::UnitZ(); // camera down is body down
    rotation.col(2) = Eigen::Vector3d::UnitX(); // the optical axis is forward
    return rotation;
}

} // namespace zonegrid
