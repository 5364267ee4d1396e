#include "tests/fuzz/grammar_log.h"

#include <array>
#include <cstdint>

namespace pentimento::test {

namespace {

constexpr int kMostEvents = 40;
constexpr double kMostSeconds = 0.7;  // 31 steps at 45 steps a second
constexpr std::array<double, 8> kWaits_s = {0, 0.001, 0.011, 1.0 / 45, 0.023, 0.05, 0.1, 0.2};
constexpr std::array<const char*, 8> kBrushes = {"round", "flat",   "filbert", "bristle",
                                                 "fan",   "rigger", "knife",   "rag"};

/// Of stamps, in diameters, until the log says another: the usual 30 mm are about two cells. The
/// usual spacing would make forty times as many stamps, and stamps are most of a replay.
constexpr double kFirstSpacing = 1;
/// From one sample to the next, along x and along y: five cells, one stamp or two.
constexpr double kFarthest_m = 0.06;

/// What may a slider be, in a replay that takes a millisecond: brushes of the size of cells (13 mm)
/// and not more than a few stamps a cell.
struct SliderChoice {
  const char* name;
  double least, most;
};
constexpr std::array<SliderChoice, 9> kSliders = {{{"medium", 0, 1},
                                                   {"pigment", 0, 1},
                                                   {"size", 0.005, 0.08},
                                                   {"pickup", 0, 1},
                                                   {"refill", 0, 1},
                                                   {"stiffness", 0, 1},
                                                   {"layer_mixing", 0, 1},
                                                   {"spacing", 0.25, 2},
                                                   {"load", 0, 1}}};

struct UsualPigment {
  const char* name;
  log::Rgb color;
  double opacity;
};
constexpr std::array<UsualPigment, 3> kPigments = {{{"blue", {0.02, 0.05, 0.4}, 0.7},
                                                    {"ochre", {0.6, 0.4, 0.05}, 0.95},
                                                    {"glaze", {0.5, 0, 0.3}, 0.05}}};

class Grammar {
 public:
  explicit Grammar(Choices& choices) : choices_(choices) {}

  ListReader log() {
    header();
    for (int i = 0; i < kMostEvents && !choices_.made() && time_s_ < kMostSeconds; ++i) event();
    return std::move(log_);
  }

 private:
  void header();
  void event();
  void touch();
  void color();
  void change();
  void add(log::Action action) { log_.add(time_s_, std::move(action)); }
  log::Rgb rgb() {
    return {choices_.between(0, 1), choices_.between(0, 1), choices_.between(0, 1)};
  }

  Choices& choices_;
  ListReader log_;
  double time_s_ = 0;
  std::array<bool, 2> down_{};
  std::array<std::array<double, 2>, 2> place_m_{};  // of each touch
  bool stepped_ = false;
  bool picks_ = false;  // its own colours
};

void Grammar::header() {
  log::Header& head = log_.head;
  head.canvas_width_m = 0.4;
  head.canvas_height_m = 0.3;
  head.grid_width = 32;
  head.grid_height = 24;
  const std::uint8_t bits = choices_.byte();
  if ((bits & 3) == 3) head.model.scheme = SchemeKind::kPaper;
  head.model.layers = (bits & 4) == 0 ? 2 : 3;
  stepped_ = (bits >> 4) % 4 == 3;
  if ((bits >> 6) == 3) {
    head.model.optics = OpticsKind::kSpectral;
    head.model.bands = 8;
  }
  picks_ = choices_.byte() % 8 == 7;
  for (const UsualPigment& usual : kPigments) {
    log::PigmentSpec pigment;
    pigment.name = usual.name;
    pigment.color = picks_ ? rgb() : usual.color;
    pigment.opacity = usual.opacity;
    head.palette.push_back(pigment);
  }
  add(log::Slider{"spacing", kFirstSpacing});
}

void Grammar::event() {
  const std::uint8_t choice = choices_.byte();
  if (stepped_ && choice >= 0xC0) return add(log::Step{});
  if (choice % 4 == 0) time_s_ += choices_.of(kWaits_s);
  if ((choice >> 2) % 3 != 0) return touch();
  change();
}

void Grammar::touch() {
  const std::size_t id = choices_.below(2);
  log::Touch touch;
  touch.id = static_cast<std::int64_t>(id);
  const std::uint8_t how = choices_.byte();
  if (!down_[id]) {
    touch.phase = log::TouchPhase::kDown;
  } else if (how % 8 < 6) {
    touch.phase = log::TouchPhase::kMove;
  } else {
    touch.phase = how % 8 == 6 ? log::TouchPhase::kUp : log::TouchPhase::kCancel;
  }
  down_[id] = touch.phase == log::TouchPhase::kDown || touch.phase == log::TouchPhase::kMove;
  if (touch.phase == log::TouchPhase::kDown) {
    // A little beyond the edges too.
    place_m_[id] = {choices_.between(-0.02, 0.42), choices_.between(-0.02, 0.32)};
  } else {
    for (double& along_m : place_m_[id]) along_m += choices_.between(-kFarthest_m, kFarthest_m);
  }
  touch.x_m = place_m_[id][0];
  touch.y_m = place_m_[id][1];
  if ((how >> 3) % 2 != 0) touch.pressure = choices_.between(0, 1);
  if ((how >> 4) % 2 != 0) {
    touch.tilt_x_deg = choices_.between(-90, 90);
    touch.tilt_y_deg = choices_.between(-90, 90);
  }
  if ((how >> 5) % 2 != 0) touch.twist_deg = choices_.between(-360, 360);
  if ((how >> 6) % 4 == 3) touch.radius_m = choices_.between(0, 0.05);
  add(touch);
}

void Grammar::color() {
  log::Color color;
  if (picks_ && choices_.flag()) {
    color.value = rgb();
  } else {
    color.pigment = choices_.of(kPigments).name;
  }
  if (choices_.byte() % 4 == 3) color.across = {{0, choices_.between(0.1, 1)}};
  add(color);
}

void Grammar::change() {
  switch (choices_.below(12)) {
    case 0:
      return add(log::Dry{});
    case 1:
      return add(log::Clear{});
    case 2:
      return add(log::Undo{});
    case 3:
      return add(log::Redo{});
    case 4:
      return add(log::Gravity{choices_.between(-12, 12), choices_.between(-12, 12),
                              choices_.between(-12, 12)});
    case 5:
    case 6:
      return color();
    case 7:
    case 8:
      return add(log::BrushChange{choices_.of(kBrushes)});
    default: {
      const SliderChoice& slider = choices_.of(kSliders);
      return add(log::Slider{slider.name, choices_.between(slider.least, slider.most)});
    }
  }
}

}  // namespace

ListReader grammar_log(Choices& choices) {
  return Grammar(choices).log();
}

}  // namespace pentimento::test
