#include "replay/commands/light_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

namespace pentimento {

namespace {
using LampPlace = std::array<float, 3>;

std::vector<LampPlace> orbit(int frames, const LampPlace& start) {
  constexpr double kTurn = 2 * 3.14159265358979323846;
  std::vector<LampPlace> out;
  for (int i = 0; i < frames; ++i) {
    const double c = std::cos(kTurn * i / frames), s = std::sin(kTurn * i / frames);
    const double x = static_cast<double>(start[0]), y = static_cast<double>(start[1]);
    out.push_back({static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y), start[2]});
  }
  return out;
}

Result<std::vector<LampPlace>> read_points(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Error{ErrorCode::kIo, path + ": cannot be read"};
  std::vector<LampPlace> points;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    text.resize(std::min(text.find('#'), text.size()));
    std::replace(text.begin(), text.end(), ',', ' ');
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    LampPlace p{};
    std::string rest;
    const bool read = static_cast<bool>(words >> p[0] >> p[1] >> p[2]) && !(words >> rest);
    if (!read || p == LampPlace{}) {
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}:{}: expected three numbers, not all 0", path, line)};
    }
    points.push_back(p);
  }
  if (points.empty()) return Error{ErrorCode::kBadInput, path + ": no points"};
  return points;
}

std::vector<LampPlace> along(const std::vector<LampPlace>& points, int frames) {
  std::vector<LampPlace> out;
  for (int i = 0; i < frames; ++i) {
    const double at = frames == 1 ? 0
                                  : static_cast<double>(i) *
                                        static_cast<double>(points.size() - 1) / (frames - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(at), points.size() - 1);
    const std::size_t after = std::min(before + 1, points.size() - 1);
    const auto share = static_cast<float>(at - static_cast<double>(before));
    LampPlace p{};
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = points[before][c] + (points[after][c] - points[before][c]) * share;
    }
    out.push_back(p);
  }
  return out;
}

LampPlace unit(const LampPlace& p) {
  const float length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  if (!(length > 0)) return {0, 0, 1};
  return {p[0] / length, p[1] / length, p[2] / length};
}
}  // namespace

Result<std::vector<LampPlace>> light_path(const std::string& path, int frames, const Lamp& start) {
  if (frames < 1) return Error{ErrorCode::kUsage, "--light-path needs --frames"};
  if (path == "orbit") return orbit(frames, start.position_m.value_or(start.direction));
  Result<std::vector<LampPlace>> points = read_points(path);
  if (!points) return points.error();
  std::vector<LampPlace> out = along(*points, frames);
  if (!start.position_m) std::transform(out.begin(), out.end(), out.begin(), unit);
  return out;
}

}  // namespace pentimento
