#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/mesh/mesh_file.h"
#include "core/tree/surface_comparison.h"
#include "core/world/world.h"

namespace kerf {

// A segment of a stroke, i.e. the way between two keys, or of all keys of a line of a program.
struct CutSegment {
  size_t stroke = 0, segment = 0;  // indices from 0; for a line of a program, its first segment
  std::optional<size_t> line;      // of the program
};

// A segment along which the thermal beam did not get through, at least in part.
struct UncutSegment {
  CutSegment at;
  double depth = 0;  // mean depth of the cut as a fraction of the thickness, see StepStatistics
};

// A stroke that cuts a part which an earlier stroke had already cut free.
struct ScrapCut {
  CutSegment at;        // the first segment that cuts the part
  size_t freed_by = 0;  // index of a stroke
  BodyId body;          // of the part
  uint32_t piece = 0;   // its label
  double area = 0;      // removed from the part, m^2
  Vec3 moment{0};       // centroid of this area, in the world, times the area
};

// The strokes that freed parts.
class FreedParts {
 public:
  // Records the stroke that freed a part, unless the part was freed before.
  void add(const PieceId& part, size_t stroke);
  // Returns the index of the stroke that freed a part; nullopt if none did. O(log^2 n).
  std::optional<size_t> find(const PieceId& part) const;
  // Makes later copies share the parts so far: a copy after each of n parts takes O(n log n) memory in all.
  void share();

 private:
  using Parts = std::map<PieceId, size_t>;

  Parts own_;
  std::vector<std::shared_ptr<const Parts>> shared_;  // each longer than the next one
};

// Standoff and collisions of the nozzle along a segment.
struct NozzleSegment {
  CutSegment at;
  std::optional<Interval> standoff;  // m; nullopt if the beam meets no mesh
  bool collides = false;
};

// The motion of strokes onto the part as measured, with the distances that remain.
struct FittedStrokes {
  RigidMotion motion;
  double rms = 0, max = 0;        // m
  std::vector<double> residuals;  // of the datum points, m; empty for a mesh
};

// Share of a segment along which the axis of the beam may still meet a face after the stroke: at the start,
// until the beam has pierced the sheet.
inline constexpr double kUncutShare = 0.1;

// Totals and times of a job, for report.json.
struct CutJob {
  void record_loaded(const MeshReport& mesh);
  // Adds the result of one call of Document::step, which took `seconds` and produced this world.
  void record_step(const StepResult& step, const World& world, double seconds);
  // Call these around each stroke, to detect strokes that hit nothing.
  void begin_stroke();
  void end_stroke();
  // Lists the current segment and returns true if the beam met faces since `before`, the statistics at its
  // beginning. Segments that turn out to be cut through must be removed at the end of the stroke.
  bool record_segment(const StepStatistics& before);
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
  std::optional<FittedStrokes> fit;
  std::vector<NozzleSegment> nozzle;  // in order; empty if it is not checked
  size_t strokes = 0;                 // number of strokes cut
  // The owner sets `segment` as the beam moves, and lists uncut segments. Otherwise the report has none.
  bool follows_segments = false;
  CutSegment segment;               // the current one
  std::vector<size_t> missed;       // indices of the strokes that hit nothing, ascending
  std::vector<UncutSegment> uncut;  // in order; thermal model only
  std::vector<ScrapCut> scrap;      // by stroke and part
  FreedParts freed_by;
  size_t faces_before_stroke = 0;  // removed_faces and met_s at the start of the last stroke
  double met_before_stroke_s = 0;
  size_t steps = 0;  // number of beam moves, as requested
  StepStatistics statistics;
  std::vector<double> step_s;  // durations of the calls that removed faces
  bool thermal = false;        // the strokes use the thermal model
  double load_s = 0, build_tree_s = 0, cut_s = 0, save_s = 0;

 private:
  // Lists the cuts of parts that an earlier stroke freed, and the parts that this one frees.
  void record_parts(const BodyDelta& body, const World& world);
};

struct WrittenPiece {
  std::string file;       // its output file; in the report of the library the name of the piece
  std::string outline{};  // file with its outline; empty if there is none
  size_t faces = 0, vertices = 0, boundary_edges = 0;
  double area = 0;               // m^2
  Vec3 centroid{0};              // m
  std::optional<double> volume;  // m^3; nullopt if the piece is not closed
  MassProperties mass;           // in world axes
  Placement placement;           // of its body
  PrecisionLoss precision;       // of the file
  std::optional<bool> asleep;    // nullopt if no body has moved
  PieceId piece{};               // whose faces it holds
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
