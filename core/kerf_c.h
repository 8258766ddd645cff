#ifndef KERF_KERF_C_H
#define KERF_KERF_C_H

/*
 * Kerf as a C library: load or make meshes, cut them with a laser, take the pieces out as arrays, shoot rays.
 *
 * Units are SI: metres, seconds, watts, kilograms. Frames are right-handed; faces are counter-clockwise seen
 * from outside. An array of n points or directions holds 3 n numbers, x y z of one after the other.
 *
 * Every function that can fail returns a kerf_result; kerf_message() then has one sentence that says what was
 * wrong, where, and what to do. A call that fails changes nothing. No exception leaves the library, and no
 * argument ends the process, except for pointers to memory that is not there. Results have the same bits on
 * every x86-64 processor and do not depend on the number of threads, nor on the locale or on the rounding and
 * flush-to-zero modes of the caller, which are put back on return.
 *
 * Functions may be called from several threads at the same time. Those that take a `const kerf_world*` only
 * read the world, and any number of them may use one world at once. One that changes a world fails with
 * KERF_BUSY while another call uses it, and so does every other call until the change is done. A mesh never
 * changes and may be shared.
 */

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
  KERF_FAILED = 1,    /* it could not be done: a full disk, too little memory */
  KERF_BAD_INPUT = 2, /* an argument or a file is wrong */
  KERF_CANCELLED = 3, /* the caller's progress function asked for it */
  KERF_BUSY = 4       /* another call changes the world, or uses one that this call would change */
} kerf_result;

/* The version of the library, "0.1.0". */
KERF_API const char* kerf_version(void);

/* The sentence of the last call in this thread that failed; empty if none has. Valid until the next call in
 * this thread that fails. */
KERF_API const char* kerf_message(void);

/* Called on the thread of the caller, some hundred times in a long call, with the share of the work that is
 * done, 0 to 1. If it returns anything but 0, the call ends with KERF_CANCELLED. It must not throw. Calls
 * that it makes with the same world fail with KERF_BUSY, except for queries within a query. */
typedef int (*kerf_progress)(double share, void* user);

/* How a call runs. All zero, or a null pointer in its place, is the default. */
typedef struct kerf_control {
  kerf_progress progress; /* or null */
  void* user;             /* handed to `progress` */
  unsigned threads;       /* at most so many, at most 1024; 0: as many as there are processors */
} kerf_control;

/* Meshes
 * ------------------------------------------------------------------------------------------------------ */

/* A triangle mesh, or a piece of one, which never changes. */
typedef struct kerf_mesh kerf_mesh;

/* Reads an OBJ, PLY, STL, OFF or glTF file; its bytes decide which. Equal positions are welded, faces with an
 * index that is not there, a position that is not finite, or two corners at one position are left out. Free
 * the mesh with kerf_mesh_free. Linear in the size of the file. */
KERF_API kerf_result kerf_mesh_read(const char* path, const kerf_control* control, kerf_mesh** out);

/* Makes a mesh of `vertex_count` positions (m) and `face_count` triples of indices of them. Both arrays are
 * copied. Bad input: no vertex, no face, a position that is not finite, an index out of range, more than 2^31
 * of either. Exact duplicates of positions are welded when the mesh is added to a world. O(n). */
KERF_API kerf_result kerf_mesh_make(const double* vertices, size_t vertex_count, const uint32_t* faces,
                                    size_t face_count, kerf_mesh** out);

/* Frees a mesh, or does nothing with a null pointer. */
KERF_API void kerf_mesh_free(kerf_mesh* mesh);

/* Writes a mesh; the ending of the path says the format: .obj, .ply, .stl, .off, .glb or .gltf. The file is
 * written whole or not at all. */
KERF_API kerf_result kerf_mesh_write(const kerf_mesh* mesh, const char* path);

KERF_API size_t kerf_mesh_vertex_count(const kerf_mesh* mesh);
KERF_API size_t kerf_mesh_face_count(const kerf_mesh* mesh);
/* 3 doubles a vertex (m), and 3 indices a face. They live as long as the mesh. */
KERF_API const double* kerf_mesh_vertices(const kerf_mesh* mesh);
KERF_API const uint32_t* kerf_mesh_faces(const kerf_mesh* mesh);

/* The temperatures of the faces (K) of a piece of a world, one a face; null for any other mesh. They live as
 * long as the mesh. */
KERF_API const double* kerf_mesh_temperatures(const kerf_mesh* mesh);

/* What is known of a mesh. Mass and what follows it are 0 for one that is no piece of a world. */
typedef struct kerf_mesh_info {
  const char* name;      /* of the piece; empty for a mesh that was read or made. Lives as long as the mesh */
  double area;           /* m^2 */
  double centroid[3];    /* of the area, or of the volume of a solid, m */
  size_t boundary_edges; /* edges with one face; 0 for a mesh that is no piece */
  double mass;           /* kg, as a sheet, or as a solid where its body is one and it is closed */
  double inertia[6];     /* kg m^2 about the centroid along the axes of the world: xx yy zz xy xz yz */
  double position[3];    /* of the body of the piece: x_world = orientation * x_body + position, m */
  double orientation[4]; /* w x y z; the vertices are in the world already */
} kerf_mesh_info;
KERF_API void kerf_mesh_describe(const kerf_mesh* mesh, kerf_mesh_info* info);

/* Worlds
 * ------------------------------------------------------------------------------------------------------ */

/* Meshes that a laser cuts, with their trees. */
typedef struct kerf_world kerf_world;

KERF_API kerf_result kerf_world_make(kerf_world** out);
/* Opens a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh. */
KERF_API kerf_result kerf_world_open(const char* path, const kerf_control* control, kerf_world** out);
/* Precondition: no call uses the world. Does nothing with a null pointer. */
KERF_API void kerf_world_free(kerf_world* world);

/* Adds a copy of a mesh as a body of its own, a sheet of 1 mm of mild steel. `name` is UTF-8; null: "mesh".
 * Builds its tree: O(n log n), about 0.5 us a face. */
KERF_API kerf_result kerf_world_add(kerf_world* world, const kerf_mesh* mesh, const char* name,
                                    const kerf_control* control);

/* A place of the beam at a time. */
typedef struct kerf_key {
  double time;         /* s, not less than that of the key before */
  double origin[3];    /* m */
  double direction[3]; /* of any length but 0, not opposite to that of the key before */
} kerf_key;

/* A stroke of the laser: between keys the origin moves on a straight line and the direction along the shorter
 * arc. One key is a beam that stands still. */
typedef struct kerf_stroke {
  const kerf_key* keys;
  size_t key_count;
  double radius;   /* m; 0: 1/400 of the diagonal of all meshes as they were added */
  double range[2]; /* m along the beam, 0 <= first <= second; both 0: from 0 to ten diagonals */
  double power;    /* W, for the thermal model; 0: 2000 */
} kerf_stroke;

typedef enum kerf_rim { KERF_RIM_FACES = 0, KERF_RIM_SMOOTH = 1 } kerf_rim;
typedef enum kerf_scheme { KERF_SCHEME_LONGEST_EDGE = 0, KERF_SCHEME_ONE_TO_FOUR = 1 } kerf_scheme;
typedef enum kerf_model { KERF_MODEL_GEOMETRIC = 0, KERF_MODEL_THERMAL = 1 } kerf_model;

/* How strokes cut; all zero, or a null pointer in its place, is what `kerf cut` does without options. */
typedef struct kerf_cut_settings {
  kerf_rim rim;       /* every face that the beam touches goes, or faces are cut along the beam */
  kerf_scheme scheme; /* how faces are split */
  kerf_model model;   /* faces go at once, or when they have taken the energy that they need */
  /* How fine faces get under the beam; one of the three, 0 for the others: the longest edge (m), how far what
   * goes may reach out of the beam (m), or levels plus one. All 0: edges of a quarter of the radius. */
  double target_edge, tolerance;
  int levels_plus_one;
  const char* material; /* of all bodies from now on, by its name in `kerf materials`; null: as they are */
} kerf_cut_settings;

/* What a cut did. */
typedef struct kerf_cut_result {
  size_t removed_faces;
  double removed_area; /* m^2 */
  double seconds;      /* that it took */
} kerf_cut_result;

/* Cuts all bodies with strokes, one after the other. `result` may be null. A cut that fails or is cancelled
 * leaves the world as it was. Bad input: a world to which no mesh was added. About 1 us for a face that is
 * made or removed. */
KERF_API kerf_result kerf_world_cut(kerf_world* world, const kerf_stroke* strokes, size_t stroke_count,
                                    const kerf_cut_settings* settings, const kerf_control* control,
                                    kerf_cut_result* result);

/* The pieces of all bodies, largest area first, as meshes in world coordinates: `*count` of them in `*out`,
 * an array that kerf_pieces_free frees with its meshes. A mesh that is to live longer is taken out by setting
 * its place to null. O(n log n). */
KERF_API kerf_result kerf_world_pieces(const kerf_world* world, const kerf_control* control, kerf_mesh*** out,
                                       size_t* count);
KERF_API void kerf_pieces_free(kerf_mesh** pieces, size_t count);

/* The first surface that each of n rays crosses within a range of lengths (m). `directions` may have any
 * length but 0. Each of the output arrays has n places and may be null: `distances` (m, infinity where
 * nothing is crossed), `bodies` (the number of the body in the order of adding) and `faces` (its slot there),
 * both 2^32 - 1 where nothing is. Bad input: numbers that are not finite. About 0.3 us a ray. */
KERF_API kerf_result kerf_world_nearest_hits(const kerf_world* world, const double* origins,
                                             const double* directions, size_t n, const double range[2],
                                             const kerf_control* control, double* distances, uint32_t* bodies,
                                             uint32_t* faces);

/* All surfaces that rays cross, nearest first: those of ray i are numbers first[i] to first[i + 1] - 1 of the
 * arrays. Free them with kerf_hits_free. */
typedef struct kerf_hits {
  size_t count;
  const size_t* first; /* n + 1 numbers */
  const double* distances;
  const uint32_t *bodies, *faces;
  void* owner;
} kerf_hits;
KERF_API kerf_result kerf_world_all_hits(const kerf_world* world, const double* origins,
                                         const double* directions, size_t n, const double range[2],
                                         const kerf_control* control, kerf_hits* out);
KERF_API void kerf_hits_free(kerf_hits* hits);

/* Writes the bodies as they are and where they are: an OBJ file for each and scene.json, which the editor
 * opens, in a folder, which is made if it is missing; files there of these names are replaced. Heat is not
 * written. O(n log n). */
KERF_API kerf_result kerf_world_save_scene(const kerf_world* world, const char* folder);

/* Writes the journal (.kerf) of the world, which the editor opens and `kerf replay` checks: the cuts since
 * the bodies were added, and a mesh file beside it, NAME-mesh-0001.obj and so on, for each body that was
 * added. Bad input where a body was added or the material was changed after a cut. O(n log n). */
KERF_API kerf_result kerf_world_save_journal(const kerf_world* world, const char* path);

/* The report of all cuts so far as JSON, with the keys of the report.json of `kerf cut`; "file" is the name
 * of the piece. Free it with kerf_text_free. O(n log n). */
KERF_API kerf_result kerf_world_report(const kerf_world* world, const kerf_control* control, char** out);

/* The hash of the state, sixteen hexadecimal digits and a zero; that of `kerf cut` for the same meshes and
 * strokes. O(n). */
KERF_API kerf_result kerf_world_hash(const kerf_world* world, char out[17]);

/* The component graph of the faces as JSON, as `kerf inspect --graph` writes it. Free it with kerf_text_free.
 */
KERF_API kerf_result kerf_world_graph(const kerf_world* world, char** out);
KERF_API void kerf_text_free(char* text);

#ifdef __cplusplus
}
#endif

#endif
