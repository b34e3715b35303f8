#pragma once

#include "simulation/shape.h"

namespace zonegrid {

enum class AircraftModel { aeroplane, helicopter };

/// A small aircraft from simple closed parts: fuselage, wing or rotor, tail, fin and undercarriage.
/// The origin is in the fuselage's axis, the nose at half its length. `span_m` is that of the wing,
/// or the rotor's diameter.
[[nodiscard]] Shape aircraft_shape(AircraftModel model, double length_m, double span_m);

/// How far the wheels or skids of such an aircraft reach below its origin.
[[nodiscard]] double undercarriage_m(double length_m);

} // namespace zonegrid
