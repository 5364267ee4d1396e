#pragma once
// A range check for options. Its message reads like those for logs, and help stays readable.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace pentimento::cli {

/// Accepts a number, written with a point in any locale, from `min` to `max`.
CLI::Validator in_range(double min, double max);

}  // namespace pentimento::cli
