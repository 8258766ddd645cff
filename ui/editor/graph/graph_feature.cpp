#include "ui/editor/graph/graph_feature.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "ui/editor/graph/graph_panel.h"
#include "ui/editor/graph/graph_state.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

// Reads the graph that was asked for, beside the frames, and hands it to `graph`, which must outlive it; if
// it is stopped, the graph stays left out. The document is not changed. Precondition: graph.is_asked_for().
LongChange graph_reading(GraphState& graph) {
  KERF_ASSERT(graph.is_asked_for());
  graph.no_longer_ask();
  struct Reading {
    GraphState graph;
    bool done = false;
  };
  const auto reading = std::make_shared<Reading>(Reading{graph});
  return {"Reading the graph of " + grouped(graph.left_out()) + " faces",
          [reading](Document& document, const Progress& progress) {
            reading->done = reading->graph.read_left_out(document, progress);
            return Outcome();
          },
          [reading, &graph](const Outcome&) {
            if (reading->done) graph = std::move(reading->graph);
          }};
}

constexpr const char* kGraphPanel = "Graph";

class GraphFeature : public Feature {
 public:
  explicit GraphFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{kGraphPanel, Tab::kLook, 1100, false,
             [this] {
               const bool seen = on_.points() && !on_.view.in_second;
               panel_.draw(graph_, on_.work.document, on_.view,
                           seen ? std::optional(on_.pointer) : std::nullopt);
             },
             Dock::kStrip}};
  }
  std::vector<Gesture> gestures() const override {
    return {{140, "F over the graph", "Show all of it, while the pointer is over it"}};
  }
  bool takes(const InputEvent& event, bool) override {
    const bool fits = event.kind == InputEvent::Kind::kKey && event.button == GLFW_KEY_F && event.mods == 0;
    return fits && panel_.fit_under_pointer();
  }

  void follow_queue(double seconds) override;
  bool moving() const override { return graph_.playing(); }
  void report(nlohmann::ordered_json& report) const override {
    report["graph"] = {{"nodes", graph_.drawn() ? graph_.drawn()->nodes.size() : 0},
                       {"marked", graph_.marked()},
                       {"reached", graph_.reached()},
                       {"total", graph_.total()},
                       {"removed", graph_.removed()},
                       {"removals", graph_.removals()},
                       {"closings", graph_.closings().size()},
                       {"loops", graph_.drawn() ? graph_.drawn()->loops.size() : 0},
                       {"of_piece", graph_.shows_piece()},
                       {"any_open", graph_.any_open()},
                       {"face_lit", on_.view.look.lit_face.has_value()}};
  }

 private:
  Workspace& on_;
  GraphState graph_;
  GraphPanel panel_;
};

void GraphFeature::follow_queue(double seconds) {
  ViewState& view = on_.view;
  const Document& document = on_.work.document;
  const bool panel = on_.panels.shows(kGraphPanel);
  if (!panel && view.look.lit_face) {
    view.look.lit_face.reset();
    view.picture_old = true;
  }
  if (!panel && !view.look.show.graph) return graph_.play(false);
  graph_.follow(document, on_.holds_back());
  graph_.advance(std::min(seconds, Workspace::kLongestStep));
  if (graph_.is_asked_for() && !on_.changes.is_pending() && !document.execution().in_stroke() &&
      document.waiting() == 0)
    on_.changes.begin(graph_reading(graph_));
  if (view.look.graph == graph_.drawn()) return;
  view.look.graph = graph_.drawn();
  if (view.look.show.graph) view.picture_old = true;
}

}  // namespace

std::unique_ptr<Feature> graph_feature(Workspace& on) { return std::make_unique<GraphFeature>(on); }

}  // namespace kerf
