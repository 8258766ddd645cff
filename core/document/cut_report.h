#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/mesh/mesh_file.h"
#include "core/world/world.h"

namespace kerf {

// The totals and times of a job, for report.json.
struct CutJob {
  // Adds a loaded mesh to the totals of the input.
  void record_loaded(const MeshReport& mesh);
  // Adds the result of one call of Document::step, which took `seconds` and left this world.
  void record_bite(const StepResult& bite, const World& world, double seconds);
  // To be called around each stroke, so that those are known that met nothing.
  void begin_stroke();
  void end_stroke();
  // How much of the thickness the beam got through where it did not cut, from 0 to 1.
  double depth_fraction() const { return statistics.met_s > 0 ? statistics.depth_s / statistics.met_s : 0.0; }

  size_t input_faces = 0, input_vertices = 0, input_components = 0;
  double input_area = 0, input_min_angle = 0;  // m^2, degrees
  size_t removed_faces = 0;
  double removed_area = 0;  // m^2
  SolidChange solid;
  Vec3 origin{0};                  // about which the files hold coordinates, m
  bool left_open = false;          // a stroke left a solid open: the volume that was removed is not known
  std::vector<std::string> notes;  // on the input, bodies left open and what the files lose, each once
  size_t strokes = 0;              // that were cut
  std::vector<size_t> missed;      // those that met nothing, by index, ascending
  size_t faces_before_stroke = 0;  // removed_faces and met_s when the last stroke began
  double met_before_stroke_s = 0;
  size_t steps = 0;  // number of moves of the beam, as requested
  StepStatistics statistics;
  std::vector<double> step_s;  // durations of the calls that removed something
  bool thermal = false;        // the strokes are cut by the thermal model
  double load_s = 0, build_tree_s = 0, cut_s = 0, save_s = 0;
};

// A piece as the report has it.
struct WrittenPiece {
  std::string file;  // that it was written to; in the report of the library the name of the piece
  size_t faces = 0, vertices = 0, boundary_edges = 0;
  double area = 0;               // m^2
  Vec3 centroid{0};              // m
  std::optional<double> volume;  // m^3; nothing where the piece is not closed
  MassProperties mass;           // in world axes
  Placement placement;           // of the body that it belongs to
  PrecisionLoss precision;       // of the file
  std::optional<bool> asleep;    // nothing where no body has moved
};

// The settings of a job, i.e. of its first stroke, for the report.
nlohmann::ordered_json settings_json(const CutSettings& settings, const std::string& format, bool split_all);

// The smallest interior angle of all live faces in degrees; 0 if a face is degenerate. O(n).
double smallest_angle(const World& world);

// Whether a body of the world is solid.
bool any_is_solid(const World& world);

// The contents of report.json.
nlohmann::ordered_json cut_report(const CutJob& job, const World& world,
                                  const nlohmann::ordered_json& settings,
                                  const std::vector<WrittenPiece>& pieces);

}  // namespace kerf
