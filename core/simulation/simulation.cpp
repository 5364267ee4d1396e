#include "core/simulation/simulation.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/finite.h"
#include "core/base/give_back.h"
#include "core/brush/held_brush.h"
#include "core/brush/transfer.h"
#include "core/canvas/canvas_source.h"
#include "core/simulation/drying.h"
#include "core/simulation/make_scheme.h"

namespace pentimento {

namespace {
struct TouchState {
  explicit TouchState(int channels) : reservoir(channels) {}
  Reservoir reservoir;
  std::uint32_t stroke_id = 0;
  bool down = false;
};

PaintAccount empty_account(int channels) {
  PaintAccount account;
  for (PaintFlow* flow : {&account.deposited, &account.picked_up, &account.dried})
    flow->channel.assign(static_cast<std::size_t>(channels), 0.0);
  return account;
}

struct ExpectedStamp {
  int touch_id = 0;
  Stamp stamp;
};

std::string non_finite_in(const CanvasSource& canvas, PlaneId plane, const std::string& name) {
  std::vector<float> row(static_cast<std::size_t>(canvas.geometry().width));
  for (int y = 0; y < canvas.geometry().height; ++y) {
    canvas.read(plane, 0, y, row);
    if (all_finite(row)) continue;
    for (std::size_t x = 0; x < row.size(); ++x)
      if (!all_finite({&row[x], 1}))
        return name + " at cell (" + std::to_string(x) + "," + std::to_string(y) + ")";
  }
  return {};
}
}  // namespace

struct Simulation::Impl {
  Impl(SimulationSetup given, const Threads& with)
      : setup(std::move(given)),
        threads(with),
        model(setup.model),
        amount(setup.basis.amount.begin(), setup.basis.amount.end()),
        account(empty_account(setup.basis.channels())),
        held(setup.basis, model, setup.tips) {
    fresh_canvas();
  }

  /// Paper, no paint; the books start anew. The relief goes on from the setup, or from the canvas
  /// that was.
  void fresh_canvas() {
    const std::int64_t step = state.step;
    Field<float> paper_m = state.paper.empty() ? std::move(setup.paper_m) : take_paper();
    state = make_canvas_state(setup.geometry, model.layers, setup.basis.channels(),
                              static_cast<int>(setup.paper_reflectance.size()), 0.0f);
    state.step = step;
    for (std::size_t band = 0; band < setup.paper_reflectance.size(); ++band)
      state.reflectance[band].fill(setup.paper_reflectance[band]);
    if (!paper_m.empty()) state.base_m = std::move(paper_m);
    account = empty_account(setup.basis.channels());
    adopt_state();
    fresh = true;
  }

  /// The relief of the canvas that was, in the memory of its base.
  Field<float> take_paper() {
    std::vector<float> row(static_cast<std::size_t>(state.geometry.width));
    for (int y = 0; y < state.geometry.height; ++y) {
      read_paper(state, 0, y, row);
      float* base_m = state.base_m.row(y);
      if (std::memcmp(row.data(), base_m, row.size() * sizeof(float)) != 0)
        std::copy(row.begin(), row.end(), base_m);
    }
    return std::move(state.base_m);
  }

  /// What refers to the planes of the state is made again.
  void adopt_state() {
    fresh = false;
    scheme = make_scheme(model.scheme, setup.geometry, state.layers, state.channels);
    contact = make_brush_contact(setup.geometry.width, setup.geometry.height);
    transfer.emplace(state, contact, account, amount, threads);
    transfer->set_listener(listener);
  }

  void fill_brushes() {
    for (auto& [id, touch] : touches) dip(touch);
  }

  /// What lays no film starts clean, not dipped.
  void dip(TouchState& touch) const {
    if (held.brush().lays_paint()) {
      touch.reservoir.fill(held.load());
    } else {
      touch.reservoir.empty();
    }
  }

  SimulationSetup setup;
  const Threads& threads;
  Model model;
  std::vector<float> amount;
  PaintAccount account;
  CanvasState state;
  BrushContact contact;
  std::unique_ptr<FluidScheme> scheme;
  std::optional<Transfer> transfer;
  CanvasListener* listener = nullptr;
  bool fresh = false;  // StepInput::fresh, of the next step

  HeldBrush held;
  std::map<int, TouchState> touches;
  std::optional<ExpectedStamp> expected;
  Vec3f gravity_m_s2{0, 0, 9.81f};
  std::int64_t stamps = 0;
};

Simulation::Simulation(SimulationSetup setup, const Threads& threads)
    : impl_(std::make_unique<Impl>(std::move(setup), threads)) {}
Simulation::~Simulation() = default;

void Simulation::set_settings(const BrushSettings& settings) {
  if (impl_->held.set_settings(settings)) impl_->fill_brushes();
}

void Simulation::set_brush(const BrushDefinition& brush) {
  impl_->transfer->forget_tip();
  if (impl_->held.take(brush)) impl_->fill_brushes();
}

void Simulation::set_color(int pigment) {
  impl_->held.set_color(pigment);
  impl_->fill_brushes();
}

void Simulation::set_color(int pigment, float from, float to) {
  const ReservoirRows rows = impl_->held.set_color(pigment, from, to);
  if (!impl_->held.brush().lays_paint()) return;
  for (auto& [id, touch] : impl_->touches)
    touch.reservoir.fill_rows(impl_->held.load(), rows.begin, rows.end);
}

void Simulation::begin_stroke(int touch_id, std::uint32_t stroke_id) {
  const auto [found, is_new] = impl_->touches.try_emplace(touch_id, impl_->state.channels);
  TouchState& touch = found->second;
  if (is_new) impl_->dip(touch);
  touch.down = true;
  touch.stroke_id = stroke_id;
  touch.reservoir.density_frac = impl_->held.settings().load_frac;
  touch.reservoir.dry_ahead_frac = 1;
}

void Simulation::stamp(int touch_id, const Stamp& stamp) {
  const auto touch = impl_->touches.find(touch_id);
  PENTIMENTO_CHECK(touch != impl_->touches.end() && touch->second.down);
  HeldBrush& held = impl_->held;
  const BrushInHand hand{held.brush(), held.tip(), held.settings(), held.load(),
                         touch->second.stroke_id};
  const std::optional<ExpectedStamp> expected = std::exchange(impl_->expected, std::nullopt);
  const bool is_next = expected && expected->touch_id == touch_id;
  impl_->transfer->apply(stamp, is_next ? &expected->stamp : nullptr, hand, impl_->model,
                         touch->second.reservoir);
  ++impl_->stamps;
}

void Simulation::expect(int touch_id, const Stamp& next) {
  impl_->expected = ExpectedStamp{touch_id, next};
}

void Simulation::end_stroke(int touch_id) {
  const auto touch = impl_->touches.find(touch_id);
  if (touch != impl_->touches.end()) touch->second.down = false;
}

void Simulation::set_listener(CanvasListener* listener) {
  impl_->listener = listener;
  impl_->transfer->set_listener(listener);
}

void Simulation::set_gravity(Vec3f gravity_m_s2) {
  impl_->gravity_m_s2 = gravity_m_s2;
}

void Simulation::set_model(const Model& model) {
  PENTIMENTO_CHECK(model.scheme == impl_->model.scheme && model.layers == impl_->model.layers);
  impl_->model = model;
  if (impl_->held.reload()) impl_->fill_brushes();
  impl_->state.sleep.clear();  // what rested may not rest under other parameters
}

void Simulation::dry() {
  if (impl_->listener != nullptr)
    impl_->listener->drying(impl_->state, impl_->setup.basis, impl_->model);
  dry_canvas(impl_->state, impl_->setup.basis, impl_->model, EdgeCells::kPartlyCovered,
             impl_->threads, impl_->account.dried);
  impl_->state.sleep.clear();
  impl_->fresh = true;
}

void Simulation::clear() {
  impl_->fresh_canvas();
  if (impl_->listener != nullptr) impl_->listener->cleared();
}

void Simulation::load(const std::vector<Field<float>>& reflectance) {
  PENTIMENTO_CHECK(static_cast<int>(reflectance.size()) == impl_->state.bands);
  impl_->fresh_canvas();
  for (std::size_t band = 0; band < reflectance.size(); ++band) {
    PENTIMENTO_CHECK(reflectance[band].width() == impl_->setup.geometry.width &&
                     reflectance[band].height() == impl_->setup.geometry.height);
    for (int y = 0; y < reflectance[band].height(); ++y)
      impl_->state.reflectance[band].write(0, y, reflectance[band].view().row_span(y));
  }
  if (impl_->listener != nullptr) impl_->listener->cleared();
}

std::unique_ptr<Simulation> Simulation::fork(const Threads& threads) const {
  const Impl& from = *impl_;
  SimulationSetup setup{from.setup.geometry,
                        from.model,
                        from.setup.basis,
                        from.setup.dt_s,
                        Field<float>(),  // comes with the state
                        from.setup.paper_reflectance,
                        from.setup.tips};
  auto twin = std::make_unique<Simulation>(std::move(setup), threads);
  Impl& to = *twin->impl_;
  to.account = from.account;
  to.state = clone_state(from.state);
  to.adopt_state();
  to.contact = clone(from.contact);
  to.fresh = from.fresh;
  to.held.become(from.held);
  to.touches = from.touches;
  to.gravity_m_s2 = from.gravity_m_s2;
  to.stamps = from.stamps;
  to.scheme->recall(from.scheme->memory());
  return twin;
}

SimulationMemory Simulation::memory() const {
  SimulationMemory memory;
  for (const auto& [id, touch] : impl_->touches)
    memory.touches.push_back({id, touch.stroke_id, touch.down, touch.reservoir.content()});
  memory.account = impl_->account;
  memory.stamps = impl_->stamps;
  memory.fresh = impl_->fresh;
  memory.scheme = impl_->scheme->memory();
  return memory;
}

bool Simulation::fits(const SimulationMemory& memory) const {
  const auto channels = static_cast<std::size_t>(basis().channels());
  const PaintAccount& account = memory.account;
  for (const PaintFlow* flow : {&account.deposited, &account.picked_up, &account.dried})
    if (flow->channel.size() != channels) return false;
  const std::size_t texels = Reservoir(basis().channels()).content().texels.size();
  for (const TouchMemory& touch : memory.touches)
    if (touch.reservoir.texels.size() != texels) return false;
  return impl_->scheme->fits(memory.scheme);
}

void Simulation::recall(CanvasState state, const SimulationMemory& memory) {
  Impl& m = *impl_;
  PENTIMENTO_CHECK(fits(memory));
  PENTIMENTO_CHECK(state.geometry.width == m.setup.geometry.width &&
                   state.geometry.height == m.setup.geometry.height &&
                   state.layers == m.model.layers && state.channels == m.setup.basis.channels());
  std::vector<float> paper_m(static_cast<std::size_t>(state.geometry.width));
  for (int y = 0; y < state.geometry.height; ++y) {
    read_paper(m.state, 0, y, paper_m);
    write_paper(state, 0, y, paper_m);
  }
  m.state = std::move(state);
  m.account = memory.account;
  m.touches.clear();
  for (const TouchMemory& touch : memory.touches) {
    TouchState& made = m.touches.try_emplace(touch.id, m.state.channels).first->second;
    made.reservoir.restore(touch.reservoir);
    made.stroke_id = touch.stroke_id;
    made.down = touch.down;
  }
  m.stamps = memory.stamps;
  m.adopt_state();
  m.fresh = memory.fresh;
  m.scheme->recall(memory.scheme);
}

void Simulation::restore(CanvasState state) {
  PENTIMENTO_CHECK(state.geometry.width == impl_->setup.geometry.width &&
                   state.geometry.height == impl_->setup.geometry.height &&
                   state.layers == impl_->model.layers &&
                   state.channels == impl_->setup.basis.channels());
  impl_->state = std::move(state);
  impl_->account = empty_account(impl_->state.channels);
  impl_->account.deposited = wet_paint(impl_->state);
  impl_->adopt_state();
  if (impl_->listener != nullptr) impl_->listener->restored(impl_->state);
}

bool Simulation::step() {
  Impl& m = *impl_;
  const bool touched = !m.contact.empty();
  const StepInput in{m.model,  m.gravity_m_s2, m.setup.dt_s, m.contact,
                     m.amount, m.threads,      m.listener,   m.fresh};
  if (m.listener != nullptr) m.listener->stepping();
  const bool moved = m.scheme->step(m.state, in);
  if (m.listener != nullptr) m.listener->stepped(m.state, in);
  pentimento::clear(m.contact);
  // What the brush left is zeros again.
  if (PlaneMemory::leaves_out(m.state.geometry.width, m.state.geometry.height) &&
      m.state.step % kStepsBetweenGivingBack == 0)
    give_back(m.contact);
  m.fresh = false;
  ++m.state.step;
  return moved || touched;
}

void Simulation::skip(std::int64_t steps) {
  PENTIMENTO_CHECK(steps >= 0 && impl_->contact.empty());
  impl_->state.step += steps;
}

const CanvasState& Simulation::state() const {
  return impl_->state;
}
const Model& Simulation::model() const {
  return impl_->model;
}
const CanvasGeometry& Simulation::geometry() const {
  return impl_->setup.geometry;
}
const ChannelBasis& Simulation::basis() const {
  return impl_->setup.basis;
}
const PaintAccount& Simulation::account() const {
  return impl_->account;
}
PaintFlow Simulation::wet() const {
  return wet_paint(impl_->state);
}

std::string Simulation::first_non_finite() const {
  const CanvasState& s = impl_->state;
  const StateSource canvas(s);
  std::vector<std::pair<PlaneId, std::string>> planes = {{{PlaneKind::kDepth}, "depth"},
                                                         {{PlaneKind::kVelocityX}, "velocity_x"},
                                                         {{PlaneKind::kVelocityY}, "velocity_y"},
                                                         {{PlaneKind::kBase}, "base"}};
  for (int band = 0; band < s.bands; ++band)
    planes.emplace_back(reflectance_plane(band), "reflectance " + std::to_string(band));
  for (int layer = 0; layer < s.layers; ++layer)
    for (int c = 0; c < s.channels; ++c)
      planes.emplace_back(pigment_plane(layer, c),
                          "layer " + std::to_string(layer) + " channel " + std::to_string(c));
  std::vector<std::string> found(planes.size());
  impl_->threads.for_ranges(0, static_cast<int>(planes.size()), 1, [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      found[i] = non_finite_in(canvas, planes[i].first, planes[i].second);
  });
  const auto first =
      std::find_if(found.begin(), found.end(), [](const std::string& f) { return !f.empty(); });
  return first == found.end() ? std::string() : *first;
}

std::vector<std::pair<std::string, double>> Simulation::statistics() const {
  auto all = impl_->scheme->statistics();
  all.emplace_back("stamps", static_cast<double>(impl_->stamps));
  return all;
}

}  // namespace pentimento
