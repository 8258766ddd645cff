#ifndef KERF_KERF_C_H
#define KERF_KERF_C_H

/* Kerf as a C library: reads or creates triangle meshes, cuts them with a laser, returns the pieces as
 * arrays, and traces rays. core/README.md, section Stability, states what later versions keep.
 *
 * Units are SI: metres, seconds, watts, kilograms, kelvin. Frames are right-handed with +Y up; faces are
 * counter-clockwise seen from outside. An array of n points or directions holds 3 n numbers: x, y, z.
 *
 * Errors: a function that can fail returns a kerf_result; kerf_last_error() then returns one sentence that
 * says what failed, where, and what to do. A null pointer is KERF_INVALID_ARGUMENT unless stated otherwise.
 * A failed call changes nothing, unless stated otherwise. No exception leaves the library, and no argument
 * ends the process except an invalid pointer. `options` may be null; `out` receives the result, which the
 * caller owns: destroy meshes by kerf_mesh_destroy and worlds by kerf_world_destroy; free hits, pieces and
 * texts by the functions named there.
 *
 * Structs: the first member of most is `size`, the sizeof of the caller's header. A later version appends
 * members: for a smaller struct, the library uses the defaults of the missing members and does not write
 * them. KERF_..._INIT sets the size and the defaults. A valid size is a multiple of 8, at least 8 and at most
 * the sizeof in the library's own header; any other is KERF_INVALID_ARGUMENT.
 *
 * Determinism: results are bit-identical on every x86-64 processor, those of simulations with the same C
 * library and Bullet. They do not depend on the number of threads, the locale, or the caller's rounding and
 * flush-to-zero modes, which are restored on return.
 *
 * Threads: all functions may be called from several threads at the same time. Any number of calls may read
 * one world (`const kerf_world*`). A call that changes a world (`kerf_world*`) needs exclusive access: it
 * fails with KERF_BUSY while another call uses the world, and until it returns, other calls on that world
 * fail with KERF_BUSY. A mesh is immutable and may be shared. */

#include "kerf_c_mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* -- Worlds -- */

/* The bodies that a laser cuts, with their AABB trees. */
typedef struct kerf_world kerf_world;

/* Id of a body in its world; never refers to a second body. */
typedef uint64_t kerf_body;
#define KERF_NO_BODY UINT64_MAX

/* Label of no piece. A piece is the connected faces of a body with one label; it keeps its label in its body
 * and when it becomes a body of its own. */
#define KERF_NO_PIECE UINT32_MAX

/* Index of a face in its body. After a split, the index refers to one of the parts. The index of a removed
 * face is reused only after an undo, or after a cut or stroke that failed or was cancelled. If a piece is
 * detached, the faces of the smaller side get new indices (see kerf_detached). */
#define KERF_NO_FACE UINT32_MAX

/* Creates an empty world. O(1). */
KERF_API kerf_result kerf_world_create(kerf_world** out);

/* Creates a world from a file.
 * path: a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh. An incomplete last
 *   line of a journal is ignored.
 * Errors: KERF_INVALID_ARGUMENT for an invalid file; KERF_FAILED, e.g. if the strokes of a scene would make
 * more faces than the memory holds; KERF_CANCELLED. Cost: loading the meshes and replaying the cuts. */
KERF_API kerf_result kerf_world_open(const char* path, const kerf_call_options* options, kerf_world** out);

/* Destroys a world. No-op if `world` is null. Precondition: no other call uses the world. */
KERF_API void kerf_world_destroy(kerf_world* world);

/* Properties of a new body. */
typedef struct kerf_body_desc {
  size_t size;
  const char* name;      /* UTF-8; null: "mesh" */
  double position[3];    /* m; x_world = orientation * x_mesh + position */
  double orientation[4]; /* unit quaternion w x y z */
  const char* material;  /* a name from `kerf materials`; null: mild steel */
  double thickness;      /* of the sheet [m], 1e-9 to 1000 */
  double density;        /* kg/m^3, 1e-3 to 1e6; 0: that of the material */
  int is_solid;          /* 1: the faces enclose a volume; strokes need a smooth rim and close it by walls */
  int is_hidden;         /* 1: neither cut nor hit by rays */
  int is_fixed;          /* 1: does not move in a simulation */
  int reserved;          /* 0 */
} kerf_body_desc;
#define KERF_BODY_DESC_INIT \
  { sizeof(kerf_body_desc), NULL, {0, 0, 0}, {1, 0, 0, 0}, NULL, 0.001, 0, 0, 0, 0, 0 }

/* Adds a copy of a mesh as a new body, and builds its AABB tree. A step of the history.
 * desc, options: may be null.
 * body: receives the id; may be null.
 * Errors: KERF_INVALID_ARGUMENT for an invalid description, or a mesh that has no usable face or is wider
 * than 1e150 m; KERF_CANCELLED. O(n log n), about 0.5 us per face, whatever the number of bodies. */
KERF_API kerf_result kerf_world_add(kerf_world* world, const kerf_mesh* mesh, const kerf_body_desc* desc,
                                    const kerf_call_options* options, kerf_body* body);

/* Properties of a body. */
typedef struct kerf_body_info {
  size_t size;
  const char* name;      /* valid until the world changes; see kerf_body_get_name */
  const char* material;  /* a name from `kerf materials`; null for any other; static */
  double position[3];    /* m; x_world = orientation * x_body + position */
  double orientation[4]; /* unit quaternion w x y z */
  double velocity[3];    /* m/s, of the point at `position`, in world axes */
  double spin[3];        /* angular velocity in world axes [rad/s] */
  double thickness;      /* m */
  double density;        /* kg/m^3 */
  size_t face_count;
  size_t piece_count;
  int is_solid, is_hidden, is_fixed;
  int is_asleep; /* 1: at rest until something touches it */
} kerf_body_info;
#define KERF_BODY_INFO_INIT                                                                                 \
  {                                                                                                         \
    sizeof(kerf_body_info), NULL, NULL, {0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0, 0, 0, 0, 0, 0, \
        0                                                                                                   \
  }

/* Writes the properties of a body. info: its size is set.
 * Errors: KERF_INVALID_ARGUMENT if there is no such body. O(pieces). */
KERF_API kerf_result kerf_body_get_info(const kerf_world* world, kerf_body body, kerf_body_info* info);

/* Returns a copy of the name of a body, for a world that other threads may change: the name that its only
 * piece was given by kerf_piece_rename, else its own.
 * out: receives the text; free it with kerf_text_free.
 * Errors: KERF_INVALID_ARGUMENT if there is no such body. O(pieces). */
KERF_API kerf_result kerf_body_get_name(const kerf_world* world, kerf_body body, char** out);

/* Returns a piece of a body as a mesh in world coordinates, with its mass properties.
 * Errors: KERF_INVALID_ARGUMENT if there is no such piece. O(n log n), and O(faces of the body). */
KERF_API kerf_result kerf_piece_get_mesh(const kerf_world* world, kerf_body body, uint32_t piece,
                                         kerf_mesh** out);

/* Edits of a piece, each a step of the history unless nothing changes. Except for renaming, a piece that is
 * not the only one of its body first becomes a body of its own (see kerf_detached).
 * body, piece: of the piece; label 0 is that of a body that was not cut.
 * now: receives the body of the piece after the edit; may be null.
 * Errors: KERF_INVALID_ARGUMENT if there is no such piece, or for an invalid value. O(bodies), and O(faces of
 * the body) if the piece is detached. */

/* Places it at a pose and stops its motion: x_world = orientation * x_body + position [m], where x_body is in
 * the frame of its body and orientation is a unit quaternion w x y z. */
KERF_API kerf_result kerf_piece_move(kerf_world* world, kerf_body body, uint32_t piece,
                                     const double position[3], const double orientation[4], kerf_body* now);
/* Sets its sheet; arguments as in kerf_body_desc. */
KERF_API kerf_result kerf_piece_set_sheet(kerf_world* world, kerf_body body, uint32_t piece,
                                          const char* material, double thickness, double density,
                                          kerf_body* now);
KERF_API kerf_result kerf_piece_set_solid(kerf_world* world, kerf_body body, uint32_t piece, int is_solid,
                                          kerf_body* now);
KERF_API kerf_result kerf_piece_set_hidden(kerf_world* world, kerf_body body, uint32_t piece, int is_hidden,
                                           kerf_body* now);
KERF_API kerf_result kerf_piece_set_fixed(kerf_world* world, kerf_body body, uint32_t piece, int is_fixed,
                                          kerf_body* now);
/* Renames it. name: UTF-8. */
KERF_API kerf_result kerf_piece_rename(kerf_world* world, kerf_body body, uint32_t piece, const char* name);
/* Removes it from the world. */
KERF_API kerf_result kerf_piece_remove(kerf_world* world, kerf_body body, uint32_t piece);

typedef enum kerf_joint_kind {
  KERF_JOINT_WELD = 0,  /* the parts move as one */
  KERF_JOINT_HINGE = 1, /* rotation about the axis, within limits */
  KERF_JOINT_HUB = 2    /* free rotation about the axis, as of a wheel */
} kerf_joint_kind;

/* A joint between two parts of a body that are not connected. A part is the connected faces of which one is
 * the nearest to a point. Lengths are in the frame of the body. */
typedef struct kerf_joint {
  size_t size;
  kerf_joint_kind kind;
  int has_limits;   /* 1: a hinge turns only within `limits` */
  double part_a[3]; /* a point of the first part [m] */
  double part_b[3]; /* a point of the second part [m] */
  double anchor[3]; /* a point of the axis [m] */
  double axis[3]; /* of a hinge or hub, of any non-zero length. The first part turns about it relative to the
                     second one, by the right-hand rule */
  double limits[2]; /* degrees, -180 <= limits[0] <= 0 <= limits[1] <= 180 */
  double
      radius; /* m, > 0: faces of a part carry the joint up to this distance from its point; INFINITY: all */
} kerf_joint;
#define KERF_JOINT_INIT \
  { sizeof(kerf_joint), KERF_JOINT_WELD, 0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0}, INFINITY }

/* Adds a joint to a body that has neither been cut nor come apart; a step of the history. Parts that only
 * hinges and hubs hold become bodies of their own in a simulation, and turn on them. A joint is released when
 * strokes have removed all faces of one side, or those that reach the axis of a hinge. Errors:
 * KERF_INVALID_ARGUMENT if there is no such body, for an invalid number, if no face of a part is within the
 * radius, if a face would carry both sides, or if the anchor is farther from the mesh than a hundred times
 * its size. O(faces). */
KERF_API kerf_result kerf_body_join(kerf_world* world, kerf_body body, const kerf_joint* joint);

/* Sets the environment of simulations; a step of the history.
 * gravity: m/s^2; by default (0, -9.81, 0).
 * ground: height of a plane on which bodies rest [m]; null: none.
 * Errors: KERF_INVALID_ARGUMENT for a number that is not finite. */
KERF_API kerf_result kerf_world_set_environment(kerf_world* world, const double gravity[3],
                                                const double* ground);

/* Simulates all bodies as rigid bodies, and the cooling of hot faces. Pieces that were cut off become bodies
 * (see kerf_detached). Time advances in ticks of 1/120 s; the rest of `seconds` is kept for the next call.
 * Consecutive calls form one step of the history.
 * seconds: 0 to 3600.
 * options: may be null; the call cannot be cancelled.
 * Errors: KERF_INVALID_ARGUMENT for another number. */
KERF_API kerf_result kerf_world_simulate(kerf_world* world, double seconds, const kerf_call_options* options);

/* Pose of the beam at a time. */
typedef struct kerf_keyframe {
  double time;         /* s, >= the time of the previous keyframe */
  double origin[3];    /* m */
  double direction[3]; /* of any non-zero length, not opposite to the direction of the previous keyframe */
} kerf_keyframe;

typedef enum kerf_rim { KERF_RIM_FACES = 0, KERF_RIM_SMOOTH = 1 } kerf_rim;
typedef enum kerf_scheme { KERF_SCHEME_LONGEST_EDGE = 0, KERF_SCHEME_ONE_TO_FOUR = 1 } kerf_scheme;
typedef enum kerf_model { KERF_MODEL_GEOMETRIC = 0, KERF_MODEL_THERMAL = 1 } kerf_model;
typedef enum kerf_assist { KERF_ASSIST_NONE = 0, KERF_ASSIST_OXYGEN = 1 } kerf_assist;
/* The member of kerf_cut_settings that sets the resolution under the beam. */
typedef enum kerf_resolution {
  KERF_RESOLUTION_DEFAULT = 0, /* none: edges of a quarter of the radius, of the radius if thermal */
  KERF_RESOLUTION_EDGE = 1,    /* target_edge */
  KERF_RESOLUTION_TOLERANCE = 2,
  KERF_RESOLUTION_LEVEL = 3 /* max_level */
} kerf_resolution;

/* A stroke of the laser: between keyframes the origin moves along a straight line and the direction along
 * the shorter arc. With one keyframe the beam stands still. */
typedef struct kerf_stroke {
  size_t size;
  const kerf_keyframe* keys;
  size_t key_count; /* at least 1 */
  double radius;    /* m; 0: 1/400 of the diagonal of the bounding box of all meshes as they were added */
  double range[2];  /* m along the beam, 0 <= min <= max; both 0: from 0 to ten diagonals */
  /* Of the thermal model; the geometric model ignores them. */
  double power;       /* W, >= 0 */
  double wavelength;  /* m; 0: that of the usual laser for the material */
  double focus;       /* m along the beam to its waist, > 0; INFINITY: the radius is constant */
  double pulse_rate;  /* Hz; 0: a continuous beam */
  double duty;        /* share of each pulse period with the beam on, 0 < duty <= 1 */
  kerf_assist assist; /* gas */
  int reserved;       /* 0 */
} kerf_stroke;
#define KERF_STROKE_INIT \
  { sizeof(kerf_stroke), NULL, 0, 0, {0, 0}, 2000, 0, HUGE_VAL, 0, 1, KERF_ASSIST_NONE, 0 }

/* Settings of a cut. The defaults, or a null pointer instead, equal `kerf cut` without options, except that a
 * solid is cut only with KERF_RIM_SMOOTH. */
typedef struct kerf_cut_settings {
  size_t size;
  kerf_rim rim;       /* FACES removes every face the beam touches; SMOOTH cuts faces along the beam */
  kerf_scheme scheme; /* subdivision of faces */
  kerf_model model;   /* GEOMETRIC removes faces at once; THERMAL when they have absorbed enough energy */
  kerf_resolution resolution; /* which of the next three members is used */
  double target_edge;         /* longest edge [m], > 0 */
  double tolerance;           /* overshoot of the removed area beyond the beam [m], > 0 */
  int max_level;              /* maximum refinement level, 0 to 24; 0: no refinement */
  int reserved;               /* 0 */
  const char* material;       /* new material of all bodies, a name from `kerf materials`; null: unchanged */
  const kerf_body* bodies;    /* the only bodies to cut; null: all visible ones */
  size_t body_count;
} kerf_cut_settings;
#define KERF_CUT_SETTINGS_INIT                                                                 \
  {                                                                                            \
    sizeof(kerf_cut_settings), KERF_RIM_FACES, KERF_SCHEME_LONGEST_EDGE, KERF_MODEL_GEOMETRIC, \
        KERF_RESOLUTION_DEFAULT, 0, 0, 0, 0, NULL, NULL, 0                                     \
  }

/* Results of a cut. */
typedef struct kerf_cut_result {
  size_t size;
  size_t removed_faces;
  double removed_area; /* m^2 */
  double seconds;      /* duration */
  /* Of the thermal model, else 0. */
  double emitted;  /* energy of the beam [J] */
  double absorbed; /* part of it that faces absorbed [J] */
  double depth;    /* mean while the beam hits a face: share of its energy of removal; 1: cut through */
} kerf_cut_result;
#define KERF_CUT_RESULT_INIT \
  { sizeof(kerf_cut_result), 0, 0, 0, 0, 0, 0 }

/* Cuts all visible bodies, or those of `settings`, with strokes, in order, all or nothing. Each stroke is a
 * step of the history; a new `material` adds one step per changed piece. A solid that cannot be closed stays
 * open without an error: kerf_mesh_info::is_closed is 0, and the notes of kerf_world_report state why and
 * where.
 * strokes: stroke_count strokes; may be null if there is none.
 * settings, options: may be null.
 * result: receives the results; may be null.
 * Errors: KERF_INVALID_ARGUMENT for an invalid stroke or setting, if the world has no mesh, or if one of the
 * bodies is solid and the rim is not smooth or the model is thermal; KERF_FAILED if a body would exceed the
 * maximum number of faces, or the world the memory; KERF_CANCELLED. About 1 us per created or removed face.
 */
KERF_API kerf_result kerf_world_cut(kerf_world* world, const kerf_stroke* strokes, size_t stroke_count,
                                    const kerf_cut_settings* settings, const kerf_call_options* options,
                                    kerf_cut_result* result);

/* Cuts all visible bodies along the plane normal . x = distance by a knife of no width; nothing is removed,
 * both sides become pieces of their own, and those of solids are closed by walls. A solid whose section is
 * not closed stays open without an error (see kerf_mesh_info::is_closed). A step of the history.
 * normal: finite and not zero, of any length.
 * Errors: KERF_INVALID_ARGUMENT for an invalid plane; KERF_FAILED if a body would exceed the maximum number
 * of faces; KERF_CANCELLED. O(faces). */
KERF_API kerf_result kerf_world_cut_plane(kerf_world* world, const double normal[3], double distance,
                                          const kerf_call_options* options);

/* Strokes in steps
 *
 * A stroke that is cut while the program draws frames: kerf_stroke_begin, kerf_stroke_add_pose as the beam
 * moves, kerf_stroke_step in each frame, kerf_stroke_end, and steps until the stroke is finished. However the
 * work is divided, the result equals that of kerf_world_cut for the same stroke, to the bit. Between steps
 * the world can be read: faces are removed already, pieces have their final labels when the stroke is
 * finished, and a solid is closed by then. Calls that change the world otherwise fail with KERF_BUSY until
 * the stroke is finished or cancelled. */

/* Begins a stroke. Executes nothing yet.
 * stroke: its keys are the known part of the path, at least one.
 * settings: may be null; its material must be null.
 * Errors: those of kerf_world_cut; KERF_BUSY if another stroke is not finished. O(keys * bodies), and
 * O(faces) for the first cut of a world. */
KERF_API kerf_result kerf_stroke_begin(kerf_world* world, const kerf_stroke* stroke,
                                       const kerf_cut_settings* settings);

/* Appends a pose to the path of the stroke. Executes nothing yet.
 * key: as in kerf_stroke; its time counts from the same zero as those before it.
 * Errors: KERF_INVALID_ARGUMENT for an invalid key, or if there is no stroke or it was ended. O(bodies). */
KERF_API kerf_result kerf_stroke_add_pose(kerf_world* world, const kerf_keyframe* key);

/* Ends the path of the stroke: switches the beam off. The rest of the work, with the rim and the walls of
 * solids, remains for kerf_stroke_step.
 * Errors: KERF_INVALID_ARGUMENT if there is no stroke or it was ended. O(1). */
KERF_API kerf_result kerf_stroke_end(kerf_world* world);

/* Progress of a stroke. */
typedef struct kerf_stroke_progress {
  size_t size;
  int is_idle;          /* 1 if all work known so far is done: add a pose or end the stroke */
  int is_finished;      /* 1 if the stroke was ended and all of it is done; the stroke no longer exists */
  size_t waiting;       /* number of parts of moves to execute, an estimate */
  size_t faces;         /* created and removed in this step */
  size_t removed_faces; /* since the stroke began */
  double removed_area;  /* m^2, likewise */
  double seconds;       /* duration of this step */
  double emitted, absorbed, depth; /* as in kerf_cut_result, since the stroke began */
} kerf_stroke_progress;
#define KERF_STROKE_PROGRESS_INIT \
  { sizeof(kerf_stroke_progress), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/* Executes a part of the stroke: at least one unit of work, and more until a budget is used up. A unit is a
 * query, about 250 faces, a part of the search for pieces, or a part of the walls: mostly below 0.4 ms. With
 * the thermal model a unit is one to four parts of the path, each about a beam radius long at most.
 * max_faces: target for the number of faces created and removed; SIZE_MAX: no limit.
 * max_seconds: target for the duration [s], >= 0; INFINITY: no limit.
 * progress: receives the progress; may be null.
 * Errors: KERF_INVALID_ARGUMENT for an invalid number, or if there is no stroke; KERF_FAILED if the cut would
 * exceed the maximum number of faces: the stroke is then cancelled. */
KERF_API kerf_result kerf_stroke_step(kerf_world* world, size_t max_faces, double max_seconds,
                                      kerf_stroke_progress* progress);

/* Cancels the stroke: restores the world as it was before kerf_stroke_begin, to the bit. Walls that a step
 * left incomplete are finished first. Steps that were undone before the stroke can no longer be redone.
 * Errors: KERF_INVALID_ARGUMENT if there is no stroke. Cost: proportional to what the stroke changed. */
KERF_API kerf_result kerf_stroke_cancel(kerf_world* world);

/* -- Undo -- */

/* Undo the last step of the history, or redo the step undone last: a stroke, a plane cut, an added body, an
 * edit of a piece, a joint, the environment, or consecutive simulation. The world is restored to the bit.
 * done: receives 1, or 0 if there is nothing to undo or redo; may be null.
 * Errors: KERF_FAILED if the step is no longer stored (see kerf_world_set_undo_memory). O(changes). */
KERF_API kerf_result kerf_world_undo(kerf_world* world, int* done);
KERF_API kerf_result kerf_world_redo(kerf_world* world, int* done);

/* Limits the memory for undo, 256 MiB by default; the oldest steps are discarded first. 0: none. */
KERF_API kerf_result kerf_world_set_undo_memory(kerf_world* world, size_t bytes);

/* -- Pieces and faces -- */

/* Returns the pieces of all bodies as meshes in world coordinates, largest area first.
 * out: receives an array of *count meshes; free it with kerf_pieces_free. To keep a mesh, set its entry to
 *   null and destroy it with kerf_mesh_destroy.
 * O(n log n). */
KERF_API kerf_result kerf_world_pieces(const kerf_world* world, const kerf_call_options* options,
                                       kerf_mesh*** out, size_t* count);

/* Frees an array of pieces and its meshes. No-op if `pieces` is null. */
KERF_API void kerf_pieces_free(kerf_mesh** pieces, size_t count);

/* Writes the ids of all bodies, in the order of their creation.
 * out: receives at most `capacity` ids; may be null if capacity is 0.
 * count: receives the number of all bodies. O(bodies). */
KERF_API kerf_result kerf_world_bodies(const kerf_world* world, kerf_body* out, size_t capacity,
                                       size_t* count);

/* Writes the indices of the faces of a body, ascending.
 * out: receives at most `capacity` indices; may be null if capacity is 0.
 * count: receives the number of all faces.
 * Errors: KERF_INVALID_ARGUMENT if there is no such body. O(faces). */
KERF_API kerf_result kerf_body_faces(const kerf_world* world, kerf_body body, uint32_t* out, size_t capacity,
                                     size_t* count);

/* Writes data of faces of a body, as for a vertex buffer.
 * faces: n indices of faces that exist.
 * corners: receives three positions a face, counter-clockwise seen from outside [m, in the frame of the
 *   body]: 9 n numbers.
 * pieces: receives n labels.
 * materials: receives n indices of materials of the mesh.
 * is_cut: receives n numbers, 1 for a wall that a cut made in a solid, else 0.
 * The last four may be null.
 * Errors: KERF_INVALID_ARGUMENT if there is no such body or face. About 10 ns per face. */
KERF_API kerf_result kerf_body_get_faces(const kerf_world* world, kerf_body body, const uint32_t* faces,
                                         size_t n, double* corners, uint32_t* pieces, uint16_t* materials,
                                         uint8_t* is_cut);

/* -- Changes -- */

/* Flags of kerf_body_changes. */
#define KERF_BODY_CREATED 1u    /* new; all faces are listed as added */
#define KERF_BODY_DESTROYED 2u  /* no longer exists; no faces are listed */
#define KERF_BODY_MOVED 4u      /* position or orientation */
#define KERF_BODY_PROPERTIES 8u /* name, mass, solidity, or whether it is fixed */
#define KERF_BODY_VISIBILITY 16u

/* A piece that was cut off. */
typedef struct kerf_new_piece {
  uint32_t piece; /* its label */
  uint32_t from;  /* that of the piece it was cut off from; KERF_NO_PIECE if unknown */
} kerf_new_piece;

/* Changes of a body. Faces ascend; each is in at most one list. */
typedef struct kerf_body_changes {
  kerf_body body;
  uint32_t flags; /* KERF_BODY_... */
  uint32_t reserved;
  size_t added_count;
  const uint32_t* added; /* faces that are new or have other corners */
  const uint32_t* added_pieces;
  size_t removed_count;
  const uint32_t* removed; /* faces that no longer exist; some may be unknown to the client */
  size_t moved_count;
  const uint32_t* moved; /* other faces whose piece changed */
  const uint32_t* moved_pieces;
  size_t new_piece_count;
  const kerf_new_piece* new_pieces; /* labels that have faces now and had none */
  size_t destroyed_piece_count;
  const uint32_t* destroyed_pieces; /* labels that had faces and have none now */
} kerf_body_changes;

/* A piece that moved to another body, e.g. because it began to fall or was edited; not listed if that body
 * was removed since, unless a listed piece left it before. The side with fewer faces, the piece or the rest,
 * is copied to a body listed as created: `to` or, if keeps_faces is 1, `from`. Its face i is the i-th face of
 * that side by previous index. The other side keeps its indices. */
typedef struct kerf_detached {
  kerf_body from, to;
  uint32_t piece;       /* the label, in both */
  uint32_t keeps_faces; /* 1: the piece is the larger side, so faces of `from` are now those of `to`, by the
                          same indices; 0: they remain those of `from` */
} kerf_detached;

/* Changes of a world. A client that mirrors it applies: destroyed bodies; then `detached` in order, by moving
 * the mirror of `from`, if it has one, to `to` where keeps_faces is 1; then the other bodies, replacing
 * created ones, first removed faces, then added ones. */
typedef struct kerf_changes {
  size_t size;
  int everything; /* 1: any part of the world may have changed, and the lists are empty: read it again */
  int reserved;
  size_t body_count;
  const kerf_body_changes* bodies; /* destroyed ones first */
  size_t detached_count;
  const kerf_detached* detached;
} kerf_changes;
#define KERF_CHANGES_INIT \
  { sizeof(kerf_changes), 0, 0, 0, NULL, 0, NULL }

/* Returns all changes since the last call for this world. The first call sets `everything`, as does a call
 * after a failed cut or stroke step, or after more changes than the log holds. May be called between steps of
 * a stroke.
 * out: its size is set; its arrays are valid until the next kerf_world_take_changes or kerf_world_destroy.
 * About 60 ns per changed face, whatever the size of the world, plus the pieces of changed bodies. */
KERF_API kerf_result kerf_world_take_changes(kerf_world* world, kerf_changes* out);

/* -- Hits -- */

/* Points on faces of visible bodies: `count` in each array, 3 numbers per vector. Initialise with
 * KERF_HITS_INIT. A query overwrites the struct without freeing it: call kerf_hits_free before reusing it. */
typedef struct kerf_hits {
  size_t size;
  void* owner; /* internal */
  size_t count;
  size_t offset_count;        /* n + 1 for kerf_world_all_hits, else 0 */
  const size_t* offsets;      /* entries offsets[i] to offsets[i + 1] - 1 belong to ray i */
  const double* distances;    /* from the origin of the ray, or the point [m]; infinity on a miss */
  const kerf_body* bodies;    /* KERF_NO_BODY on a miss */
  const uint32_t* faces;      /* KERF_NO_FACE on a miss; the other members are 0 then */
  const uint32_t* pieces;     /* labels in the body */
  const double* barycentrics; /* of the point, one per corner; corners as in kerf_body_get_faces */
  const double* positions;    /* of the point in the world [m] */
  const double* normals;      /* of the face in the world, unit length, outward; 0 if its area is 0 */
  const uint16_t* materials;  /* index of the material of the mesh */
  const uint8_t* is_cut;      /* 1 for a wall that a cut made in a solid */
} kerf_hits;
#define KERF_HITS_INIT \
  { sizeof(kerf_hits), NULL, 0, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL }

/* Finds the first surface that each of n rays crosses.
 * origins, directions: n vectors each; finite, directions of any non-zero length.
 * range: minimum and maximum distance (m); null: 0 to infinity.
 * out: its size is set; receives n entries.
 * Errors: KERF_INVALID_ARGUMENT for a vector or range that violates the above. About 0.4 us per ray that
 * meets one body; O(bodies). */
KERF_API kerf_result kerf_world_nearest_hits(const kerf_world* world, const double* origins,
                                             const double* directions, size_t n, const double range[2],
                                             const kerf_call_options* options, kerf_hits* out);

/* Finds all surfaces that each of n rays crosses, nearest first. Arguments, errors and cost per crossing are
 * those of kerf_world_nearest_hits, but `out` receives an entry per crossing, none on a miss; `offsets`
 * divides them by ray. */
KERF_API kerf_result kerf_world_all_hits(const kerf_world* world, const double* origins,
                                         const double* directions, size_t n, const double range[2],
                                         const kerf_call_options* options, kerf_hits* out);

/* Finds the point of all surfaces nearest to each of n points.
 * points: n positions in the world (m), finite.
 * max_distance: m, >= 0; INFINITY: no limit.
 * out: its size is set; receives n entries, misses beyond max_distance.
 * Errors: KERF_INVALID_ARGUMENT for a number that violates the above. About 2 us per point and body. */
KERF_API kerf_result kerf_world_closest_points(const kerf_world* world, const double* points, size_t n,
                                               double max_distance, const kerf_call_options* options,
                                               kerf_hits* out);

/* Finds the faces that a box meets, also by touching it. Each has the point nearest to the centre of the box,
 * and the distance from it. Sorted by body, then by face.
 * min, max: corners in the world (m), -1e150 <= min <= max <= 1e150.
 * out: its size is set; receives an entry per face.
 * Errors: KERF_INVALID_ARGUMENT for other numbers. About 0.5 us per face in the circumscribed sphere. */
KERF_API kerf_result kerf_world_faces_in_box(const kerf_world* world, const double min[3],
                                             const double max[3], const kerf_call_options* options,
                                             kerf_hits* out);

/* Frees hits and resets all members but the size. No-op if `hits` is null or was never filled. */
KERF_API void kerf_hits_free(kerf_hits* hits);

/* Writes the visible bodies with their poses as a scene that the editor opens: scene.json and one OBJ file
 * per body, or a Kerf mesh (.kmesh) if it has attributes or described materials, which are kept with their
 * images. Does not write temperatures, joints, motion, the environment, whether bodies are fixed, and the
 * names of pieces that share a body.
 * folder: created if missing; files of these names in it are replaced. The previous scene is kept as
 *   scene.json~.
 * Errors: KERF_INVALID_ARGUMENT if no face is visible, KERF_FAILED if a file cannot be written.
 * O(n log n). */
KERF_API kerf_result kerf_world_save_scene(const kerf_world* world, const char* folder);

/* Writes the journal of the world, which the editor opens and `kerf replay` verifies: all commands that are
 * not undone, and next to it a mesh file per body added by kerf_world_add, NAME-mesh-0001.obj and so on, or
 * .kmesh if it has attributes or described materials.
 * path: a .kerf file. The previous one is kept with a ~ after its name.
 * Errors: KERF_INVALID_ARGUMENT if the world has no mesh or was simulated before it had one, or if path names
 * a folder, device or pipe; KERF_FAILED if a file cannot be written. O(n log n). */
KERF_API kerf_result kerf_world_save_journal(const kerf_world* world, const char* path);

/* Returns a report as JSON, like report.json of `kerf cut`: all pieces, and the totals of kerf_world_cut and
 * of strokes in steps. Omits plane cuts and the cuts of an opened file. "file" is the name of the piece.
 * out: receives the text; free it with kerf_text_free. O(n log n). */
KERF_API kerf_result kerf_world_report(const kerf_world* world, const kerf_call_options* options, char** out);

/* Returns the hash of the state, equal to that of `kerf cut` for the same meshes and strokes.
 * out: receives 16 hexadecimal digits and a terminating zero. O(n). */
KERF_API kerf_result kerf_world_hash(const kerf_world* world, char out[17]);

/* Returns the component graph of the faces as JSON, as written by `kerf inspect --graph`.
 * out: receives the text; free it with kerf_text_free. O(n). */
KERF_API kerf_result kerf_world_graph(const kerf_world* world, char** out);

/* Frees a text or bytes. No-op if `text` is null. */
KERF_API void kerf_text_free(char* text);

#ifdef __cplusplus
}
#endif

#endif
