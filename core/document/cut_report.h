#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/mesh/mesh_file.h"
#include "core/world/world.h"

namespace kerf {

// Totals and times of a job, for report.json.
struct CutJob {
  void record_loaded(const MeshReport& mesh);
  // Adds the result of one call of Document::step, which took `seconds` and produced this world.
  void record_step(const StepResult& step, const World& world, double seconds);
  // Call these around each stroke, to detect strokes that hit nothing.
  void begin_stroke();
  void end_stroke();
  // Mean depth of the thermal cut over the time for which the beam hit a face, 0 .. 1 (see StepStatistics).
  double depth_fraction() const { return statistics.met_s > 0 ? statistics.depth_s / statistics.met_s : 0.0; }

  size_t input_faces = 0, input_vertices = 0, input_components = 0;
  double input_area = 0, input_min_angle = 0;  // m^2, degrees
  size_t removed_faces = 0;
  double removed_area = 0;  // m^2
  SolidChange solid;
  Vec3 origin{0};                   // origin of the coordinates in the files [m]
  bool left_open = false;           // a stroke left a solid open: the removed volume is unknown
  std::vector<std::string> notes;   // on the input, open bodies and losses of the files, each once
  std::optional<double> program_s;  // duration of the G-code program that the strokes come from
  size_t strokes = 0;               // number of strokes cut
  std::vector<size_t> missed;       // indices of the strokes that hit nothing, ascending
  size_t faces_before_stroke = 0;   // removed_faces and met_s at the start of the last stroke
  double met_before_stroke_s = 0;
  size_t steps = 0;  // number of beam moves, as requested
  StepStatistics statistics;
  std::vector<double> step_s;  // durations of the calls that removed faces
  bool thermal = false;        // the strokes use the thermal model
  double load_s = 0, build_tree_s = 0, cut_s = 0, save_s = 0;
};

struct WrittenPiece {
  std::string file;  // its output file; in the report of the library the name of the piece
  size_t faces = 0, vertices = 0, boundary_edges = 0;
  double area = 0;               // m^2
  Vec3 centroid{0};              // m
  std::optional<double> volume;  // m^3; nullopt if the piece is not closed
  MassProperties mass;           // in world axes
  Placement placement;           // of its body
  PrecisionLoss precision;       // of the file
  std::optional<bool> asleep;    // nullopt if no body has moved
  bool no_collider = false;      // though colliders are written: its hull has no volume
};

// Returns the settings of a job, i.e. of its first stroke.
nlohmann::ordered_json settings_json(const CutSettings& settings, const std::string& format, bool split_all);

// Returns the smallest interior angle of all live faces in degrees; 0 if a face is degenerate. O(n).
double smallest_angle(const World& world);

bool any_is_solid(const World& world);

nlohmann::ordered_json cut_report(const CutJob& job, const World& world,
                                  const nlohmann::ordered_json& settings,
                                  const std::vector<WrittenPiece>& pieces);

}  // namespace kerf
