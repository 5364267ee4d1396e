#include "replay/play/hand.h"

#include <array>
#include <vector>

#include "formats/image/read_image.h"
#include "formats/image/resample.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/slider_fields.h"

namespace pentimento {

Vec3f core_gravity(const log::Gravity& gravity) {
  return {static_cast<float>(gravity.x_m_s2), static_cast<float>(-gravity.y_m_s2),
          static_cast<float>(gravity.z_m_s2)};
}

Hand::Hand(Painter& painter, const HandInput& input) : painter_(painter), input_(input) {
  painter_.set_gravity(input_.fixed_gravity.value_or(core_gravity({})));
  painter_.set_brush(input_.brushes.first());
  painter_.set_settings(settings_);
  painter_.set_color(input_.first_color);
}

Result<void> Hand::apply(const Cue& cue, const Cue* next) {
  if (const auto* stamp = std::get_if<StrokeStamp>(&cue.what)) {
    const auto* following = next == nullptr ? nullptr : std::get_if<StrokeStamp>(&next->what);
    if (following != nullptr) painter_.expect(following->slot, following->stamp);
    painter_.stamp(stamp->slot, stamp->stamp);
  } else if (const auto* begin = std::get_if<StrokeBegin>(&cue.what)) {
    painter_.begin_stroke(begin->slot, begin->stroke_id);
  } else if (const auto* end = std::get_if<StrokeEnd>(&cue.what)) {
    painter_.end_stroke(end->slot);
  } else {
    return act(std::get<log::Action>(cue.what));
  }
  return {};
}

Result<void> Hand::act(const log::Action& action) {
  if (const auto* gravity = std::get_if<log::Gravity>(&action)) {
    if (!input_.fixed_gravity) painter_.set_gravity(core_gravity(*gravity));
  } else if (const auto* slider = std::get_if<log::Slider>(&action)) {
    slide(*slider);
  } else if (const auto* color = std::get_if<log::Color>(&action)) {
    dip(*color);
  } else if (const auto* brush = std::get_if<log::BrushChange>(&action)) {
    painter_.set_brush(input_.brushes.find(brush->name));
  } else if (std::holds_alternative<log::Dry>(action)) {
    painter_.dry();
  } else if (std::holds_alternative<log::Clear>(action)) {
    if (input_.detail_substrate != nullptr) input_.detail_substrate->clear();
    painter_.clear();
  } else if (const auto* picture = std::get_if<log::Load>(&action)) {
    return load(*picture);
  }
  return {};
}

void Hand::dip(const log::Color& color) {
  const int pigment = input_.palette.find(color);
  if (!color.across) return painter_.set_color(pigment);
  painter_.set_color(pigment, static_cast<float>((*color.across)[0]),
                     static_cast<float>((*color.across)[1]));
}

void Hand::slide(const log::Slider& slider) {
  Model model = painter_.model();
  log::apply_slider(slider.name, slider.value, settings_, model);
  if (log::find_model_field(slider.name) != nullptr) {
    painter_.set_model(model);
  } else {
    painter_.set_settings(settings_);
  }
}

Result<void> Hand::follow(const Cue& cue) {
  if (const auto* begin = std::get_if<StrokeBegin>(&cue.what)) followed_down_.insert(begin->slot);
  if (const auto* end = std::get_if<StrokeEnd>(&cue.what)) followed_down_.erase(end->slot);
  const auto* action = std::get_if<log::Action>(&cue.what);
  if (action == nullptr || std::holds_alternative<log::Dry>(*action)) return {};
  if (std::holds_alternative<log::Clear>(*action)) {
    if (input_.detail_substrate != nullptr) input_.detail_substrate->clear();
    return {};
  }
  const auto* picture = std::get_if<log::Load>(action);
  if (picture == nullptr) return act(*action);
  if (input_.detail_substrate == nullptr) return {};
  Result<std::array<Field<float>, 3>> rgb = read_picture(*picture);
  if (!rgb) return rgb.error();
  show_to_detail(*rgb);
  return {};
}

Result<std::array<Field<float>, 3>> Hand::read_picture(const log::Load& load) {
  Result<std::string> path = input_.files.use(load.file);
  if (!path) return path.error();
  return read_rgb(*path);
}

/// The detail canvas takes a picture at its own size.
void Hand::show_to_detail(const std::array<Field<float>, 3>& rgb) {
  if (input_.detail_substrate != nullptr)
    input_.detail_substrate->load(input_.maker.substrate(rgb));
}

Result<void> Hand::load(const log::Load& load) {
  Result<std::array<Field<float>, 3>> rgb = read_picture(load);
  if (!rgb) return rgb.error();
  const CanvasGeometry& grid = painter_.geometry();
  std::array<Field<float>, 3> on_grid;
  for (std::size_t c = 0; c < 3; ++c)
    on_grid[c] = resample_to((*rgb)[c].view(), grid.width, grid.height);
  show_to_detail(*rgb);
  painter_.load(input_.maker.substrate(on_grid));
  return {};
}

}  // namespace pentimento
