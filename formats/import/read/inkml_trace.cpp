// Source: W3C Ink Markup Language (InkML), Recommendation of 2011, sec. 3.2.1.

#include "formats/import/read/inkml_trace.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "formats/import/sketch/text_rows.h"

namespace pentimento::sketch {

namespace {
constexpr double kMost = 1e12;  // of a value: differences that add up to more are damage

/// One channel while its values are read.
struct Running {
  enum class Mode { kExplicit, kDifference, kSecondDifference };
  Mode mode = Mode::kExplicit;
  double value = 0, velocity = 0, acceleration = 0;

  void add(double number) {
    switch (mode) {
      case Mode::kExplicit:
        value = number;
        velocity = acceleration = 0;
        break;
      case Mode::kDifference:
        velocity = number;
        value += velocity;
        break;
      case Mode::kSecondDifference:
        acceleration = number;
        velocity += acceleration;
        value += velocity;
        break;
    }
  }
  /// `*`: an explicit value stays, a difference goes on.
  void repeat() {
    if (mode == Mode::kExplicit) return;
    add(mode == Mode::kDifference ? velocity : acceleration);
  }
};

class Points {
 public:
  Points(std::string_view text, const std::vector<InkmlChannel>& channels)
      : rest_(text), channels_(channels), running_(channels.size()) {
    for (std::size_t i = 0; i < channels.size(); ++i) running_[i].value = channels[i].initial;
  }

  Result<std::vector<std::vector<double>>> read() {
    std::vector<std::vector<double>> out;
    skip_blanks();
    while (!rest_.empty()) {
      std::string problem = read_point();
      if (!problem.empty())
        return Error{ErrorCode::kBadInput, fmt::format("point {}: {}", out.size() + 1, problem)};
      std::vector<double>& values = out.emplace_back();
      for (const Running& r : running_) values.push_back(r.value);
    }
    return out;
  }

 private:
  void skip_blanks() {
    const std::size_t begin = rest_.find_first_not_of(" \t\r\n");
    rest_ = begin == std::string_view::npos ? std::string_view() : rest_.substr(begin);
  }
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string read_point() {
    std::size_t i = 0;
    for (skip_blanks(); !rest_.empty() && !take(','); skip_blanks(), ++i) {
      if (i == channels_.size()) return fmt::format("more than {} values", i);
      std::string problem = read_value(running_[i]);
      if (!problem.empty()) return problem;
    }
    if (i < channels_.size() && !channels_[i].intermittent)
      return fmt::format("{} values, no {}", i, quotable(channels_[i].name));
    skip_blanks();
    return {};
  }

  std::string read_value(Running& channel) {
    if (take('!'))
      channel.mode = Running::Mode::kExplicit;
    else if (take('\''))
      channel.mode = Running::Mode::kDifference;
    else if (take('"'))
      channel.mode = Running::Mode::kSecondDifference;
    skip_blanks();
    if (take('*')) {
      channel.repeat();
    } else if (take('?')) {
      return {};  // unknown: the value before is as good as any
    } else if (take('T')) {
      channel.value = 1;
    } else if (take('F')) {
      channel.value = 0;
    } else {
      double number = 0;
      if (!read_number(number)) return fmt::format("'{}' is not a value", shown());
      channel.add(number);
    }
    if (!(std::abs(channel.value) <= kMost))
      return fmt::format("the value {} is outside +-{}", channel.value, kMost);
    return {};
  }

  bool read_number(double& number) {
    if (take('#')) {
      std::int64_t hex = 0;
      const auto [end, problem] =
          std::from_chars(rest_.data(), rest_.data() + rest_.size(), hex, 16);
      if (problem != std::errc()) return false;
      number = static_cast<double>(hex);
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      return true;
    }
    const std::string_view before = rest_;
    if (take('+') && rest_.starts_with('-')) return false;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (problem != std::errc() || !std::isfinite(number)) {
      rest_ = before;
      return false;
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
  }

  /// The next few characters for a message, on one line.
  std::string shown() const {
    std::string out(rest_.substr(0, 12));
    for (char& c : out)
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return out;
  }

  std::string_view rest_;
  const std::vector<InkmlChannel>& channels_;
  std::vector<Running> running_;
};
}  // namespace

Result<std::vector<std::vector<double>>> inkml_points(std::string_view text,
                                                      const std::vector<InkmlChannel>& channels) {
  return Points(text, channels).read();
}

}  // namespace pentimento::sketch
