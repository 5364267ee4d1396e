#pragma once
// A follower that does nothing, for tests that look at one thing that followers are told.

#include "core/simulation/canvas_listener.h"

namespace pentimento::test {

class IdleListener : public CanvasListener {
 public:
  void begin_stamp() override {}
  void draw_tip(const StampPlan&) override {}
  void before_deposit(const StampPlan&, const CanvasState&) override {}
  void after_deposit(const StampPlan&, const CanvasState&) override {}
  void end_stamp() override {}
  PaintEdges& edges() override { return edges_; }
  void moved(const CanvasState&, const StepInput&, const std::vector<conservative::Run>&) override {
  }
  void stepped(const CanvasState&, const StepInput&) override {}
  void drying(const CanvasState&, const ChannelBasis&, const Model&) override {}
  void cleared() override {}
  void restored(const CanvasState&) override {}

 private:
  PaintEdges edges_;
};

}  // namespace pentimento::test
