#pragma once
// The ranges of the numbers in an action log, for the reader and the documentation. They are
// generous: they exclude what no session holds, and numbers that would overflow.

#include "formats/log/tables/range.h"

namespace pentimento::log {

inline constexpr double kMaxExactInteger = 9007199254740991;  // 2^53 - 1

inline constexpr Range kTimeRange = {0, 9e9, "s"};  // whole microseconds stay exact in a double
inline constexpr Range kIdRange = {-kMaxExactInteger, kMaxExactInteger};
inline constexpr Range kPositionRange = {-1000, 1000, "m"};
inline constexpr Range kUnitRange = {0, 1};
inline constexpr Range kTiltRange = {-90, 90, "degrees"};
inline constexpr Range kTwistRange = {-360, 360, "degrees"};
inline constexpr Range kRadiusRange = {0, 10, "m"};
inline constexpr Range kAccelerationRange = {-1000, 1000, "m/s^2"};
inline constexpr Range kDirectionRange = {-1e6, 1e6};
inline constexpr Range kLampRange = {0, 6};
inline constexpr Range kIntensityRange = {0, 1e6};
inline constexpr Range kRadianceRange = {-1e6, 1e6};
inline constexpr Range kCameraStartRange = {0, 1e6, "s"};
inline constexpr Range kFovRange = {1, 179, "degrees"};

inline constexpr Range kExposureRange = {-100, 100, "stops"};
inline constexpr Range kChromaticityRange = {0.01, 0.9};
inline constexpr Range kTemperatureRange = {1667, 25000, "K"};
inline constexpr Range kCanvasRange = {0.001, 100, "m"};
inline constexpr Range kGridRange = {1, 16384, "cells"};
inline constexpr Range kStepsPerSecondRange = {1, 10000};
inline constexpr Range kReliefRange = {0, 0.1, "m"};
inline constexpr Range kTextureScaleRange = {1e-4, 100, "m"};
inline constexpr Range kSpacingRange = {1e-3, 10, "diameters"};
inline constexpr Range kBristleCountRange = {1, 2000};
inline constexpr Range kBristleThicknessRange = {0.004, 0.5, "half diameters"};
inline constexpr Range kPressureFactorRange = {0, 4};
inline constexpr Range kCapacityRange = {1, 1e6, "diameters"};
inline constexpr Range kAbsorptionRange = {0, 1e6};
inline constexpr Range kWavelengthRange = {100, 3000, "nm"};

}  // namespace pentimento::log
