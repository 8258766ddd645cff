#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/world/world.h"

namespace kerf {

// Sums and times of a job, for report.json.
struct CutJob {
  void note_loaded(const MeshReport& mesh);
  // A call of Document::step.
  void note_bite(const StepResult& bite, double seconds);

  size_t input_faces = 0, input_vertices = 0, input_components = 0;
  double input_area = 0, input_min_angle = 0;  // m^2, degrees
  size_t removed_faces = 0;
  double removed_area = 0;  // m^2
  size_t steps = 0;         // in which the strokes were walked, as asked for
  StepFigures figures;
  std::vector<double> step_s;  // of the bites that removed something
  double load_s = 0, build_tree_s = 0, cut_s = 0, save_s = 0;
};

// A piece that was written.
struct WrittenPiece {
  std::string file;
  size_t faces = 0, vertices = 0, boundary_edges = 0;
  double area = 0;
  Vec3 centroid{0};
};

// The settings of a job as the report holds them: those of its first stroke.
nlohmann::ordered_json settings_json(const CutSettings& settings, const std::string& format, bool split_all);

// The smallest angle of the live faces, degrees; 0 where a face has no area.
double smallest_angle(const World& world);

nlohmann::ordered_json cut_report(const CutJob& job, const World& world,
                                  const nlohmann::ordered_json& settings,
                                  const std::vector<WrittenPiece>& pieces);

}  // namespace kerf
