#include "core/brush/held_brush.h"

#include <utility>

#include "core/base/check.h"
#include "core/brush/builtin_brushes.h"

namespace pentimento {

HeldBrush::HeldBrush(const ChannelBasis& basis, const Model& model, std::shared_ptr<TipRack> tips)
    : basis_(basis),
      model_(model),
      amount_(basis.amount.begin(), basis.amount.end()),
      brush_(*builtin_brush("round")),
      tips_(tips != nullptr ? std::move(tips) : std::make_shared<TipRack>()),
      load_(wanted_load()) {}

void HeldBrush::become(const HeldBrush& other) {
  amount_ = other.amount_;
  brush_ = other.brush_.clone();
  tips_ = other.tips_;
  tip_ = other.tip_;
  settings_ = other.settings_;
  colors_ = other.colors_;
  load_ = other.load_;
}

bool HeldBrush::take(const BrushDefinition& brush) {
  const bool is_other = brush.name != brush_.name;
  brush_ = brush.clone();
  tip_ = nullptr;
  return is_other;
}

const Tip& HeldBrush::tip() {
  if (tip_ == nullptr) tip_ = tips_->find(brush_);
  return *tip_;
}

bool HeldBrush::set_settings(const BrushSettings& settings) {
  settings_ = settings;
  return reload();
}

bool HeldBrush::reload() {
  PaintLoad wanted = wanted_load();
  if (wanted == load_) return false;
  load_ = std::move(wanted);
  return true;
}

void HeldBrush::set_color(int pigment) {
  check_pigment(pigment);
  colors_ = {{pigment, kAllRows}};
  load_ = wanted_load();
}

ReservoirRows HeldBrush::set_color(int pigment, float from, float to) {
  check_pigment(pigment);
  const ReservoirRows rows = rows_across(from, to);
  colors_.push_back({pigment, rows});
  load_ = wanted_load();
  return rows;
}

/// What the sliders and the colours say it holds.
PaintLoad HeldBrush::wanted_load() const {
  PaintLoad wanted = load_of(colors_.front().pigment);
  for (std::size_t i = 1; i < colors_.size(); ++i)
    wanted.set_rows(load_of(colors_[i].pigment), colors_[i].rows.begin, colors_[i].rows.end);
  return wanted;
}

/// Paint of one pigment, whose film is `film_medium_m` x medium high and holds `film_pigment` x
/// pigment of it.
PaintLoad HeldBrush::load_of(int pigment) const {
  std::vector<float> paint = {kFilmsHeld * model_.film_medium_m * settings_.medium_frac};
  for (std::size_t c = 0; c < amount_.size(); ++c)
    paint.push_back(kFilmsHeld * model_.film_pigment * settings_.pigment_frac * model_.max_pigment *
                    basis_.load(static_cast<Eigen::Index>(c), pigment));
  return {paint, amount_, model_.film_medium_m / model_.film_pigment};
}

void HeldBrush::check_pigment(int pigment) const {
  PENTIMENTO_CHECK(pigment >= 0 && pigment < basis_.load.cols());
}

}  // namespace pentimento
