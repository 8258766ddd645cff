#ifndef KERF_KERF_C_H
#define KERF_KERF_C_H

/* Kerf as a C library: reads or creates triangle meshes, cuts them with a laser, returns the pieces as
 * arrays, and traces rays.
 *
 * Units are SI: metres, seconds, watts, kilograms, kelvin. Frames are right-handed with +Y up; faces are
 * counter-clockwise seen from outside. An array of n points or directions holds 3 n numbers: x, y, z of
 * each.
 *
 * Errors: a function that can fail returns a kerf_result; kerf_last_error() then returns one sentence that
 * says what failed, where, and what to do. A null pointer is KERF_INVALID_ARGUMENT unless stated otherwise.
 * A failed call changes nothing. No exception leaves the library, and no argument ends the process except
 * an invalid pointer.
 *
 * Determinism: results are bit-identical on every x86-64 processor. They do not depend on the number of
 * threads, the locale, or the caller's rounding and flush-to-zero modes, which are restored on return.
 *
 * Threads: all functions may be called from several threads at the same time. Any number of calls may read
 * one world (`const kerf_world*`). A call that changes a world (`kerf_world*`) needs exclusive access: it
 * fails with KERF_BUSY while another call uses the world, and until it returns, other calls on that world
 * fail with KERF_BUSY. A mesh is immutable and may be shared. */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define KERF_API __attribute__((visibility("default")))
#else
#define KERF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum kerf_result {
  KERF_OK = 0,
  KERF_FAILED = 1,           /* the operation failed: disk full, out of memory */
  KERF_INVALID_ARGUMENT = 2, /* an argument or a file is invalid */
  KERF_CANCELLED = 3,        /* the progress callback cancelled the call */
  KERF_BUSY = 4              /* another call uses the world; see Threads above */
} kerf_result;

/* Returns the version of the library, such as "0.1.0"; a static string. */
KERF_API const char* kerf_version(void);

/* Returns the message of the last failed call in this thread; empty if no call has failed. Valid until the
 * next failed call in this thread. */
KERF_API const char* kerf_last_error(void);

/* Progress callback, called on the caller's thread, from a few hundred to a few thousand times in a long
 * call. Must not throw. Calls on the same world fail with KERF_BUSY, except for queries within a query.
 * fraction: completed part of the work, 0 to 1.
 * user: kerf_call_options::user.
 * Returns 0 to continue; any other value ends the call with KERF_CANCELLED. */
typedef int (*kerf_progress)(double fraction, void* user);

/* Options of a call. All zero, or a null pointer instead, is the default. */
typedef struct kerf_call_options {
  kerf_progress progress; /* may be null */
  void* user;             /* passed to `progress` */
  unsigned threads;       /* maximum number of threads, 0 to 1024; 0: one per processor */
} kerf_call_options;

/* Meshes
 * ------------------------------------------------------------------------------------------------------ */

/* A triangle mesh, or a piece of one; immutable. */
typedef struct kerf_mesh kerf_mesh;

/* Reads a mesh file. Welds equal positions; drops faces with an index out of range, a non-finite
 * position, or two corners at the same position.
 * path: an OBJ, PLY, STL, OFF, glTF or 3MF file; the content decides the format.
 * options: may be null.
 * out: receives the mesh; destroy it with kerf_mesh_destroy.
 * Errors: KERF_INVALID_ARGUMENT if the file cannot be opened or parsed, or has no usable face.
 * O(file size). */
KERF_API kerf_result kerf_mesh_read(const char* path, const kerf_call_options* options, kerf_mesh** out);

/* Creates a mesh from arrays, which are copied. Equal positions are welded when the mesh is added to a
 * world.
 * vertices: vertex_count positions (m), finite.
 * vertex_count, face_count: 1 to 2^31.
 * faces: face_count triples of vertex indices, < vertex_count.
 * out: receives the mesh; destroy it with kerf_mesh_destroy.
 * Errors: KERF_INVALID_ARGUMENT if an array violates the above. O(n). */
KERF_API kerf_result kerf_mesh_create(const double* vertices, size_t vertex_count, const uint32_t* faces,
                                      size_t face_count, kerf_mesh** out);

/* Destroys a mesh. No-op if `mesh` is null. */
KERF_API void kerf_mesh_destroy(kerf_mesh* mesh);

/* Writes a mesh to a file atomically: a failed call leaves no partial file.
 * path: its extension decides the format: .obj, .ply, .stl, .off, .glb, .gltf or .3mf.
 * Errors: KERF_INVALID_ARGUMENT for another extension, KERF_FAILED if the file cannot be written. O(n). */
KERF_API kerf_result kerf_mesh_write(const kerf_mesh* mesh, const char* path);

/* Return the number of vertices or faces; 0 if `mesh` is null. O(1). */
KERF_API size_t kerf_mesh_vertex_count(const kerf_mesh* mesh);
KERF_API size_t kerf_mesh_face_count(const kerf_mesh* mesh);

/* Return the positions, 3 numbers per vertex (m), or the faces, 3 vertex indices each; null if `mesh` is
 * null. Valid while the mesh exists. O(1). */
KERF_API const double* kerf_mesh_vertices(const kerf_mesh* mesh);
KERF_API const uint32_t* kerf_mesh_faces(const kerf_mesh* mesh);

/* Returns the temperature of each face (K) of a piece of a world; null for any other mesh. Valid while the
 * mesh exists. O(1). */
KERF_API const double* kerf_mesh_face_temperatures(const kerf_mesh* mesh);

/* Attributes of a mesh: values at the corners of its faces, as read or interpolated by cuts. Names are as in
 * glTF: TEXCOORD_0 and so on (v = 0 is the top of an image), NORMAL, TANGENT, and _NAME for custom ones. */

/* Returns the number of attributes; 0 if `mesh` is null. O(1). */
KERF_API size_t kerf_mesh_attribute_count(const kerf_mesh* mesh);

/* Return the name of an attribute, valid while the mesh exists, or its numbers per corner, 1 to 4. Null or 0
 * if there is no such attribute. O(1). */
KERF_API const char* kerf_mesh_attribute_name(const kerf_mesh* mesh, size_t attribute);
KERF_API size_t kerf_mesh_attribute_size(const kerf_mesh* mesh, size_t attribute);

/* Copies an attribute.
 * values: receives its numbers for each of the three corners of each face; NaN if the face has none.
 * Errors: KERF_INVALID_ARGUMENT if there is no such attribute. O(n). */
KERF_API kerf_result kerf_mesh_get_attribute(const kerf_mesh* mesh, size_t attribute, float* values);

/* Returns the index of the material of each face; null if the mesh has no materials. Valid while the
 * mesh exists. O(1). */
KERF_API const uint16_t* kerf_mesh_face_materials(const kerf_mesh* mesh);

/* Returns the number of named materials; 0 if `mesh` is null. O(1). */
KERF_API size_t kerf_mesh_material_count(const kerf_mesh* mesh);

/* Returns the name of a material, which may be empty; null if there is no such material. Valid while
 * the mesh exists. O(1). */
KERF_API const char* kerf_mesh_material_name(const kerf_mesh* mesh, size_t material);

/* Properties of a mesh. Mass and inertia are 0 unless the mesh is a piece of a world. */
typedef struct kerf_mesh_info {
  const char* name;      /* name of the piece, else empty; valid while the mesh exists */
  double area;           /* m^2 */
  double centroid[3];    /* of the area, or of the volume of a solid [m] */
  size_t boundary_edges; /* number of edges with one face; 0 unless the mesh is a piece */
  double mass;           /* kg: of a solid if the body is solid and the piece is closed, else of a sheet */
  double inertia[6];     /* kg m^2 about the centroid in world axes: xx yy zz xy xz yz */
  double position[3];    /* of the body that owns the piece [m]: x_world = orientation * x_body + position */
  double orientation[4]; /* quaternion w x y z; the vertices are already in world coordinates */
} kerf_mesh_info;

/* Writes the properties of a mesh to `info`: zeros if `mesh` is null. No-op if `info` is null. O(1). */
KERF_API void kerf_mesh_get_info(const kerf_mesh* mesh, kerf_mesh_info* info);

/* Worlds
 * ------------------------------------------------------------------------------------------------------ */

/* The bodies that a laser cuts, with their AABB trees. */
typedef struct kerf_world kerf_world;

/* Creates an empty world.
 * out: receives the world; destroy it with kerf_world_destroy. O(1). */
KERF_API kerf_result kerf_world_create(kerf_world** out);

/* Creates a world from a file.
 * path: a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh.
 * options: may be null.
 * out: receives the world; destroy it with kerf_world_destroy.
 * Errors: KERF_INVALID_ARGUMENT for an invalid file. Cost: loading the meshes and replaying the cuts. */
KERF_API kerf_result kerf_world_open(const char* path, const kerf_call_options* options, kerf_world** out);

/* Destroys a world. No-op if `world` is null. Precondition: no other call uses the world. */
KERF_API void kerf_world_destroy(kerf_world* world);

/* Adds a copy of a mesh as a new body, a sheet of mild steel 1 mm thick, and builds its AABB tree.
 * name: UTF-8; "mesh" if null.
 * options: may be null.
 * Errors: KERF_INVALID_ARGUMENT if the name is not UTF-8. O(n log n), about 0.5 us per face. */
KERF_API kerf_result kerf_world_add(kerf_world* world, const kerf_mesh* mesh, const char* name,
                                    const kerf_call_options* options);

/* Pose of the beam at a time. */
typedef struct kerf_keyframe {
  double time;         /* s, >= the time of the previous keyframe */
  double origin[3];    /* m */
  double direction[3]; /* of any non-zero length, not opposite to the direction of the previous keyframe */
} kerf_keyframe;

/* A stroke of the laser: between keyframes the origin moves along a straight line and the direction along
 * the shorter arc. With one keyframe the beam stands still. */
typedef struct kerf_stroke {
  const kerf_keyframe* keys;
  size_t key_count; /* at least 1 */
  double radius;    /* m; 0: 1/400 of the diagonal of the bounding box of all meshes as they were added */
  double range[2];  /* m along the beam, 0 <= min <= max; both 0: from 0 to ten diagonals */
  double power;     /* W, for the thermal model; 0: 2000 */
} kerf_stroke;

typedef enum kerf_rim { KERF_RIM_FACES = 0, KERF_RIM_SMOOTH = 1 } kerf_rim;
typedef enum kerf_scheme { KERF_SCHEME_LONGEST_EDGE = 0, KERF_SCHEME_ONE_TO_FOUR = 1 } kerf_scheme;
typedef enum kerf_model { KERF_MODEL_GEOMETRIC = 0, KERF_MODEL_THERMAL = 1 } kerf_model;

/* Settings of a cut. All zero, or a null pointer instead, equals `kerf cut` without options. */
typedef struct kerf_cut_settings {
  kerf_rim rim;       /* FACES removes every face the beam touches; SMOOTH cuts faces along the beam */
  kerf_scheme scheme; /* subdivision of faces */
  kerf_model model;   /* GEOMETRIC removes faces at once; THERMAL when they have absorbed enough energy */
  /* Resolution under the beam. Set at most one of the three, 0 for the others; all 0: edges of a quarter of
   * the radius. */
  double target_edge;   /* longest edge [m] */
  double tolerance;     /* overshoot of the removed area beyond the beam [m] */
  int max_level;        /* maximum refinement level, 1 to 24; -1: no refinement */
  const char* material; /* new material of all bodies, a name from `kerf materials`; null: unchanged */
} kerf_cut_settings;

/* Results of a cut. */
typedef struct kerf_cut_result {
  size_t removed_faces;
  double removed_area; /* m^2 */
  double seconds;      /* duration */
} kerf_cut_result;

/* Cuts all bodies with strokes, in order, all or nothing.
 * strokes: stroke_count strokes; may be null if there is none.
 * settings, options: may be null.
 * result: receives the results; may be null.
 * Errors: KERF_INVALID_ARGUMENT for an invalid stroke or setting, or if the world has no mesh; KERF_FAILED
 * if a body would exceed the maximum number of faces; KERF_CANCELLED. About 1 us per created or removed
 * face. */
KERF_API kerf_result kerf_world_cut(kerf_world* world, const kerf_stroke* strokes, size_t stroke_count,
                                    const kerf_cut_settings* settings, const kerf_call_options* options,
                                    kerf_cut_result* result);

/* Returns the pieces of all bodies as meshes in world coordinates, largest area first.
 * options: may be null.
 * out: receives an array of *count meshes; free it with kerf_pieces_free. To keep a mesh, set its entry to
 *   null and destroy it with kerf_mesh_destroy.
 * O(n log n). */
KERF_API kerf_result kerf_world_pieces(const kerf_world* world, const kerf_call_options* options,
                                       kerf_mesh*** out, size_t* count);

/* Frees an array of pieces and its meshes. No-op if `pieces` is null. */
KERF_API void kerf_pieces_free(kerf_mesh** pieces, size_t count);

/* Finds the first surface that each of n rays crosses.
 * origins, directions: n vectors each; finite, directions of any non-zero length.
 * range: minimum and maximum distance (m); null: 0 to infinity.
 * options: may be null.
 * distances: receives n distances (m), infinity on a miss; may be null.
 * bodies: receives n body indices in the order of adding, 2^32 - 1 on a miss; may be null.
 * faces: receives n face indices in those bodies, 2^32 - 1 on a miss; may be null.
 * Errors: KERF_INVALID_ARGUMENT for a vector or range that violates the above. About 0.3 us per ray. */
KERF_API kerf_result kerf_world_nearest_hits(const kerf_world* world, const double* origins,
                                             const double* directions, size_t n, const double range[2],
                                             const kerf_call_options* options, double* distances,
                                             uint32_t* bodies, uint32_t* faces);

/* Crossings of n rays. Entries offsets[i] to offsets[i + 1] - 1 belong to ray i, nearest first. */
typedef struct kerf_hits {
  size_t count;
  const size_t* offsets;   /* n + 1 */
  const double* distances; /* count each; as in kerf_world_nearest_hits */
  const uint32_t* bodies;
  const uint32_t* faces;
  void* owner; /* internal */
} kerf_hits;

/* Finds all surfaces that each of n rays crosses. Other arguments, errors and cost per crossing are those of
 * kerf_world_nearest_hits.
 * out: receives the hits; free them with kerf_hits_free. */
KERF_API kerf_result kerf_world_all_hits(const kerf_world* world, const double* origins,
                                         const double* directions, size_t n, const double range[2],
                                         const kerf_call_options* options, kerf_hits* out);

/* Frees hits and resets `hits` to zero. No-op if `hits` is null. */
KERF_API void kerf_hits_free(kerf_hits* hits);

/* Writes the bodies with their poses as a scene that the editor opens: one OBJ file per body and
 * scene.json. Does not write temperatures.
 * folder: created if missing; files of these names in it are replaced.
 * Errors: KERF_INVALID_ARGUMENT if the world has no face, KERF_FAILED if a file cannot be written.
 * O(n log n). */
KERF_API kerf_result kerf_world_save_scene(const kerf_world* world, const char* folder);

/* Writes the journal of the world, which the editor opens and `kerf replay` verifies: the cuts since the
 * bodies were added, and next to it a mesh file per added body, NAME-mesh-0001.obj and so on.
 * path: a .kerf file.
 * Errors: KERF_INVALID_ARGUMENT if the world has no mesh, or a body was added or the material changed after
 * a cut; KERF_FAILED if a file cannot be written. O(n log n). */
KERF_API kerf_result kerf_world_save_journal(const kerf_world* world, const char* path);

/* Returns a report of all cuts as JSON, with the keys of report.json of `kerf cut`; "file" is the name of
 * the piece.
 * options: may be null.
 * out: receives the text; free it with kerf_text_free.
 * O(n log n). */
KERF_API kerf_result kerf_world_report(const kerf_world* world, const kerf_call_options* options, char** out);

/* Returns the hash of the state, equal to that of `kerf cut` for the same meshes and strokes.
 * out: receives 16 hexadecimal digits and a terminating zero.
 * O(n). */
KERF_API kerf_result kerf_world_hash(const kerf_world* world, char out[17]);

/* Returns the component graph of the faces as JSON, as written by `kerf inspect --graph`.
 * out: receives the text; free it with kerf_text_free.
 * O(n). */
KERF_API kerf_result kerf_world_graph(const kerf_world* world, char** out);

/* Frees a text. No-op if `text` is null. */
KERF_API void kerf_text_free(char* text);

#ifdef __cplusplus
}
#endif

#endif
